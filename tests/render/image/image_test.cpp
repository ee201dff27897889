// SPDX-License-Identifier: MIT
#include "render/image/image.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

TEST(Image, BlankIsTransparentBlackOfItsSize) {
  const Image image = Image::blank({3, 2});
  EXPECT_EQ(image.rgba.size(), 4u * 3u * 2u);
  EXPECT_TRUE(std::all_of(image.rgba.begin(), image.rgba.end(), [](std::uint8_t v) { return v == 0; }));
}

TEST(Image, PixelCountsColumnsThenRowsFromTheTop) {
  Image image = Image::blank({3, 2});
  image.rgba[4 * (1 * 3 + 2) + 1] = 7;
  EXPECT_EQ(image.pixel(2, 1)[1], 7);
  EXPECT_EQ(image.pixel(0, 0), image.rgba.data());
}

TEST(Image, LargestSizeDoesNotOverflow) {
  const Image image{{16384, 16384}, std::vector<std::uint8_t>(1)};
  EXPECT_EQ(image.pixel(0, 0), image.rgba.data());
  EXPECT_EQ(4 * static_cast<std::size_t>(image.size.width) * static_cast<std::size_t>(image.size.height),
            std::size_t{1} << 30);
}

}  // namespace
}  // namespace polhode
