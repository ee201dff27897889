// SPDX-License-Identifier: MIT
#include "base/angles.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

TEST(AngleBetween, IsThatOfTheDirections) {
  EXPECT_EQ(angle_between(Vec3::UnitX(), 3 * Vec3::UnitX()), 0);
  // A few roundings each: of the products, of their sums, of the root and of the arc.
  EXPECT_NEAR(angle_between(Vec3::UnitX(), Vec3(0, 7, 0)), std::numbers::pi / 2, 4 * kEpsilon);
  EXPECT_NEAR(angle_between(Vec3(1, 2, 3), Vec3(-2, -4, -6)), std::numbers::pi, 4 * kEpsilon);
  EXPECT_NEAR(angle_between(Vec3(1, 1, 0), Vec3(0, 1, 1)), 60 * kRadiansPerDegree, 8 * kEpsilon);
}

TEST(AngleBetween, IsAsAccurateNearZeroAndNearAStraightAngle) {
  const double small = 1e-9;  // whose cosine is 1, rounded: an arc cosine would say 0
  EXPECT_NEAR(angle_between(Vec3::UnitX(), Vec3(1, small, 0)), small, 4 * kEpsilon * small);
  EXPECT_NEAR(angle_between(Vec3::UnitX(), Vec3(-1, small, 0)), std::numbers::pi - small, 4 * kEpsilon);
}

TEST(Degrees, AreReadBack) { EXPECT_NEAR(90 * kRadiansPerDegree * kDegreesPerRadian, 90, 90 * 2 * kEpsilon); }

}  // namespace
}  // namespace polhode
