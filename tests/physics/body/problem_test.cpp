// SPDX-License-Identifier: MIT
#include "physics/body/problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

Problem top_along(const Vec3& axis_B) {
  return {PrincipalMoments(1, 1, 0.5), {Quat(2, 0, 0, 0), Vec3(0, 0, 3)}, {HeavyTop{0.5, axis_B}}};
}

TEST(CheckedProblem, HasAnAttitudeOfUnitLengthAndTheRestAsItIs) {
  const Problem given = top_along(Vec3::UnitZ());
  const Problem problem = checked(given);
  EXPECT_EQ(problem.start.q_SB.norm(), 1.0);
  EXPECT_EQ(problem.start.w_B, given.start.w_B);
  EXPECT_EQ(problem.I, given.I);
  EXPECT_EQ(problem.torque, given.torque);
}

TEST(CheckedProblem, TakesAUnitAxisOfSixDigitsAsItIs) {
  for (const Vec3& axis_B : {Vec3(0.6, 0.8, 0), Vec3(0.57735, 0.57735, 0.57735), Vec3(0, -1, 1e-4)})
    EXPECT_EQ(checked(top_along(axis_B)).torque, top_along(axis_B).torque);
}

TEST(CheckedProblem, RefusesAnAxisThatIsNoUnitVector) {
  for (const Vec3& axis_B : {Vec3(0, 0, 0), Vec3(0, 0, 2), Vec3(0, 0, 1.001), Vec3(1, 1, 1),
                             Vec3(1e300, 1e300, 0), Vec3(NAN, 0, 1)})
    EXPECT_THROW(checked(top_along(axis_B)), std::domain_error) << axis_B.transpose();
}

}  // namespace
}  // namespace polhode
