// SPDX-License-Identifier: MIT
#include "app/window/screen/figure_marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace polhode {
namespace {

constexpr PixelBox kRoom{0, 0, 600, 400};
constexpr double kGap = 12;

PixelBox placed(const Vec2& at, const std::vector<PixelBox>& taken, std::size_t& place) {
  const Vec2 size(160, 20), corner = place_beside(at, kGap, size, kRoom, {.names = taken}, place);
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

// 2026-11-28: where nothing was clear, the words lay over the name of L rather than over a shaft.
TEST(FigureMarks, WordsAtATipLieOnAShaftRatherThanOnAName) {
  const TakenOnFigure taken{.names = {{0, 0, 600, 190}, {0, 212, 600, 400}, {0, 0, 290, 400}},
                            .bodies = {{0, 0, 600, 400}}};
  std::size_t place = 0;
  const Vec2 size(60, 18), corner = place_beside({300, 200}, kGap, size, kRoom, taken, place);
  const PixelBox words{corner.x(), corner.y(), corner.x() + size.x(), corner.y() + size.y()};
  for (const PixelBox& name : taken.names) EXPECT_EQ(words.overlap(name), 0);
}

TEST(FigureMarks, WhatHidesLeastIsTaken) {
  const std::vector<PixelBox> corners = {{500, 0, 600, 40}, {0, 0, 100, 40}, {0, 360, 100, 400}};
  EXPECT_EQ(clearest(corners, {}), 0u);
  EXPECT_EQ(clearest(corners, {.names = {{550, 10, 560, 20}}}), 1u);
  EXPECT_EQ(clearest(corners, {.names = {{550, 10, 560, 20}}, .bodies = {{0, 0, 100, 40}}}), 2u);
  EXPECT_EQ(clearest(corners, {.names = {{550, 10, 560, 20}}, .bodies = {{0, 0, 100, 400}}}), 1u)
      << "a body is hidden rather than a name";
}

// 2026-11-28: the ring at the tip of ω went through its letter.
TEST(FigureMarks, ARingCrossesNoLetter) {
  const Vec2 at(300, 200);
  const auto whole = ring_beside(at, 10, {});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_NEAR(whole.front().second - whole.front().first, 2 * std::acos(-1.0), 1e-9);
  const PixelBox name{305, 195, 330, 220};
  const auto arcs = ring_beside(at, 10, {name});
  ASSERT_FALSE(arcs.empty());
  double drawn = 0;
  for (const auto& [from, to] : arcs) {
    drawn += to - from;
    for (double angle = from + 0.04; angle < to - 0.03; angle += 0.01)
      EXPECT_FALSE(name.contains(at + 10 * Vec2(std::cos(angle), std::sin(angle)))) << angle;
  }
  EXPECT_GT(drawn, std::acos(-1.0)) << "most of it is there";
}

}  // namespace
}  // namespace polhode
