// SPDX-License-Identifier: MIT
#include "physics/analysis/symmetric_top.h"

#include "physics/body/euler.h"
#include "physics/body/euler_angles.h"
#include "physics/method.h"
#include "tests/physics/support.h"
#include "tests/support/euler_angle_top.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;
constexpr double kPi = std::numbers::pi;

const PrincipalMoments kMoments(0.0125, 0.0125, 0.005);
constexpr double kMgl = 0.98;
const Torque kGravity{HeavyTop{kMgl, Vec3::UnitZ()}};

std::unique_ptr<const Motion> motion_of(const Problem& problem) {
  return make_motion(problem, {Method::dormand_prince_8, {}, 1e-13});
}

RigidBodyState start_at(double theta, double phi_rate, double w3, double theta_rate = 0) {
  const EulerAngles angles{0.3, theta, -0.8};
  return {attitude_of(angles), w_B_of(angles, phi_rate, theta_rate, w3)};
}

TEST(FreePrecession, IsTheTurningOfTheAxisAboutL) {
  const PrincipalMoments I(2.0, 1.2, 2.0);  // about axis 2
  const Vec3 w_B(0.3, 1.5, -0.4);
  const auto free = free_precession(I, w_B);
  ASSERT_TRUE(free);
  EXPECT_EQ(free->axis, 1);
  const auto motion = make_motion({I, {Quat::Identity(), w_B}, {}}, {Method::symmetric, {}, {}});
  const Vec3 L = angular_momentum_B(I, w_B);  // also in space, where the attitude starts as 1
  const double t = 0.4;
  const auto turned_by = [&](const Vec3& before, const Vec3& after, const Vec3& about) {
    const Vec3 n = about.normalized(), a = before - before.dot(n) * n, b = after - after.dot(n) * n;
    return std::atan2(n.dot(a.cross(b)), a.dot(b));
  };
  EXPECT_NEAR(turned_by(Vec3::UnitY(), motion->at(t).q_SB * Vec3::UnitY(), L), free->in_space * t, 64 * kEps);
  EXPECT_NEAR(turned_by(w_B, motion->at(t).w_B, Vec3::UnitY()), free->in_body * t, 64 * kEps);
}

TEST(FreePrecession, IsOfTwoEqualMoments) {
  EXPECT_FALSE(free_precession(PrincipalMoments(1, 1.75, 2.5), Vec3(1, 2, 3)));
  EXPECT_FALSE(free_precession(PrincipalMoments(2, 2, 2), Vec3(1, 2, 3)));
}

TEST(SymmetricTop, NeedsEqualMomentsAcrossItsWeight) {
  EXPECT_TRUE(symmetric_top(kMoments, kGravity));
  EXPECT_FALSE(symmetric_top(kMoments, {}));
  EXPECT_FALSE(symmetric_top(kMoments, {HeavyTop{0.0, Vec3::UnitZ()}}));
  EXPECT_FALSE(symmetric_top(kMoments, {HeavyTop{kMgl, Vec3::UnitX()}}));
  EXPECT_FALSE(symmetric_top(kMoments, {HeavyTop{kMgl, Vec3(0, 0.6, 0.8)}}));
  EXPECT_FALSE(symmetric_top(PrincipalMoments(1, 1.75, 2.5), kGravity));
  const auto hanging = symmetric_top(kMoments, {HeavyTop{-kMgl, Vec3::UnitZ()}, LinearDamping{0.1}});
  ASSERT_TRUE(hanging);
  EXPECT_EQ(hanging->axis_B, -Vec3::UnitZ());
  EXPECT_EQ(hanging->mgl, kMgl);
  EXPECT_EQ(hanging->I3, 0.005);
}

// What precesses steadily keeps its tilt, and turns about the vertical at that rate, in the program's motion.
TEST(SteadyPrecession, KeepsTheTilt) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  for (double theta : {0.3, kPi / 3, kPi / 2, 2.2})
    for (double w3 : {60.0, -80.0}) {
      const auto steady = steady_precession(top, std::cos(theta), w3);
      ASSERT_TRUE(steady);
      EXPECT_EQ(steady->fast.has_value(), theta != kPi / 2);
      for (double rate : {steady->slow, steady->fast.value_or(steady->slow)}) {
        const auto motion = motion_of({kMoments, start_at(theta, rate, w3), kGravity});
        for (double t : {0.02, 0.1, 0.35}) {
          const EulerAngles angles = euler_angles_of(motion->at(t).q_SB);
          // A tolerance of 1e-13 a step, some thousand steps.
          EXPECT_NEAR(angles.theta_rad, theta, 1e-9);
          EXPECT_NEAR(std::remainder(angles.phi_rad - 0.3 - rate * t, 2 * kPi), 0, 1e-9);
        }
      }
      if (steady->fast) {
        EXPECT_LE(std::abs(steady->slow), std::abs(*steady->fast));
        EXPECT_NEAR(steady->slow * *steady->fast, top.mgl / (top.I1 * std::cos(theta)), 1e-12) << "Vieta";
      }
    }
}

TEST(SteadyPrecession, NeedsTheLeastSpin) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  const double least = least_spin(top, 0.5);
  EXPECT_NEAR(least, std::sqrt(4 * 0.0125 * kMgl * 0.5) / 0.005, 1e-13);
  EXPECT_TRUE(steady_precession(top, 0.5, least * (1 + 1e-12)));
  EXPECT_FALSE(steady_precession(top, 0.5, least * (1 - 1e-12)));
  EXPECT_FALSE(steady_precession(top, 0.5, 0));
  EXPECT_FALSE(steady_precession(top, 0, 0));
  EXPECT_EQ(least_spin(top, -0.5), 0);
  const auto conical = steady_precession(top, -0.5, 0);  // a conical pendulum, either way round
  ASSERT_TRUE(conical);
  EXPECT_NEAR(std::abs(conical->slow), std::sqrt(kMgl / (0.0125 * 0.5)), 1e-12);
  EXPECT_NEAR(*conical->fast, -conical->slow, 1e-12);
}

// Independent: Euler's angles by Runge-Kutta steps; after the period θ and θ̇ are again what they were, at
// half of it θ is at the other turning point.
TEST(Nutation, IsThePeriodOfTheta) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  for (double w3 : {60.0, 25.0, 3.0, -60.0})
    for (double phi_rate : {0.0, -3.0, 2.0, 30.0}) {
      const auto found = nutation(top, start_at(kPi / 3, phi_rate, w3));
      ASSERT_TRUE(found);
      const double period = 2 * kPi / found->rate;
      const test::EulerAngleTop other{top.I1, top.I3, top.mgl, w3};
      const auto half = other.after({kPi / 3, 0, 0, 0, phi_rate}, period / 2, 40'000);
      const auto whole = other.after(half, period / 2, 40'000);
      // (|ω|h)⁴ is below 1e-12 here, and where θ turns close to the vertical φ̇ is ten times as large.
      constexpr double kRungeKutta = 1e-8;
      EXPECT_NEAR(whole[0], kPi / 3, kRungeKutta) << w3 << ' ' << phi_rate;
      EXPECT_NEAR(whole[3] / found->rate, 0, kRungeKutta);
      EXPECT_NEAR(half[3] / found->rate, 0, kRungeKutta);
      EXPECT_NEAR(std::min(half[0], kPi / 3), found->theta_least_rad, kRungeKutta);
      EXPECT_NEAR(std::max(half[0], kPi / 3), found->theta_most_rad, kRungeKutta);
    }
}

TEST(Nutation, IsTheSameAnywhereOnTheWay) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  const Problem problem{kMoments, start_at(1.0, 2.0, 60.0, 4.0), kGravity};
  const auto motion = motion_of(problem);
  const auto first = nutation(top, problem.start);
  for (double t : {0.01, 0.05, 0.3}) {
    const auto later = nutation(top, motion->at(t));
    EXPECT_NEAR(later->rate, first->rate, 1e-9 * first->rate);
    EXPECT_NEAR(later->theta_least_rad, first->theta_least_rad, 1e-9);
    EXPECT_NEAR(later->theta_most_rad, first->theta_most_rad, 1e-9);
  }
}

TEST(Nutation, OfASteadyTopIsTheSmallOne) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  const double theta = kPi / 3, w3 = 60, a = top.I3 * w3 / top.I1;
  const double slow = steady_precession(top, std::cos(theta), w3)->slow;
  const auto found = nutation(top, start_at(theta, slow, w3));
  ASSERT_TRUE(found);
  // ν² = −∂θ̈/∂θ where L_z and ω3 stay as they are (Landau & Lifshitz, §35), by a difference quotient.
  const auto theta_acceleration = [&](double at) {
    const double Lz = slow * std::pow(std::sin(theta), 2) + a * std::cos(theta);  // over I1
    const double phi_rate = (Lz - a * std::cos(at)) / std::pow(std::sin(at), 2);
    return (phi_rate * phi_rate * std::cos(at) - a * phi_rate + top.mgl / top.I1) * std::sin(at);
  };
  constexpr double h = 1e-5;
  const double stiffness = -(theta_acceleration(theta + h) - theta_acceleration(theta - h)) / (2 * h);
  EXPECT_NEAR(found->rate, std::sqrt(stiffness), 1e-8 * found->rate);  // h² and ε/h, as of any such quotient
  EXPECT_NEAR(found->theta_least_rad, theta, 1e-7);
  EXPECT_NEAR(found->theta_most_rad, theta, 1e-7);
}

TEST(Nutation, OfASleepingTopIsThatOfItsSmallMotions) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  const double w3 = 60, a = top.I3 * w3 / top.I1;
  const auto asleep = nutation(top, {Quat::Identity(), Vec3(0, 0, w3)});
  ASSERT_TRUE(asleep);
  EXPECT_NEAR(asleep->rate, std::sqrt(a * a - 4 * top.mgl / top.I1), 1e-12 * a);
  EXPECT_EQ(asleep->theta_most_rad, 0);
  EXPECT_FALSE(nutation(top, {Quat::Identity(), Vec3(0, 0, 40)})) << "balanced, and not for long";
  EXPECT_FALSE(nutation(top, {Quat::Identity(), Vec3::Zero()}));
}

TEST(Nutation, OfAPendulumIsThatOfThePendulum) {
  const SymmetricTop top = *symmetric_top(kMoments, kGravity);
  const double from = 2.0;  // from the upright position: an amplitude of π − 2
  const auto swing = nutation(top, start_at(from, 0, 0));
  ASSERT_TRUE(swing);
  // T = 4 √(I/mgl) K(sin(amplitude/2)); θ, which is never negative, does the same twice on the way.
  const double K = std::comp_ellint_1(std::sin((kPi - from) / 2));
  EXPECT_NEAR(2 * kPi / swing->rate, 2 * std::sqrt(top.I1 / top.mgl) * K, 1e-12);
  EXPECT_NEAR(swing->theta_most_rad, kPi, 1e-7);  // acos at its end: √ε
  EXPECT_NEAR(swing->theta_least_rad, from, 1e-12);
}

}  // namespace
}  // namespace polhode
