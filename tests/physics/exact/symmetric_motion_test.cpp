// SPDX-License-Identifier: MIT
#include "physics/exact/symmetric_motion.h"

#include "physics/body/euler.h"
#include "physics/exact/uniform_motion.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace polhode {
namespace {

using test::attitude_rate;
using test::kEps;
using test::Random;

TEST(SymmetryAxis, IsTheOddOneOut) {
  EXPECT_EQ(symmetry_axis(PrincipalMoments(1, 1, 1.5)), 2);
  EXPECT_EQ(symmetry_axis(PrincipalMoments(1, 1.5, 1)), 1);
  EXPECT_EQ(symmetry_axis(PrincipalMoments(1.5, 1, 1)), 0);
  EXPECT_EQ(symmetry_axis(PrincipalMoments(1, 1, 1)), 2);
  EXPECT_EQ(symmetry_axis(PrincipalMoments(1, 1 + 0x1p-52, 1.5)), std::nullopt);
}

TEST(SymmetricMotion, MatchesTheReference) {
  for (const char* name : {"oblate_exact", "prolate_exact_perm", "sphere_exact"}) {
    const test::ReferenceCase& c = test::reference_case(name);
    const SymmetricMotion motion(c.I, c.start);
    for (const test::ReferenceState& truth : c.states) {
      const RigidBodyState state = motion.at(truth.t_s);
      EXPECT_LE(test::w_error(state.w_B, truth.state.w_B), 4 * kEps * (1 + truth.cond_w))
          << name << " " << truth.t_s;
      EXPECT_LE(test::q_error(state.q_SB, truth.state.q_SB), 4 * kEps * (1 + truth.cond_q))
          << name << " " << truth.t_s;
    }
  }
}

// Any axis, both signs of I_c − I_a, all octants, both signs of t.
TEST(SymmetricMotion, ObeysTheEquationsOfMotion) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const SymmetricMotion motion(I, random.state());
    const double t = random.uniform(-20, 20);
    const RigidBodyState state = motion.at(t);
    const double h = 0x1p-16;  // central differences: error (rate)³h²/6 + ε/h; no rate exceeds 5·|ω|
    const double rate = 1 + 5 * state.w_B.norm();
    const double tolerance = rate * rate * rate * rate * h * h + rate * 1e3 * kEps / h;
    const RigidBodyState before = motion.at(t - h), after = motion.at(t + h);
    EXPECT_LE(((after.w_B - before.w_B) / (2 * h) - angular_acceleration_B(I, state.w_B)).norm(), tolerance);
    EXPECT_LE(((after.q_SB.coeffs() - before.q_SB.coeffs()) / (2 * h) - attitude_rate(state.q_SB, state.w_B))
                  .norm(),
              tolerance);
  }
}

TEST(SymmetricMotion, KeepsEnergyAndMomentumInSpace) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const RigidBodyState state = SymmetricMotion(I, start).at(random.uniform(-100, 100));
    const double T = kinetic_energy(I, start.w_B);
    const Vec3 L_S = angular_momentum_S(I, start);
    EXPECT_NEAR(kinetic_energy(I, state.w_B), T, 16 * kEps * T);
    // The phases of ω and of q are rounded apart: up to 2ε per radian of the 1e2·20 turned.
    EXPECT_LE((angular_momentum_S(I, state) - L_S).norm(), (16 + 4 * 2000) * kEps * L_S.norm());
    EXPECT_NEAR(state.q_SB.norm(), 1, 8 * kEps);
  }
}

TEST(SymmetricMotion, RestartedOnTheWayGoesOnTheSame) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const SymmetricMotion motion(I, random.state());
    const double t1 = random.uniform(-5, 5), t2 = random.uniform(-5, 5);
    const RigidBodyState direct = motion.at(t1 + t2);
    const RigidBodyState relayed = SymmetricMotion(I, motion.at(t1)).at(t2);
    const double turned = 10 * 5 * 4;  // bound on the radians turned
    EXPECT_LE(test::w_error(relayed.w_B, direct.w_B), 8 * kEps * turned);
    EXPECT_LE(test::q_error(relayed.q_SB, direct.q_SB), 8 * kEps * turned);
  }
}

TEST(SymmetricMotion, TurningTheStartTurnsTheMotion) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const Quat p = random.attitude();
    const double t = random.uniform(-10, 10);
    const RigidBodyState plain = SymmetricMotion(I, start).at(t);
    const RigidBodyState turned = SymmetricMotion(I, {p * start.q_SB, start.w_B}).at(t);
    EXPECT_LE(test::q_error(turned.q_SB, p * plain.q_SB), 24 * kEps);
    EXPECT_EQ(turned.w_B, plain.w_B);
  }
}

TEST(SymmetricMotion, ScalesByPowersOfTwoToTheBit) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const double t = random.uniform(-10, 10);
    const RigidBodyState plain = SymmetricMotion(I, start).at(t);
    const Vec3 big = I.vector() * 0x1p301;
    RigidBodyState scaled =
        SymmetricMotion({big[0], big[1], big[2]}, {start.q_SB, start.w_B * 0x1p-203}).at(t * 0x1p203);
    scaled.w_B *= 0x1p203;
    EXPECT_TRUE(test::same_bits(plain, scaled));
  }
}

TEST(SymmetricMotion, SphereIsUniformRotation) {
  Random random(6);
  const PrincipalMoments I(0.3, 0.3, 0.3);
  const RigidBodyState start = random.state();
  EXPECT_LE(test::q_error(SymmetricMotion(I, start).at(3).q_SB, UniformMotion(I, start).at(3).q_SB),
            4 * kEps);
}

TEST(SymmetricMotion, OmegaAloneIsTheSameToTheBit) {
  Random random(7);
  const SymmetricMotion motion(random.symmetric_moments(), random.state());
  for (double t = -10; t < 10; t += 0.37) EXPECT_EQ(motion.w_B_at(t), motion.at(t).w_B);
}

TEST(SymmetricMotion, OmegaCirclesTheAxisAtNu) {
  const SymmetricMotion motion(PrincipalMoments(1, 1, 1.5), {Quat::Identity(), {0.1, 0, 2}});
  const Vec3 expected(0.1 * std::cos(0.5), 0.1 * std::sin(0.5), 2);  // ν = 2 (1.5 − 1)/1
  EXPECT_LE((motion.w_B_at(0.5) - expected).norm(), 0.1 * 4 * kEps);
}

TEST(SymmetricMotion, RefusesOtherBodiesAndStates) {
  EXPECT_THROW(SymmetricMotion(PrincipalMoments(1, 1.75, 2.5), {}), std::domain_error);
  EXPECT_THROW(SymmetricMotion(PrincipalMoments(1, 1, 1.5), {Quat(0, 0, 0, 0), Vec3::Zero()}),
               std::domain_error);
  EXPECT_THROW(SymmetricMotion(PrincipalMoments(1, 1, 1.5), {Quat::Identity(), {INFINITY, 0, 0}}),
               std::domain_error);
  EXPECT_EQ(SymmetricMotion(PrincipalMoments(1, 1, 1.5), {}).method(), "symmetric");
}

}  // namespace
}  // namespace polhode
