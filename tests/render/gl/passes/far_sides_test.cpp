// SPDX-License-Identifier: MIT
#include "render/gl/passes/far_sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

constexpr int kPoints = 360;
const Vec3 kEye(4.0, 0.0, 0.0);

/// The unit sphere with a circle round it at a height, from the side that is turned to the eye.
DrawList sphere_with_circle(double z, bool closed) {
  DrawList list;
  list.ellipsoids.push_back({});
  Tube tube{.points = {}, .closed = closed, .radius = 0.01, .color = {0, 0, 0, 0.8F}};
  const double r = std::sqrt(1.0 - z * z);
  for (int i = 0; i < kPoints + (closed ? 0 : 1); ++i) {
    const double a = 2.0 * std::numbers::pi * i / kPoints;
    tube.points.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  list.tubes.push_back(tube);
  return list;
}

double length_of(const Tube& tube) {
  double length = 0.0;
  for (std::size_t i = 1; i < tube.points.size(); ++i) length += (tube.points[i] - tube.points[i - 1]).norm();
  return length;
}

TEST(FarSides, AreFaintAndThinBeyondTheOutline) {
  for (const bool closed : {true, false}) {
    double near = 0.0, far = 0.0;
    for (const Tube& part : with_faint_far_sides(sphere_with_circle(0.0, closed), kEye)) {
      EXPECT_FALSE(part.closed);
      const bool is_far = part.color.a < 0.8F;
      EXPECT_EQ(is_far, part.radius < 0.01);
      (is_far ? far : near) += length_of(part);
      // Rays from the eye touch the unit sphere in the plane x = 1/4; a chord cuts it off its arc.
      const double off = 1.0 - std::cos(std::numbers::pi / kPoints);
      for (const Vec3& p : part.points) EXPECT_TRUE(is_far ? p.x() < 0.25 + off : p.x() > 0.25 - off);
    }
    const double chords = std::sin(std::numbers::pi / kPoints) / (std::numbers::pi / kPoints);
    EXPECT_NEAR(near + far, 2.0 * std::numbers::pi * chords, 1e-9) << "nothing is lost";
    EXPECT_NEAR(near, 2.0 * std::acos(0.25), 1e-3);
  }
}

TEST(FarSides, OfATrailFadeAsItDid) {
  DrawList list = sphere_with_circle(0.0, false);
  list.tubes[0].fade_start = 0.2;
  const std::vector<Tube> parts = with_faint_far_sides(list, kEye);
  ASSERT_EQ(parts.size(), 3u);
  const auto opacity = [](const Tube& part) { return static_cast<double>(part.color.a); };
  constexpr double kFloat = 1e-6;
  EXPECT_NEAR(opacity(parts[0]) * parts[0].fade_start, 0.8 * 0.2, kFloat);
  EXPECT_NEAR(opacity(parts[2]), 0.8, kFloat);
  EXPECT_NEAR(opacity(parts[1]) * parts[1].fade_start / opacity(parts[0]),
              opacity(parts[1]) / (opacity(parts[2]) * parts[2].fade_start), kFloat)
      << "fainter by the same factor at both ends";
  for (const Tube& part : parts) EXPECT_LT(part.fade_start, 1.0) << "a trail stays one";
}

TEST(FarSides, WhatIsOnOneSideIsNotCut) {
  DrawList list = sphere_with_circle(0.9, true);
  const std::vector<Tube> above = with_faint_far_sides(list, {0, 0, 4});
  ASSERT_EQ(above.size(), 1u);
  EXPECT_TRUE(above[0].closed);
  EXPECT_EQ(above[0].color.a, 0.8F);
  const std::vector<Tube> below = with_faint_far_sides(list, {0, 0, -4});
  ASSERT_EQ(below.size(), 1u);
  EXPECT_TRUE(below[0].closed);
  EXPECT_LT(below[0].color.a, 0.8F);
}

TEST(FarSides, WhatLiesOnNoGlassIsAsItWas) {
  DrawList list = sphere_with_circle(0.0, true);
  list.ellipsoids[0].semi_axes = Vec3(1.3, 1.0, 1.0);
  EXPECT_EQ(with_faint_far_sides(list, kEye).size(), 1u);
  list.ellipsoids.clear();
  EXPECT_EQ(with_faint_far_sides(list, kEye)[0].color.a, 0.8F);
}

}  // namespace
}  // namespace polhode
