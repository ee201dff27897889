// SPDX-License-Identifier: MIT
#include "base/suggest.h"

#include "base/near_name.h"

#include <algorithm>

namespace polhode {
namespace {

constexpr std::size_t kMaxListed = 32;

}  // namespace

std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& known) {
  std::string near = near_name(word, {known.begin(), known.end()});
  if (near.empty()) return std::nullopt;
  return near;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  if (known.empty()) return {};
  if (const auto nearest = nearest_name(word, known)) return "did you mean \"" + *nearest + "\"?";
  std::string list = known.size() == 1 ? "only " : "one of ";
  for (std::size_t i = 0; i < std::min(known.size(), kMaxListed); ++i) {
    if (i > 0) list += ", ";
    list += known[i];
  }
  if (known.size() > kMaxListed) list += ", …";
  return list;
}

}  // namespace polhode
