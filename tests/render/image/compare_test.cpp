// SPDX-License-Identifier: MIT
#include "render/image/compare.h"

#include "tests/render/image/pictures.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

using test::uniform;

// 100 x 100: the rule allows 0.02 % of 10,000 pixels, which is exactly 2.
constexpr Size kSize{100, 100};
constexpr std::size_t kAllowed = 2;

Image grey() { return uniform(kSize, 100, 100, 100); }

// Changes one channel of the first `count` pixels.
Image changed(std::size_t count, int levels, std::size_t channel = 0) {
  Image image = grey();
  for (std::size_t i = 0; i < count; ++i)
    image.rgba[4 * i + channel] = static_cast<std::uint8_t>(image.rgba[4 * i + channel] + levels);
  return image;
}

TEST(Compare, EqualImagesAreEqual) {
  const Comparison found = compare_images(grey(), grey());
  EXPECT_TRUE(found.equal());
  EXPECT_EQ(found.pixels, 10000);
  EXPECT_EQ(found.over_3, 0);
  EXPECT_EQ(found.max, 0);
}

TEST(Compare, ThreeLevelsEverywherePassFourDoNot) {
  EXPECT_TRUE(compare_images(grey(), changed(10000, 3)).equal());
  EXPECT_EQ(compare_images(grey(), changed(10000, 3)).over_3, 0);
  const Comparison four = compare_images(grey(), changed(10000, 4));
  EXPECT_FALSE(four.equal());
  EXPECT_EQ(four.over_3, 10000);
  EXPECT_EQ(four.over_fraction(), 1.0);
}

TEST(Compare, CountAtTheLimitPassesOneMoreDoesNot) {
  EXPECT_TRUE(compare_images(grey(), changed(kAllowed, 48)).equal());
  const Comparison more = compare_images(grey(), changed(kAllowed + 1, 4));
  EXPECT_FALSE(more.equal());
  EXPECT_EQ(more.over_3, 3);
}

TEST(Compare, OnePixelOffBy48PassesBy49DoesNot) {
  EXPECT_TRUE(compare_images(grey(), changed(1, 48)).equal());
  const Comparison beyond = compare_images(grey(), changed(1, 49));
  EXPECT_FALSE(beyond.equal());
  EXPECT_EQ(beyond.max, 49);
}

TEST(Compare, EveryChannelCountsAndAlphaToo) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_EQ(compare_images(grey(), changed(5, 10, channel)).over_3, 5) << channel;
  EXPECT_EQ(compare_images(uniform(kSize, 1, 1, 1, 200), uniform(kSize, 1, 1, 1, 190)).over_3, 10000);
}

TEST(Compare, APixelCountsOnceHoweverManyChannelsDiffer) {
  const Comparison found = compare_images(uniform({1, 1}, 0, 0, 0, 0), uniform({1, 1}, 255, 200, 100, 50));
  EXPECT_EQ(found.over_3, 1);
  EXPECT_EQ(found.max, 255);
}

TEST(Compare, IsSymmetric) {
  const Image a = grey();
  const Image b = changed(7, 20);
  EXPECT_EQ(compare_images(a, b).over_3, compare_images(b, a).over_3);
  EXPECT_EQ(compare_images(a, b).max, compare_images(b, a).max);
}

TEST(Compare, OtherSizeIsNeverEqual) {
  const Comparison found = compare_images(uniform({4, 2}, 0, 0, 0), uniform({2, 4}, 0, 0, 0));
  EXPECT_FALSE(found.same_size);
  EXPECT_FALSE(found.equal());
}

TEST(DifferenceImage, EqualPixelsAreGreyOthersRedStrongerWhereLarger) {
  Image b = grey();
  b.rgba[4] += 1;
  b.rgba[8] += 60;
  const Image shown = difference_image(grey(), b);
  ASSERT_EQ(shown.size, kSize);
  const std::uint8_t* same = shown.pixel(0, 0);
  const std::uint8_t* slight = shown.pixel(1, 0);
  const std::uint8_t* strong = shown.pixel(2, 0);
  EXPECT_EQ(same[0], same[1]);
  EXPECT_GT(same[0], 190);
  EXPECT_EQ(slight[0], 255);
  EXPECT_LT(slight[1], 200);
  EXPECT_LT(strong[1], slight[1]);
  EXPECT_EQ(strong[1], 0);
  EXPECT_EQ(strong[3], 255);
}

TEST(DifferenceImage, WhereOnlyOneHasAPixelItIsRed) {
  const Image shown = difference_image(uniform({2, 1}, 9, 9, 9), uniform({1, 3}, 9, 9, 9));
  ASSERT_EQ(shown.size, (Size{2, 3}));
  EXPECT_EQ(shown.pixel(0, 0)[0], shown.pixel(0, 0)[1]);
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {0, 2}, {1, 2}}) {
    EXPECT_EQ(shown.pixel(x, y)[0], 255);
    EXPECT_EQ(shown.pixel(x, y)[1], 0);
  }
}

TEST(IsBlank, NeedsThreeColoursAndTwoPercentDrawn) {
  EXPECT_TRUE(is_blank(grey()));
  EXPECT_TRUE(is_blank(changed(5000, 9))) << "two colours";
  // 2 % of 10,000 pixels are 200.
  Image drawn = changed(200, 9);
  drawn.rgba[0] = 0;
  EXPECT_FALSE(is_blank(drawn));
  Image less = changed(199, 9);
  less.rgba[0] = 0;
  EXPECT_TRUE(is_blank(less));
  EXPECT_FALSE(is_blank(test::scenic(kSize, true)));
}

}  // namespace
}  // namespace polhode
