// SPDX-License-Identifier: MIT
#include "physics/body/torque.h"

#include "physics/body/euler.h"
#include "physics/integrators/explicit_runge_kutta.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

const PrincipalMoments kI(1.0, 1.75, 2.5);
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// What RK4 may lose of a conserved quantity of size 1: its error per step is below (|ω|h)⁵.
double rk4_loss(double w, double h, double t) { return t / h * std::pow(w * h, 5); }

TEST(Torque, TermsAreWhatTheirNamesSay) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const RigidBodyState state = random.state();
    const Vec3 N = random.vector(3);
    const double tolerance = 16 * kEps * N.norm();
    EXPECT_LE((state.q_SB * torque_B({SpaceTorque{N}}, state) - N).norm(), tolerance);
    EXPECT_EQ(torque_B({BodyTorque{N}}, state), N);
    EXPECT_EQ(torque_B({LinearDamping{0.25}}, state), Vec3(-0.25 * state.w_B));
    EXPECT_EQ(torque_B({EnergySink{0.25}}, state), Vec3(0, 0, 0));

    const Vec3 axis_S = state.q_SB * Vec3::UnitX();
    const Vec3 gravity_S = state.q_SB * torque_B({HeavyTop{2.0, Vec3::UnitX()}}, state);
    EXPECT_LE((gravity_S - axis_S.cross(Vec3(0, 0, -2.0))).norm(), 32 * kEps);
  }
}

TEST(Torque, IsTheSumOfItsTerms) {
  const RigidBodyState state{Quat::Identity(), {1, 2, 3}};
  EXPECT_EQ(torque_B({}, state), Vec3(0, 0, 0));
  EXPECT_EQ(torque_B({BodyTorque{{1, 0, 0}}, SpaceTorque{{0, 1, 0}}, LinearDamping{1}, EnergySink{1}}, state),
            Vec3(0, -1, -3));
}

TEST(Torque, OnlySpaceTorqueAndGravityDependOnAttitude) {
  EXPECT_FALSE(depends_on_attitude({}));
  EXPECT_FALSE(depends_on_attitude({BodyTorque{}, LinearDamping{1}, EnergySink{1}}));
  EXPECT_TRUE(depends_on_attitude({BodyTorque{}, SpaceTorque{{1, 0, 0}}}));
  EXPECT_TRUE(depends_on_attitude({HeavyTop{1, Vec3::UnitZ()}}));
}

TEST(Torque, FiniteMeansEveryNumber) {
  EXPECT_TRUE(is_finite({SpaceTorque{}, BodyTorque{}, HeavyTop{}, LinearDamping{}, EnergySink{}}));
  EXPECT_FALSE(is_finite({SpaceTorque{{0, kNaN, 0}}}));
  EXPECT_FALSE(is_finite({BodyTorque{{0, 0, INFINITY}}}));
  EXPECT_FALSE(is_finite({HeavyTop{kNaN, Vec3::UnitZ()}}));
  EXPECT_FALSE(is_finite({HeavyTop{1, {0, kNaN, 0}}}));
  EXPECT_FALSE(is_finite({LinearDamping{1}, LinearDamping{kNaN}}));
  EXPECT_FALSE(is_finite({EnergySink{-INFINITY}}));
}

TEST(Torque, SlipIsAcrossBothMomentaAndVanishesInSteadyRotation) {
  const Vec3 w_B(0.3, 1.0, -0.5);
  const Vec3 s_B = slip_B({EnergySink{0.1}}, kI, w_B);
  EXPECT_NEAR(s_B.dot(w_B), 0, 8 * kEps);
  EXPECT_NEAR(s_B.dot(angular_momentum_B(kI, w_B)), 0, 16 * kEps);
  EXPECT_GT(s_B.norm(), 0);
  EXPECT_EQ(slip_B({EnergySink{0.1}}, kI, {0, 2, 0}), Vec3(0, 0, 0));
  EXPECT_EQ(slip_B({EnergySink{0.1}}, kI, {0, 0, 0}), Vec3(0, 0, 0));
  EXPECT_EQ(slip_B({LinearDamping{0.1}}, kI, w_B), Vec3(0, 0, 0));
  EXPECT_EQ(slip_B({EnergySink{0.1}, EnergySink{0.2}}, kI, w_B), slip_B({EnergySink{0.1 + 0.2}}, kI, w_B));
  EXPECT_TRUE(slip_B({EnergySink{0.1}}, PrincipalMoments(1e200, 1.75e200, 2.5e200), 1e100 * w_B).allFinite());
}

TEST(EnergySink, KeepsMomentumInSpaceWhileEnergyFallsToTheMajorAxis) {
  const RigidBodyState start{Random(2).attitude(), {1.5, 0.2, 0.1}};
  const double h = 1.0 / 256, t_end = 200, w = 2.5;
  const auto motion = rk4_motion({kI, start, {EnergySink{0.05}}}, h);
  const Vec3 L_S = angular_momentum_S(kI, start);
  double T = kinetic_energy(kI, start.w_B);
  for (double t = 1; t <= t_end; t += 1) {
    const RigidBodyState state = motion->at(t);
    EXPECT_LE((angular_momentum_S(kI, state) - L_S).norm(), L_S.norm() * rk4_loss(w, h, t)) << t;
    const double T_now = kinetic_energy(kI, state.w_B);
    EXPECT_LT(T_now, T + rk4_loss(w, h, t_end) * T) << t;
    T = T_now;
  }
  // Close to the major axis the excess over the least energy for this L decays at 2cω3(I3 − I2)/I2 or faster.
  const double decay = 2 * 0.05 * (L_S.norm() / kI[2]) * (kI[2] - kI[1]) / kI[1];
  const double least = L_S.squaredNorm() / (2 * kI[2]);
  EXPECT_NEAR(T, least, std::exp(-decay * t_end) * kinetic_energy(kI, start.w_B));
}

TEST(EnergySink, LosesEnergyAtTheRateOfTheDoubleBracket) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Vec3 w_B = random.vector(2);
    const double c = 0.1;
    const Vec3 L_B = angular_momentum_B(kI, w_B);
    const Vec3 s_B = slip_B({EnergySink{c}}, kI, w_B);
    const double T_rate = w_B.dot(L_B.cross(w_B + s_B));
    EXPECT_NEAR(T_rate, -c * L_B.cross(w_B).squaredNorm() / L_B.norm(),
                64 * kEps * L_B.norm() * w_B.squaredNorm());
  }
}

TEST(LinearDamping, TakesEnergyAtTheRateOfItsPower) {
  const RigidBodyState start{Quat::Identity(), {1, 0.5, 0.7}};
  const double c = 0.1, h = 1.0 / 128;
  const auto motion = rk4_motion({kI, start, {LinearDamping{c}}}, h);
  for (double t = 0; t < 5; t += 0.5) {
    const double dt = 0x1p-13;  // central difference of T, error of order dt² and ε/dt
    const double rate =
        (kinetic_energy(kI, motion->w_B_at(t + dt)) - kinetic_energy(kI, motion->w_B_at(t - dt))) / (2 * dt);
    EXPECT_NEAR(rate, -c * motion->w_B_at(t).squaredNorm(),
                10 * dt * dt + 10 * kEps / dt + rk4_loss(2, h, 5));
  }
}

TEST(HeavyTop, KeepsEnergyAndTheVerticalMomentum) {
  const PrincipalMoments I(1, 1, 0.5);
  const Torque gravity{HeavyTop{3.0, Vec3::UnitZ()}};
  const RigidBodyState start{Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX())), {0.2, 0.1, 8.0}};
  const double h = 1.0 / 1024, t_end = 20, w = 8.5;
  const auto motion = rk4_motion({I, start, gravity}, h);
  const auto energy = [&](const RigidBodyState& s) {
    return kinetic_energy(I, s.w_B) + potential_energy(gravity, s);
  };
  for (double t = -t_end; t <= t_end; t += 2.5) {
    const RigidBodyState state = motion->at(t);
    EXPECT_NEAR(energy(state), energy(start), energy(start) * rk4_loss(w, h, t_end)) << t;
    EXPECT_NEAR(angular_momentum_S(I, state).z(), angular_momentum_S(I, start).z(), 8 * rk4_loss(w, h, t_end))
        << t;
  }
}

TEST(SpaceTorque, ChangesMomentumAtItsOwnRate) {
  const Vec3 N_S(0.3, -0.2, 0.1);
  const RigidBodyState start{Random(4).attitude(), {1, 0.5, -0.7}};
  const double h = 1.0 / 256, t = 6;
  const auto motion = rk4_motion({kI, start, {SpaceTorque{N_S}}}, h);
  const Vec3 change_S = angular_momentum_S(kI, motion->at(t)) - angular_momentum_S(kI, start);
  EXPECT_LE((change_S - t * N_S).norm(), 5 * rk4_loss(3, h, t));
}

}  // namespace
}  // namespace polhode
