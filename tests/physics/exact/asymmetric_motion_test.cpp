// SPDX-License-Identifier: MIT
// Accuracy, extremes and symmetries have files of their own: extremes_test.cpp, unseen_bodies_test.cpp,
// exact_properties_test.cpp.
#include "physics/exact/asymmetric_motion.h"

#include "physics/body/euler.h"
#include "physics/geometry/poinsot.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

using test::attitude_rate;
using test::kEps;
using test::Random;
using Series = AsymmetricMotion::Series;

TEST(AsymmetricMotion, SumsTheSeriesThatConverges) {
  const auto series_of = [](const PrincipalMoments& I, const Vec3& w_B) {
    return AsymmetricMotion(I, {Quat::Identity(), w_B}).series();
  };
  EXPECT_EQ(series_of(PrincipalMoments(1, 2, 3), {.1, .2, 1.5}), Series::in_nome);
  EXPECT_EQ(series_of(PrincipalMoments(1, 2, 3), {.34641, 1.5, .2}), Series::in_complementary_nome);
  EXPECT_EQ(series_of(PrincipalMoments(3, 4, 6), {2, .3, 1}), Series::separatrix);
}

// Each series, both sides of the separatrix, all axis orders and octants, both signs of t.
TEST(AsymmetricMotion, ObeysTheEquationsOfMotion) {
  Random random(1);
  std::array<int, 2> used{};
  for (int i = 0; i < 4000; ++i) {
    const PrincipalMoments I = random.moments();
    const AsymmetricMotion motion(I, random.state());
    ++used[motion.series() == Series::in_nome ? 0 : 1];
    const double t = random.uniform(-20, 20);
    const RigidBodyState state = motion.at(t);
    const double h = 0x1p-16;  // central differences: error (rate)³h²/6 + ε/h; no rate exceeds 5·|ω|
    const double rate = 1 + 5 * state.w_B.norm();
    const double tolerance = rate * rate * rate * rate * h * h + rate * 1e3 * kEps / h;
    const RigidBodyState before = motion.at(t - h), after = motion.at(t + h);
    EXPECT_LE(((after.w_B - before.w_B) / (2 * h) - angular_acceleration_B(I, state.w_B)).norm(), tolerance);
    // The difference also tells that the sign of q is continuous.
    EXPECT_LE(((after.q_SB.coeffs() - before.q_SB.coeffs()) / (2 * h) - attitude_rate(state.q_SB, state.w_B))
                  .norm(),
              tolerance);
  }
  EXPECT_GT(used[0], 500);
  EXPECT_GT(used[1], 50);
}

TEST(AsymmetricMotion, KeepsTheSignOfTheQuaternionOnTheSeparatrix) {
  for (const double sign_a : {1.0, -1.0})
    for (const double sign_c : {1.0, -1.0}) {
      const AsymmetricMotion motion(PrincipalMoments(3, 4, 6), {Quat::Identity(), {2 * sign_a, .3, sign_c}});
      ASSERT_EQ(motion.series(), Series::separatrix);
      Quat last = motion.at(-30).q_SB;
      for (double t = -30; t < 30; t += 0.01) {
        const Quat q_SB = motion.at(t).q_SB;
        EXPECT_GT(q_SB.dot(last), 0.999) << t;
        last = q_SB;
      }
    }
}

TEST(AsymmetricMotion, StartsAtItsStartAndReturnsToOmegaAfterAPeriod) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const PrincipalMoments I = random.moments();
    const RigidBodyState start = random.state();
    const AsymmetricMotion motion(I, start);
    EXPECT_TRUE(test::same_bits(motion.at(0), checked(start)));
    EXPECT_EQ(motion.w_B_at(-0.0), start.w_B);
    const double soon = 1e-300;  // the formula itself, at a time too short to move
    EXPECT_LE(test::w_error(motion.at(soon).w_B, start.w_B), 8 * kEps);
    EXPECT_LE(test::q_error(motion.at(soon).q_SB, start.q_SB), 8 * kEps);
    const double P = *polhode_period(I, start.w_B);
    // P is rounded, by ε P, and ω̇ P ≤ 40 |ω| away from the separatrix
    EXPECT_LE(test::w_error(motion.w_B_at(P), start.w_B), 400 * kEps) << i;
  }
}

TEST(AsymmetricMotion, GivesOmegaAloneToTheBit) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const AsymmetricMotion motion(random.moments(), random.state());
    const double t = random.uniform(-100, 100);
    EXPECT_EQ(motion.at(t).w_B, motion.w_B_at(t));
  }
}

TEST(AsymmetricMotion, HasNoStateAtATimeThatIsNone) {
  for (const Vec3& w_B : {Vec3(.1, .2, 1.5), Vec3(.34641, 1.5, .2)}) {
    const AsymmetricMotion motion(PrincipalMoments(1, 2, 3), {Quat::Identity(), w_B});
    const RigidBodyState state = motion.at(NAN);
    EXPECT_TRUE(state.w_B.array().isNaN().all());
    EXPECT_TRUE(state.q_SB.coeffs().array().isNaN().all());
  }
}

TEST(AsymmetricMotion, LeavesOtherBodiesToOtherFormulas) {
  EXPECT_THROW(AsymmetricMotion(PrincipalMoments(1, 1, 1.5), {Quat::Identity(), {1, 2, 3}}),
               std::domain_error);
  EXPECT_THROW(AsymmetricMotion(PrincipalMoments(1, 2, 2.5), {Quat::Identity(), {0, 2, 0}}),
               std::domain_error);
  EXPECT_THROW(AsymmetricMotion(PrincipalMoments(1, 2, 2.5), {Quat::Identity(), {NAN, 2, 0}}),
               std::domain_error);
}

}  // namespace
}  // namespace polhode
