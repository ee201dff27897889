// SPDX-License-Identifier: MIT
#include "render/drawing/polyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

std::vector<Vec2> wave(int points) {
  std::vector<Vec2> line;
  for (int i = 0; i < points; ++i) line.emplace_back(0.5 * i, 40.0 * std::sin(0.05 * i));
  return line;
}

double distance(const Vec2& p, const std::vector<Vec2>& line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 way = line[i] - line[i - 1];
    const double along = std::clamp((p - line[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - line[i - 1] - along * way).norm());
  }
  return least;
}

TEST(Simplified, StaysWithinTheToleranceWithFewerPoints) {
  const std::vector<Vec2> line = wave(1000);
  for (double tolerance : {0.05, 0.5, 5.0}) {
    const std::vector<Vec2> less = simplified(line, tolerance);
    EXPECT_LT(less.size(), line.size() / (tolerance < 0.1 ? 2 : 5)) << tolerance;
    EXPECT_EQ(less.front(), line.front());
    EXPECT_EQ(less.back(), line.back());
    for (const Vec2& p : line) EXPECT_LE(distance(p, less), tolerance);
  }
}

TEST(Simplified, KeepsCorners) {
  const std::vector<Vec2> zigzag = {{0, 0}, {1, 5}, {2, 0}, {3, 5}, {4, 0}};
  EXPECT_EQ(simplified(zigzag, 0.1), zigzag);
}

TEST(Simplified, AStraightLineHasTwoPoints) {
  EXPECT_EQ(simplified({{0, 0}, {1, 1}, {2, 2}, {7, 7}}, 0.1), (std::vector<Vec2>{{0, 0}, {7, 7}}));
}

TEST(Simplified, LeavesTheShortestAsTheyAre) {
  EXPECT_TRUE(simplified({}, 1).empty());
  EXPECT_EQ(simplified({{1, 2}}, 1).size(), 1u);
  EXPECT_EQ(simplified({{1, 2}, {1, 2}}, 1).size(), 2u);
  EXPECT_EQ(simplified({{1, 2}, {1, 2}, {1, 2}}, 1).size(), 2u) << "a closed line has its farthest point";
}

}  // namespace
}  // namespace polhode
