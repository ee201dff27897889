// SPDX-License-Identifier: MIT
#include "render/image/image.h"

namespace polhode {

Image Image::blank(Size size) {
  return {size, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size.width) *
                                          static_cast<std::size_t>(size.height))};
}

}  // namespace polhode
