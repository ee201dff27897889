// SPDX-License-Identifier: MIT
#include "physics/body/state.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// As wide as Eigen aligns a quaternion for any processor, and of a size that has no room for more.
static_assert(alignof(RigidBodyState) == 32 && sizeof(RigidBodyState) == 64);

TEST(State, DefaultIsAtRestInTheSpaceFrame) {
  const RigidBodyState state;
  EXPECT_EQ(state.w_B, Vec3(0, 0, 0));
  EXPECT_EQ(state.q_SB.coeffs(), Quat::Identity().coeffs());
}

TEST(State, CheckingScalesTheAttitudeToUnitLengthAndKeepsTheRest) {
  for (const double size : {1.0, 3.0, 1e-200, 1e200}) {
    const RigidBodyState state = checked({Quat(size, size, -size, size), {1, 2, 3}});
    EXPECT_LE(test::q_error(state.q_SB, Quat(0.5, 0.5, -0.5, 0.5)), 4 * kEps);
    EXPECT_EQ(state.w_B, Vec3(1, 2, 3));
  }
}

TEST(State, CheckingRefusesWhatIsNoState) {
  EXPECT_THROW(checked({Quat::Identity(), {1, kNaN, 0}}), std::domain_error);
  EXPECT_THROW(checked({Quat::Identity(), {1, 0, INFINITY}}), std::domain_error);
  EXPECT_THROW(checked({Quat(0, 0, 0, 0), {1, 0, 0}}), std::domain_error);
  EXPECT_THROW(checked({Quat(kNaN, 0, 0, 0), {1, 0, 0}}), std::domain_error);
  EXPECT_THROW(checked({Quat(INFINITY, 0, 0, 0), {1, 0, 0}}), std::domain_error);
}

}  // namespace
}  // namespace polhode
