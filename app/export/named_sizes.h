// SPDX-License-Identifier: MIT
// Sizes of slides and paper by name.
#pragma once

#include "render/image/image.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct NamedSize {
  std::string name;
  Size size;
  int dpi;  ///< that goes with it; 0: none
};

/// 16:9 is 1920x1080, 4k 3840x2160, 4:3 1440x1080, and a4, the sheet on its side, 3508x2480 at 300 dpi.
const std::vector<NamedSize>& named_sizes();

std::optional<NamedSize> named_size(std::string_view name);

}  // namespace polhode
