// SPDX-License-Identifier: MIT
#include "lessons/claims/claim.h"

#include <algorithm>
#include <array>

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

}  // namespace polhode
