// SPDX-License-Identifier: MIT
#include "physics/analysis/motion_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

TEST(MotionFacts, OfAFreeSymmetricBody) {
  const MotionFacts facts =
      motion_facts({PrincipalMoments(1, 1, 0.3), {Quat::Identity(), Vec3(0.8, 0, 2)}, {}});
  EXPECT_NEAR(facts.T, 0.5 * (0.64 + 0.3 * 4), kRounding);
  EXPECT_NEAR(facts.L, std::hypot(0.8, 0.6), kRounding);
  ASSERT_TRUE(facts.period_s && facts.free);
  EXPECT_NEAR(*facts.period_s, 2 * std::numbers::pi / (0.7 * 2), 16 * kRounding);
  EXPECT_NEAR(facts.free->in_body, -0.7 * 2, kRounding);
  EXPECT_FALSE(facts.theta_rad || facts.steady || facts.nutation);
}

TEST(MotionFacts, OfATopUnderGravityAlone) {
  Problem top{PrincipalMoments(1, 1, 0.4),
              {Quat(Eigen::AngleAxisd(1, Vec3::UnitX())), Vec3(0, 0, 12)},
              {HeavyTop{3, Vec3::UnitZ()}}};
  const MotionFacts facts = motion_facts(top);
  ASSERT_TRUE(facts.theta_rad && facts.steady && facts.nutation);
  EXPECT_NEAR(*facts.theta_rad, 1, kRounding);
  EXPECT_NEAR(std::cos(1) * facts.steady->slow * facts.steady->slow - 0.4 * 12 * facts.steady->slow + 3, 0,
              16 * kRounding);
  EXPECT_FALSE(facts.period_s || facts.free) << "of free motion";
  top.torque.push_back(LinearDamping{0.1});
  EXPECT_FALSE(motion_facts(top).theta_rad || motion_facts(top).nutation);
}

TEST(MotionFacts, OfABodyAtRest) {
  const MotionFacts facts = motion_facts({PrincipalMoments(1, 2, 2.5), {Quat::Identity(), Vec3::Zero()}, {}});
  EXPECT_EQ(facts.T, 0);
  EXPECT_EQ(facts.L, 0);
  EXPECT_FALSE(facts.period_s || facts.free);
}

}  // namespace
}  // namespace polhode
