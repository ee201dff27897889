// SPDX-License-Identifier: MIT
// An image in memory: 8 bits a channel, sRGB values, straight (not premultiplied) alpha, top row first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace polhode {

struct Size {
  int width = 0;
  int height = 0;
  bool operator==(const Size&) const = default;
};

struct Image {
  Size size;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes, rows from the top

  static Image blank(Size size);
  const std::uint8_t* pixel(int x, int y) const {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                      static_cast<std::size_t>(x))];
  }
};

}  // namespace polhode
