// SPDX-License-Identifier: MIT
#include "physics/exact/uniform_motion.h"

#include "physics/body/euler.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;

TEST(IsSteady, OnPrincipalAxesAndForEqualMoments) {
  const PrincipalMoments distinct(1, 1.75, 2.5), oblate(1, 1, 1.5), sphere(1, 1, 1);
  EXPECT_TRUE(is_steady(distinct, {0, 0, 0}));
  EXPECT_TRUE(is_steady(distinct, {1, 0, 0}));
  EXPECT_TRUE(is_steady(distinct, {0, -1, -0.0}));
  EXPECT_TRUE(is_steady(oblate, {1, 2, 0}));
  EXPECT_TRUE(is_steady(oblate, {0, 0, 2}));
  EXPECT_TRUE(is_steady(sphere, {1, 2, 3}));
  EXPECT_FALSE(is_steady(distinct, {1, 1, 0}));
  EXPECT_FALSE(is_steady(oblate, {1, 0, 1}));
}

TEST(IsSteady, HasNoTolerance) {
  EXPECT_FALSE(is_steady(PrincipalMoments(1, 1.75, 2.5), {1, 1e-300, 0}));
  EXPECT_FALSE(is_steady(PrincipalMoments(1, 1.75, 2.5), {1e-200, 1e-200, 0}));  // the product underflows
  EXPECT_FALSE(is_steady(PrincipalMoments(1, 1 + 0x1p-52, 1), {1, 1, 0}));
}

TEST(IsSteady, AgreesWithTheReferenceCases) {
  for (const test::ReferenceCase& c : test::reference_cases()) {
    EXPECT_EQ(is_steady(c.I, c.start.w_B), c.kind == "steady") << c.name;
  }
}

TEST(UniformMotion, MatchesTheReference) {
  int checked_states = 0;
  for (const test::ReferenceCase& c : test::reference_cases()) {
    if (c.kind != "steady") continue;
    const UniformMotion motion(c.I, c.start);
    for (const test::ReferenceState& truth : c.states) {
      const RigidBodyState state = motion.at(truth.t_s);
      EXPECT_EQ(state.w_B, c.start.w_B) << c.name;
      EXPECT_LE(test::q_error(state.q_SB, truth.state.q_SB), 4 * kEps * (1 + truth.cond_q))
          << c.name << " " << truth.t_s;
      ++checked_states;
    }
  }
  EXPECT_GE(checked_states, 25);
}

TEST(UniformMotion, TurningTheStartTurnsTheMotion) {
  test::Random random(1);
  const PrincipalMoments I(1, 1, 1);
  for (int i = 0; i < 100; ++i) {
    const RigidBodyState start = random.state();
    const Quat p = random.attitude();
    const double t = random.uniform(-10, 10);
    const Quat turned = UniformMotion(I, {p * start.q_SB, start.w_B}).at(t).q_SB;
    EXPECT_LE(test::q_error(turned, p * UniformMotion(I, start).at(t).q_SB), 16 * kEps);
  }
}

TEST(UniformMotion, ExtremeRatesAndTimesStayUnit) {
  const PrincipalMoments I(1, 1, 1);
  for (const double w : {1e-310, 1e-160, 1.0, 1e160, 1e300}) {
    for (const double t : {0.0, 1e-300, 1.0, -1e300}) {
      const RigidBodyState state = UniformMotion(I, {Quat::Identity(), {w, -w, w}}).at(t);
      EXPECT_NEAR(state.q_SB.norm(), 1, 4 * kEps) << w << " " << t;
    }
  }
}

TEST(UniformMotion, SubnormalRatesLoseNoDigits) {
  const double w = 0x1.8p-1060, t = 0x1p1023;
  EXPECT_EQ(rotation_by({w, 0, 0}, t).x(), std::sin(0x1.8p-38));
}

TEST(UniformMotion, RefusesWhatIsNotSteadyOrNotFinite) {
  const PrincipalMoments I(1, 1.75, 2.5);
  EXPECT_THROW(UniformMotion(I, {Quat::Identity(), {1, 1, 0}}), std::domain_error);
  EXPECT_THROW(UniformMotion(I, {Quat::Identity(), {std::numeric_limits<double>::quiet_NaN(), 0, 0}}),
               std::domain_error);
  EXPECT_EQ(UniformMotion(I, {Quat::Identity(), {1, 0, 0}}).method(), "uniform");
}

}  // namespace
}  // namespace polhode
