// SPDX-License-Identifier: MIT
// Kick / free flow / kick (attitude_torque.h) through the methods that use it.
#include "physics/body/euler.h"
#include "physics/integrators/attitude_torque.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

const Torque kGravity{HeavyTop{3.0, Vec3::UnitZ()}};

class Kicked : public testing::TestWithParam<Method> {
 protected:
  std::unique_ptr<const Motion> motion(const PrincipalMoments& I, const RigidBodyState& start,
                                       const Torque& torque, double h) const {
    return make_motion({I, start, torque}, {GetParam(), h, std::nullopt});
  }
};

INSTANTIATE_TEST_SUITE_P(, Kicked,
                         testing::Values(Method::splitting, Method::moser_veselov_2, Method::moser_veselov_6,
                                         Method::moser_veselov_10),
                         [](const auto& test) {
                           std::string name(name_of(test.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(AttitudeTorque, IsTheTorqueOfItsTerms) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Torque torque{SpaceTorque{random.vector(1)}, BodyTorque{random.vector(1)},
                        HeavyTop{1.5, random.vector(1)}, HeavyTop{-0.5, random.vector(1)}};
    const RigidBodyState state = random.state();
    const Vec3 N_B = vec3(AttitudeTorque(torque).N_B(quadruple(state.q_SB)));
    EXPECT_LE((N_B - torque_B(torque, state)).norm(), 64 * kEps);
  }
  EXPECT_THROW(AttitudeTorque({EnergySink{0.1}}), std::domain_error);
}

// Gravity has no torque about the vertical: L_z errs by rounding alone, 4ε a step at worst, though ω is far
// from exact. The energy oscillates with h² and does not drift.
TEST_P(Kicked, HeavyTopKeepsTheVerticalMomentumAndBoundsTheEnergy) {
  const PrincipalMoments I(1, 1.2, 0.5);
  const RigidBodyState start{Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX())), {0.2, 0.1, 8.0}};
  const auto energy = [&](const RigidBodyState& s) {
    return kinetic_energy(I, s.w_B) + potential_energy(kGravity, s);
  };
  const auto worst_energy = [&](double h, int from, int to) {
    const auto m = motion(I, start, kGravity, h);
    double worst = 0;
    for (int k = from; k < to; k += 7)
      worst = std::max(worst, std::abs(energy(m->at(k * h)) - energy(start)));
    return worst;
  };
  const double h = 1.0 / 128;
  const int steps = 40'000;
  const auto m = motion(I, start, kGravity, h);
  const double L = angular_momentum_S(I, start).norm(), L_z = angular_momentum_S(I, start).z();
  for (int k = -steps; k <= steps; k += 500)
    EXPECT_NEAR(angular_momentum_S(I, m->at(k * h)).z(), L_z, 4 * kEps * L * std::abs(k) + 8 * kEps * L) << k;

  const double early = worst_energy(h, 0, 4000), late = worst_energy(h, steps - 4000, steps);
  EXPECT_LE(late, 1.5 * early);
  EXPECT_GT(early, 1e-8);
  EXPECT_NEAR(std::log2(early / worst_energy(h / 2, 0, 8000)), 2.0, 0.2);
}

double observed_order(double coarse, double fine) { return std::log2(coarse / fine); }

TEST_P(Kicked, HasOrderTwoUnderEveryTorqueItServes) {
  const PrincipalMoments I(1.0, 1.75, 2.5);
  const RigidBodyState start{Random(2).attitude(), {0.2, 1.0, 0.3}};
  const Torque torques[] = {
      {SpaceTorque{{0.1, 0, 0.2}}},
      {BodyTorque{{0, 0.1, 0.05}}},
      {HeavyTop{0.5, Vec3::UnitY()}},
      {SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}}, HeavyTop{0.5, Vec3::UnitY()}}};
  for (const Torque& torque : torques) {
    const double t = -4, h = 1.0 / 256;
    const RigidBodyState truth =
        make_motion({I, start, torque}, {Method::rk4, 1.0 / 2048, std::nullopt})->at(t);
    const RigidBodyState a = motion(I, start, torque, h)->at(t), b = motion(I, start, torque, h / 2)->at(t);
    EXPECT_NEAR(observed_order(test::w_error(a.w_B, truth.w_B), test::w_error(b.w_B, truth.w_B)), 2.0, 0.1);
    EXPECT_NEAR(observed_order(test::q_error(a.q_SB, truth.q_SB), test::q_error(b.q_SB, truth.q_SB)), 2.0,
                0.1);
  }
}

// Steady precession of a symmetric top at angle θ with rate Ω: I_1 Ω² cosθ − I_3 ω_3 Ω + mgr = 0 (Goldstein,
// 3rd ed., §5.7 eq. (5.76)). With order 2 the error at h/2 is a quarter of that at h.
TEST_P(Kicked, FindsTheSteadyPrecessionOfAHeavyTop) {
  const double I1 = 1, I3 = 0.5, theta = 0.7, mgr = 3, Omega = 1.25, t = 6;
  const double w3 = (I1 * Omega * Omega * std::cos(theta) + mgr) / (I3 * Omega);
  const PrincipalMoments I(I1, I1, I3);
  const RigidBodyState start{Quat(Eigen::AngleAxisd(theta, Vec3::UnitX())), {0, Omega * std::sin(theta), w3}};
  const auto axis_error = [&](double h) {
    const Vec3 axis_S = motion(I, start, kGravity, h)->at(t).q_SB * Vec3::UnitZ();
    const Vec3 exact_S = Eigen::AngleAxisd(Omega * t, Vec3::UnitZ()) * (start.q_SB * Vec3::UnitZ());
    return (axis_S - exact_S).norm();
  };
  const double coarse = axis_error(1.0 / 256), fine = axis_error(1.0 / 512);
  EXPECT_LE(coarse, 1e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

// A constant torque about a principal axis of a body at rest: ω = Nt/I and the angle Nt²/2I, both exact for
// kick / flow / kick with an exact flow (the splitting), which is the leapfrog of constant acceleration.
TEST_P(Kicked, SpinsUpFromRest) {
  const PrincipalMoments I(1.0, 1.75, 2.5);
  const double h = 1.0 / 64, t = 3;
  const RigidBodyState y = motion(I, {}, {BodyTorque{{0, 0, 0.5}}}, h)->at(t);
  EXPECT_NEAR(y.w_B[2], 0.5 * t / 2.5, 200 * 2 * kEps);
  const double half_angle = 0.25 * 0.5 * t * t / 2.5;
  const double error = test::q_error(y.q_SB, {std::cos(half_angle), 0, 0, std::sin(half_angle)});
  EXPECT_LE(error, GetParam() == Method::moser_veselov_2 ? h * h : 200 * 4 * kEps + std::pow(h, 6));
}

TEST_P(Kicked, ReturnsWithTheStepReversed) {
  const PrincipalMoments I(1.0, 1.75, 2.5);
  const Torque torque{SpaceTorque{{0.1, 0, 0.2}}, HeavyTop{0.5, Vec3::UnitY()}};
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const RigidBodyState start = random.state();
    const double h = 0.03, t = 200 * h;
    const RigidBodyState back = motion(I, motion(I, start, torque, h)->at(t), torque, h)->at(-t);
    EXPECT_LE(test::w_error(back.w_B, start.w_B), 1e5 * kEps);
    EXPECT_LE(test::q_error(back.q_SB, start.q_SB), 1e5 * kEps);
  }
}

}  // namespace
}  // namespace polhode
