// SPDX-License-Identifier: MIT
#include "physics/body/equations_of_motion.h"

#include "physics/body/euler.h"
#include "physics/exact/uniform_motion.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

using test::attitude_rate;
using test::kEps;
using test::Random;

const std::vector<Torque> kTorques{
    {},
    {SpaceTorque{{0.1, -0.3, 0.2}}},
    {BodyTorque{{0.3, 0.1, -0.5}}},
    {HeavyTop{0.5, Vec3(1, 2, 2) / 3}},
    {LinearDamping{0.05}},
    {EnergySink{0.02}},
    {SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}}, HeavyTop{0.5, Vec3::UnitY()}, LinearDamping{0.05},
     EnergySink{0.02}, SpaceTorque{{0, 0.4, 0}}, EnergySink{0.03}}};

// The equations of euler.h and torque.h, evaluated as they stand there. Sums of at most 20 products, each of
// at most the size of M/I.
TEST(EquationsOfMotion, AreThoseOfEulerWithTheTorqueAndTheSlip) {
  Random random(11);
  for (const Torque& torque : kTorques) {
    for (int i = 0; i < 100; ++i) {
      const PrincipalMoments I = random.moments();
      const RigidBodyState state = random.state();
      const Vec3 s_B = slip_B(torque, I, state.w_B);
      const Vec3 M_B = torque_B(torque, state) + angular_momentum_B(I, state.w_B).cross(s_B);
      const Vec3 w_rate = angular_acceleration_B(I, state.w_B, M_B);
      const Eigen::Vector4d q_rate = attitude_rate(state.q_SB, state.w_B + s_B);

      MotionVector rate;
      EquationsOfMotion(I, torque).rate(packed(state), rate);
      const double largest = (10 + state.w_B.squaredNorm()) / I.vector().minCoeff();
      for (int n = 0; n < 3; ++n) EXPECT_NEAR(rate[n], w_rate[n], 20 * kEps * largest);
      for (int n = 0; n < 4; ++n) EXPECT_NEAR(rate[3 + n], q_rate[n], 20 * kEps * (1 + state.w_B.norm()));
      EXPECT_EQ(rate[7], 0);
    }
  }
}

TEST(EquationsOfMotion, TurnTheAttitudeByOmega) {
  Random random(13);
  for (int i = 0; i < 50; ++i) {
    const Quat q_SB = random.attitude();
    const Vec3 w_B = random.vector(2);
    const double h = 0x1p-17;  // central difference: error |ω|³h²/48 + ε/h
    const Eigen::Vector4d difference =
        ((q_SB * rotation_by(w_B, h)).coeffs() - (q_SB * rotation_by(w_B, -h)).coeffs()) / (2 * h);
    MotionVector rate;
    EquationsOfMotion(random.moments(), {}).rate(packed({q_SB, w_B}), rate);
    const Eigen::Vector4d q_rate(rate[3], rate[4], rate[5], rate[6]);
    EXPECT_LE((q_rate - difference).norm(), std::pow(w_B.norm(), 3) * h * h + 4 * kEps / h);
  }
}

TEST(EquationsOfMotion, OfOmegaAloneGiveTheSameNumbers) {
  Random random(12);
  for (const Torque& torque : kTorques) {
    const EquationsOfMotion equations(random.moments(), torque);
    EXPECT_EQ(equations.depends_on_attitude(), depends_on_attitude(torque));
    if (equations.depends_on_attitude()) continue;
    const RigidBodyState state = random.state();
    MotionVector rate;
    equations.rate(packed(state), rate);
    const double w[3] = {state.w_B[0], state.w_B[1], state.w_B[2]};
    double w_rate[3];
    equations.rate(w, w_rate);
    for (int n = 0; n < 3; ++n) EXPECT_EQ(w_rate[n], rate[n]);
  }
}

TEST(EquationsOfMotion, TakeTheDirectionOfQAloneForTheTorque) {
  Random random(13);
  const EquationsOfMotion equations(random.moments(), {HeavyTop{0.5, Vec3::UnitX()}});
  MotionVector y = packed(random.state()), rate, longer_rate;
  equations.rate(y, rate);
  for (int n = 3; n < 7; ++n) y[n] *= 4;
  equations.rate(y, longer_rate);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(longer_rate[n], rate[n]);
  for (int n = 3; n < 7; ++n) EXPECT_EQ(longer_rate[n], 4 * rate[n]);
}

TEST(EquationsOfMotion, StayInRangeWhereSquaresDoNot) {
  const EquationsOfMotion equations(PrincipalMoments(1, 2, 3), {EnergySink{0.1}});
  MotionVector rate;
  equations.rate({{1e-200, 2e-200, 3e-200, 0, 0, 0, 1}}, rate);
  const Vec3 s_B = slip_B({EnergySink{0.1}}, PrincipalMoments(1, 2, 3), {1e-200, 2e-200, 3e-200});
  EXPECT_NEAR(rate[3], 0.5 * (1e-200 + s_B[0]), 8 * kEps * 1e-200);
  equations.rate({{0, 0, 0, 0, 0, 0, 1}}, rate);
  for (int n = 0; n < 8; ++n) EXPECT_EQ(rate[n], 0);
}

TEST(EquationsOfMotion, StatesArePackedAndUnpacked) {
  Random random(14);
  const RigidBodyState state = random.state();
  EXPECT_TRUE(test::same_bits(unpacked(packed(state)), state));
}

}  // namespace
}  // namespace polhode
