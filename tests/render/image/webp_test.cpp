// SPDX-License-Identifier: MIT
#include "render/image/webp.h"

#include "render/image/png.h"
#include "tests/render/image/pictures.h"

#include <gtest/gtest.h>
#include <webp/decode.h>

#include <cmath>

namespace polhode {
namespace {

Image decoded(const std::vector<std::uint8_t>& bytes) {
  Image image;
  std::uint8_t* pixels = WebPDecodeRGBA(bytes.data(), bytes.size(), &image.size.width, &image.size.height);
  if (!pixels) return image;
  image.rgba.assign(pixels, pixels + 4 * image.size.width * image.size.height);
  WebPFree(pixels);
  return image;
}

TEST(Webp, KeepsEveryPixel) {
  const Image image = test::scenic({320, 180}, true);
  const auto bytes = encode_webp(image);
  ASSERT_TRUE(bytes) << bytes.error();
  EXPECT_EQ(decoded(*bytes).size, image.size);
  EXPECT_EQ(decoded(*bytes).rgba, image.rgba);
}

TEST(Webp, KeepsTransparency) {
  const Image image = test::uniform({3, 2}, 200, 100, 50, 77);
  EXPECT_EQ(decoded(*encode_webp(image)).rgba, image.rgba);
}

TEST(Webp, RepeatsToTheByteAndIsSmallerThanPng) {
  const Image image = test::scenic({640, 360}, true);
  const auto bytes = encode_webp(image);
  EXPECT_EQ(*bytes, *encode_webp(image));
  EXPECT_LT(bytes->size(), encode_png(image, {})->size());
}

TEST(Webp, RefusesWhatTheFormatHasNot) {
  EXPECT_FALSE(encode_webp(Image{}));
  EXPECT_FALSE(encode_webp(test::uniform({kMaxWebpSide + 1, 1}, 0, 0, 0)));
  EXPECT_TRUE(encode_webp(test::uniform({kMaxWebpSide, 1}, 0, 0, 0)));
}

TEST(SmallWebp, LosesWhatNobodySees) {
  const Image image = test::scenic({640, 360}, false);
  const auto bytes = encode_small_webp(image);
  ASSERT_TRUE(bytes) << bytes.error();
  const Image shown = decoded(*bytes);
  ASSERT_EQ(shown.size, image.size);
  double squares = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const double off = static_cast<double>(shown.rgba[i]) - image.rgba[i];
    squares += off * off;
  }
  constexpr double kBarelySeen = 4;  // of 256 levels: 36 dB
  EXPECT_LT(std::sqrt(squares / static_cast<double>(image.rgba.size())), kBarelySeen);
  EXPECT_LT(2 * bytes->size(), encode_webp(image)->size());
  EXPECT_EQ(*bytes, *encode_small_webp(image));
}

}  // namespace
}  // namespace polhode
