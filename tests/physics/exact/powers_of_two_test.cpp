// SPDX-License-Identifier: MIT
#include "physics/exact/powers_of_two.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

TEST(NormOf, IsTheNormToTheBitWhereThatIsInRange) {
  for (const Vec3& v : {Vec3(0.3, -1.7, 2.9), Vec3(1e100, 3e99, 0), Vec3(-1e-100, 2e-101, 3e-120)})
    EXPECT_EQ(norm_of(v), v.norm());
  EXPECT_EQ(norm_of(Vec3::Zero()), 0);
}

TEST(NormOf, ScalesToTheBitWhereSquaresLeaveTheRange) {
  const Vec3 v(0.3, -1.7, 2.9);
  for (const int e : {-1000, -600, 600, 1020})
    EXPECT_EQ(norm_of(times_two_to(e, v)), std::scalbn(v.norm(), e)) << e;
}

TEST(NormOf, OfWhatIsNotFiniteIsNotFinite) {
  EXPECT_TRUE(std::isnan(norm_of({1, std::numeric_limits<double>::quiet_NaN(), 2})));
  EXPECT_TRUE(std::isinf(norm_of({1, -std::numeric_limits<double>::infinity(), 2})));
}

}  // namespace
}  // namespace polhode
