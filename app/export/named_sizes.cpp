// SPDX-License-Identifier: MIT
#include "app/export/named_sizes.h"

#include <algorithm>

namespace polhode {

const std::vector<NamedSize>& named_sizes() {
  static const std::vector<NamedSize> kSizes = {{"16:9", {1920, 1080}, 0},
                                                {"4k", {3840, 2160}, 0},
                                                {"4:3", {1440, 1080}, 0},
                                                {"a4", {3508, 2480}, 300}};
  return kSizes;
}

std::optional<NamedSize> named_size(std::string_view name) {
  const auto found = std::ranges::find(named_sizes(), name, &NamedSize::name);
  if (found == named_sizes().end()) return std::nullopt;
  return *found;
}

}  // namespace polhode
