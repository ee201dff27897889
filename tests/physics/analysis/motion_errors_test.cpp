// SPDX-License-Identifier: MIT
#include "physics/analysis/motion_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
const PrincipalMoments kI(1, 2, 2.5);
const RigidBodyState kState{Quat(0.5, 0.5, -0.5, 0.5), Vec3(0.3, -0.2, 1.5)};

RigidBodyState turned_by(double angle_rad) {
  RigidBodyState state = kState;
  state.q_SB = kState.q_SB * Quat(Eigen::AngleAxisd(angle_rad, Vec3(1, 2, -2).normalized()));
  return state;
}

TEST(StateError, IsZeroForTheSameStateAndForItsOtherQuaternion) {
  RigidBodyState other = kState;
  other.q_SB.coeffs() *= -1;
  for (const RigidBodyState& state : {kState, other}) {
    EXPECT_EQ(error_of(state, kState).omega, 0);
    EXPECT_EQ(error_of(state, kState).attitude_rad, 0);
  }
}

// acos(|w|) would give 0 below 1e-8: the cosine of such an angle is 1.
TEST(StateError, MeasuresAnglesOfAnySize) {
  for (double angle : {1e-14, 1e-9, 1e-3, 1.0, 3.0, std::numbers::pi})
    EXPECT_NEAR(error_of(turned_by(angle), kState).attitude_rad, angle, 8 * kEpsilon) << angle;
  EXPECT_NEAR(error_of(turned_by(4), kState).attitude_rad, 2 * std::numbers::pi - 4, 8 * kEpsilon);
}

TEST(StateError, OfOmegaIsRelativeAtAnyScale) {
  for (double scale : {1e-300, 1.0, 1e200}) {
    RigidBodyState reference = kState, state = kState;
    reference.w_B *= scale;
    state.w_B *= 1.25 * scale;
    EXPECT_NEAR(error_of(state, reference).omega, 0.25, 8 * kEpsilon) << scale;
  }
}

TEST(StateError, IsNaNWhereTheStateIs) {
  RigidBodyState state = kState;
  state.w_B[1] = NAN;
  EXPECT_TRUE(std::isnan(error_of(state, kState).omega));
  state = kState;
  state.q_SB.x() = NAN;
  EXPECT_TRUE(std::isnan(error_of(state, kState).attitude_rad));
}

TEST(InvariantDrift, IsTheLargestOnTheWay) {
  RigidBodyState faster = kState;
  faster.w_B *= 1.5;
  const std::vector<RigidBodyState> states = {kState, faster, turned_by(0), kState};
  const InvariantDrift drift = drift_along({kI, kState, {}}, states);
  EXPECT_NEAR(drift.T, 1.25, 8 * kEpsilon);
  EXPECT_NEAR(drift.L, 0.5, 8 * kEpsilon);
  EXPECT_NEAR(drift.L_direction_rad, 0, 8 * kEpsilon);
}

// A body turned in space by an angle about an axis normal to L turns L by it, and changes neither T nor |L|.
TEST(InvariantDrift, SeesLTurnInSpaceWhereTAndItsLengthAreKept) {
  const Vec3 L_S = kState.q_SB * kI.vector().cwiseProduct(kState.w_B);
  const Vec3 normal = L_S.unitOrthogonal();
  for (double angle : {1e-12, 0.1, 3.0}) {
    RigidBodyState state = kState;
    state.q_SB = Quat(Eigen::AngleAxisd(angle, normal)) * kState.q_SB;
    const InvariantDrift drift = drift_along({kI, kState, {}}, std::vector{state, kState});
    EXPECT_NEAR(drift.L_direction_rad, angle, 16 * kEpsilon);
    EXPECT_EQ(drift.T, 0);
    EXPECT_LE(drift.L, 8 * kEpsilon);
  }
}

TEST(InvariantDrift, ForgetsNoNaN) {
  RigidBodyState broken = kState;
  broken.w_B[0] = NAN;
  const InvariantDrift drift = drift_along({kI, kState, {}}, std::vector{kState, broken, kState});
  EXPECT_TRUE(std::isnan(drift.T));
  EXPECT_TRUE(std::isnan(drift.L));
  EXPECT_TRUE(std::isnan(drift.L_direction_rad));
}

TEST(InvariantDrift, IsOfWhatTheTorqueKeeps) {
  const std::vector states = {kState};
  const InvariantDrift with_sink = drift_along({kI, kState, {EnergySink{0.1}}}, states);
  EXPECT_TRUE(std::isnan(with_sink.T));
  EXPECT_EQ(with_sink.L, 0);
  EXPECT_EQ(with_sink.L_direction_rad, 0);
  for (const TorqueTerm& term :
       {TorqueTerm(SpaceTorque{Vec3(1, 0, 0)}), TorqueTerm(BodyTorque{Vec3(1, 0, 0)}), TorqueTerm(HeavyTop{}),
        TorqueTerm(LinearDamping{0.1})}) {
    const InvariantDrift drift = drift_along({kI, kState, {EnergySink{0.1}, term}}, states);
    EXPECT_TRUE(std::isnan(drift.T) && std::isnan(drift.L) && std::isnan(drift.L_direction_rad));
  }
}

}  // namespace
}  // namespace polhode
