// SPDX-License-Identifier: MIT
#include "physics/geometry/curve_sampling.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;

Vec3 circle(double x) { return {std::cos(x), std::sin(x), 0}; }

TEST(DistanceToSegment, IsToTheNearestPointOfIt) {
  const Vec3 a(0, 0, 0), b(2, 0, 0);
  EXPECT_EQ(distance_to_segment({1, 3, 0}, a, b), 3);
  EXPECT_EQ(distance_to_segment({-4, 3, 0}, a, b), 5);
  EXPECT_EQ(distance_to_segment({2, 0, 7}, a, b), 7);
  EXPECT_EQ(distance_to_segment({3, 4, 0}, a, a), 5);
}

TEST(SampleCurve, HonoursTheToleranceWithFewPoints) {
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const auto points =
        sample_curve(circle, 0, std::numbers::pi, {.chord_tolerance = tolerance, .max_points = 100000});
    EXPECT_LE((points.front() - circle(0)).norm(), 0);
    EXPECT_LE((points.back() - circle(std::numbers::pi)).norm(), 0);
    double longest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      longest = std::max(longest, (points[i] - points[i - 1]).norm());
    EXPECT_LE(longest * longest / 8, tolerance);  // the sagitta of a chord of the unit circle, to first order
    const double fewest = std::numbers::pi / std::sqrt(8 * tolerance);
    EXPECT_LE(static_cast<double>(points.size()), 3 * fewest + 1);
  }
}

TEST(SampleCurve, StraightLinesTakeTwoPoints) {
  const auto line = [](double x) -> Vec3 { return Vec3(1, 2, 3) * x; };
  EXPECT_EQ(sample_curve(line, 0, 1, {.chord_tolerance = 1e-9, .max_points = 100}).size(), 2U);
}

TEST(SampleCurve, FirstPiecesAreKept) {
  const auto line = [](double x) -> Vec3 { return Vec3(1, 2, 3) * x; };
  EXPECT_EQ(sample_curve(line, 0, 1, {.chord_tolerance = 1, .first_pieces = 10, .max_points = 100}).size(),
            11U);
}

TEST(SampleCurve, StopsAtItsLimits) {
  EXPECT_LE(sample_curve(circle, 0, 6, {.chord_tolerance = 1e-300, .max_points = 1000}).size(), 1100U);
  EXPECT_EQ(
      sample_curve(circle, 0, 6, {.chord_tolerance = 1e-300, .max_halvings = 5, .max_points = 1000}).size(),
      33U);
}

TEST(SampleCurve, EndsBeforeWhatIsNotFinite) {
  const auto broken = [](double x) -> Vec3 {
    return x < 0.6 ? circle(x) : Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  };
  const auto points =
      sample_curve(broken, 0, 1, {.chord_tolerance = 1e-4, .first_pieces = 10, .max_points = 1000});
  ASSERT_FALSE(points.empty());
  for (const Vec3& p : points) EXPECT_TRUE(p.allFinite());
  EXPECT_NEAR(points.back()[1], std::sin(0.55), 0.06);
  EXPECT_TRUE(sample_curve(broken, 0.7, 1, {.chord_tolerance = 1e-4, .max_points = 10}).empty());
}

}  // namespace
}  // namespace polhode
