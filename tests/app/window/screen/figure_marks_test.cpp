// SPDX-License-Identifier: MIT
#include "app/window/screen/figure_marks.h"

#include <gtest/gtest.h>

#include <vector>

namespace polhode {
namespace {

constexpr PixelBox kRoom{0, 0, 600, 400};
constexpr double kGap = 12;

PixelBox placed(const Vec2& at, const std::vector<PixelBox>& taken, std::size_t& place) {
  const Vec2 size(160, 20), corner = place_beside(at, kGap, size, kRoom, taken, place);
  return {corner.x(), corner.y(), corner.x() + size.x(), corner.y() + size.y()};
}

// 2026-11-28: the components of a held ω were written over its head and over names.
TEST(FigureMarks, WordsAtATipKeepClearOfItAndOfNames) {
  const std::vector<PixelBox> names = {{310, 170, 340, 195}, {150, 210, 290, 240}};
  for (const Vec2& tip : {Vec2(300, 200), Vec2(590, 10), Vec2(5, 395), Vec2(590, 395), Vec2(5, 5)}) {
    std::size_t place = 0;
    const PixelBox words = placed(tip, names, place);
    EXPECT_FALSE(words.contains(tip)) << tip.transpose();
    for (const PixelBox& name : names) EXPECT_EQ(words.overlap(name), 0) << tip.transpose();
    EXPECT_GE(words.x0, kRoom.x0);
    EXPECT_GE(words.y0, kRoom.y0);
    EXPECT_LE(words.x1, kRoom.x1);
    EXPECT_LE(words.y1, kRoom.y1);
  }
}

TEST(FigureMarks, WordsAtATipStayWhereTheyAreAsLongAsTheyAreClear) {
  std::size_t place = 0;
  const std::vector<PixelBox> name = {{310, 160, 480, 190}};
  const PixelBox aside = placed({300, 200}, name, place);
  const std::size_t found = place;
  EXPECT_NE(found, 0U);
  const PixelBox later = placed({301, 200}, {}, place);
  EXPECT_EQ(place, found) << "though the first place is free again";
  EXPECT_EQ(later.x0 - aside.x0, 1);
}

}  // namespace
}  // namespace polhode
