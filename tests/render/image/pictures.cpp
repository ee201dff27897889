// SPDX-License-Identifier: MIT
#include "tests/render/image/pictures.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace polhode::test {

Image uniform(Size size, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
  Image image = Image::blank(size);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t color[4] = {r, g, b, a};
    std::copy_n(color, 4, &image.rgba[i]);
  }
  return image;
}

Image scenic(Size size, bool opaque) {
  Image image = Image::blank(size);
  std::minstd_rand random(20261121);
  std::uint8_t* to = image.rgba.data();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x, to += 4) {
      const double u = static_cast<double>(x) / size.width;
      const double v = static_cast<double>(y) / size.height;
      const bool disc = std::hypot(u - 0.5, v - 0.5) < 0.3;
      const auto noise = static_cast<double>(random() % (disc ? 4 : 2));
      to[0] = static_cast<std::uint8_t>(90 + 120 * u + noise + (disc ? 20 * std::sin(40 * v) : 0.0));
      to[1] = static_cast<std::uint8_t>(110 + 110 * v + noise);
      to[2] = static_cast<std::uint8_t>(150 + 60 * u * v + noise);
      to[3] = opaque ? 255 : static_cast<std::uint8_t>(255 * v);
    }
  }
  return image;
}

}  // namespace polhode::test
