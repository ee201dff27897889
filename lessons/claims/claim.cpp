// SPDX-License-Identifier: MIT
#include "lessons/claims/claim.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace polhode {
namespace {

constexpr std::array<std::string_view, 8> kKindNames = {"identity", "definition", "law",      "motion",
                                                        "free",     "false",      "measured", "non-sequitur"};

}  // namespace

std::string_view name_of(ClaimKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::optional<ClaimKind> claim_kind_from(std::string_view name) {
  const auto found = std::find(kKindNames.begin(), kKindNames.end(), name);
  if (found == kKindNames.end()) return std::nullopt;
  return static_cast<ClaimKind>(found - kKindNames.begin());
}

std::vector<std::string> claim_kind_names() { return {kKindNames.begin(), kKindNames.end()}; }

std::string to_string(const Counterexample& counterexample) {
  return "at " + counterexample.state + " the left side is " + counterexample.left + ", the right side " +
         counterexample.right;
}

std::string numbers_as_tex(std::string_view text) {
  const auto is_of_number = [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.';
  };
  std::string tex;
  const auto take = [&](std::string_view sign, std::string_view as) {
    if (!text.starts_with(sign)) return false;
    tex += as;
    text.remove_prefix(sign.size());
    return true;
  };
  while (!text.empty()) {
    if (take("−", "-") || take("ε²", "\\varepsilon^2") || take("ε³", "\\varepsilon^3") ||
        take("ε", "\\varepsilon{}"))
      continue;
    std::size_t length = 0;
    if (take("√", "\\sqrt{")) {
      while (length < text.size() && is_of_number(text[length])) ++length;
      tex += std::string(text.substr(0, length)) + '}';
    } else if (text.size() > 1 && text[0] == 'e' && (text[1] == '+' || text[1] == '-')) {
      length = 2;
      while (length < text.size() && is_of_number(text[length])) ++length;
      std::string power(text.substr(2, length - 2));
      power.erase(0, std::min(power.find_first_not_of('0'), power.size() - 1));
      tex += "\\cdot10^{" + (text[1] == '-' ? '-' + power : power) + '}';
    } else {
      length = 1;
      tex += text[0];
    }
    text.remove_prefix(length);
  }
  return tex;
}

}  // namespace polhode
