// SPDX-License-Identifier: MIT
#include "physics/effort.h"

#include "physics/integrators/dormand_prince.h"
#include "physics/integrators/subnormal.h"
#include "physics/method.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace polhode {
namespace {

const PrincipalMoments kI(1, 1.75, 2.5);
const Problem kHeavy{kI, {Quat::Identity(), {0.3, 0.2, 2.0}}, {HeavyTop{1.5, Vec3::UnitZ()}}};
const Problem kFree{kI, {Quat::Identity(), {0.3, 2.0, 0.2}}, {}};

/// One of every kind of motion that goes step by step.
const std::vector<std::pair<Problem, MethodChoice>> kStepping = {
    {kHeavy, {Method::dormand_prince_8}},
    {kHeavy, {Method::dormand_prince_5}},
    {kHeavy, {Method::rk4, 1e-3}},
    {kFree, {Method::rk4_projected, 1e-3}},
    {kFree, {Method::splitting, 1e-3}},
    {kFree, {Method::implicit_midpoint, 1e-3}},
    {kFree, {Method::moser_veselov_6, 1e-3}},
};

bool same(const RigidBodyState& a, const RigidBodyState& b) {
  return a.w_B == b.w_B && a.q_SB.coeffs() == b.q_SB.coeffs();
}

TEST(Budget, ThrowsFromItsEndOn) {
  Budget budget(10);
  budget.spend(9);
  EXPECT_FALSE(budget.is_spent());
  EXPECT_THROW(budget.spend(1), BudgetSpent);
  EXPECT_TRUE(budget.is_spent());
  EXPECT_THROW(budget.spend(0), BudgetSpent);
}

TEST(Budget, IsNotFooledByHugeNumbers) {
  Budget budget(10);
  EXPECT_THROW(budget.spend(std::numeric_limits<std::int64_t>::max()), BudgetSpent);
  EXPECT_THROW(budget.spend(std::numeric_limits<std::int64_t>::max()), BudgetSpent);
}

TEST(Effort, IsToldAllThatAMotionCosts) {
  for (const auto& [problem, choice] : kStepping) {
    std::int64_t told = 0;
    const auto motion = make_motion(problem, choice, [&](std::int64_t n) { told += n; });
    const double t_s = 20.0005;
    static_cast<void>(motion->at(t_s));
    const std::int64_t needed = motion->evaluations_to(t_s);
    EXPECT_GT(needed, 0) << name_of(choice.method);
    EXPECT_GE(told, 0.99 * double(needed)) << name_of(choice.method);
  }
}

TEST(Effort, TellsOftenEnoughToStopWithinMilliseconds) {
  for (const auto& [problem, choice] : kStepping) {
    std::int64_t longest = 0;
    const auto motion = make_motion(problem, choice, [&](std::int64_t n) { longest = std::max(longest, n); });
    static_cast<void>(motion->at(1000));
    EXPECT_LT(longest, 20'000) << name_of(choice.method);  // at some 50 to 200 ns each
  }
}

TEST(Effort, SubnormalNumbersAreAsDearAsTheyAre) {
  // Without energy to lose ω ends along one axis: the other two components fall below 1e-308 by t = 1e4 s.
  const Problem damped{kI, {Quat::Identity(), {0.2, 3.0, 0.1}}, {EnergySink{0.05}}};
  std::int64_t told = 0;
  const auto motion = make_motion(damped, {Method::dormand_prince_8}, [&](std::int64_t n) { told += n; });
  static_cast<void>(motion->at(8'000));
  told = 0;
  const std::int64_t before = motion->evaluations_to(1'000), after = motion->evaluations_to(8'000);
  static_cast<void>(motion->at(1e4));
  const std::int64_t more = motion->evaluations_to(1e4) - after;
  ASSERT_TRUE(any_subnormal(motion->at(1e4).w_B[0]));
  EXPECT_GT(told, 10 * more) << before << ' ' << after;
}

TEST(Effort, ThatStopsAMotionLeavesItAsItWas) {
  for (const auto& [problem, choice] : kStepping) {
    const auto fresh = make_motion(problem, choice);
    std::int64_t left = 7000;
    const auto stopped = make_motion(problem, choice, [&](std::int64_t n) {
      left -= n;
      if (left < 0) throw BudgetSpent();
    });
    EXPECT_THROW(static_cast<void>(stopped->at(500)), BudgetSpent) << name_of(choice.method);
    EXPECT_THROW(static_cast<void>(stopped->at(500)), BudgetSpent) << name_of(choice.method);
    left = std::numeric_limits<std::int64_t>::max();
    for (const double t_s : {500.0, 0.25, 3.0, -2.0})
      EXPECT_TRUE(same(stopped->at(t_s), fresh->at(t_s))) << name_of(choice.method) << " at " << t_s;
  }
}

// What it had reached is reached: only the rest of the way is to be gone.
TEST(Effort, ThatStopsAMotionHalfWayKeepsTheGroundThatWasGained) {
  const double t_s = 500;
  for (const auto& [problem, choice] : kStepping) {
    const auto fresh = make_motion(problem, choice);
    const std::int64_t whole = fresh->evaluations_to(t_s);
    std::int64_t left = whole / 2, told = 0;
    const auto stopped = make_motion(problem, choice, [&](std::int64_t n) {
      told += n;
      if (told > left) throw BudgetSpent();
    });
    EXPECT_THROW(static_cast<void>(stopped->at(t_s)), BudgetSpent) << name_of(choice.method);
    told = 0, left = std::numeric_limits<std::int64_t>::max();
    EXPECT_TRUE(same(stopped->at(t_s), fresh->at(t_s))) << name_of(choice.method);
    EXPECT_GT(told, 0) << name_of(choice.method);
    EXPECT_LT(told, 0.6 * double(whole)) << name_of(choice.method) << ": a half, and one checkpoint's way";
  }
}

TEST(TooFar, IsWhatTakesMoreStepsThanAreMade) {
  const DormandPrinceMotion motion(DormandPrincePair::eight_five_three, kHeavy, 1e-10, 100);
  EXPECT_TRUE(motion.at(1).w_B.allFinite());
  EXPECT_FALSE(motion.is_too_far(1));
  EXPECT_FALSE(motion.at(1000).w_B.allFinite());
  EXPECT_TRUE(motion.is_too_far(1000));
  EXPECT_TRUE(motion.is_too_far(-1000));
  EXPECT_NE(why_no_state(motion, kHeavy, 1000).find("more steps"), std::string::npos);
}

TEST(WhyNoState, SaysNothingOfATorqueWhereThereIsNone) {
  const auto euler = make_motion(kFree, {Method::explicit_euler, 0.5});
  ASSERT_FALSE(euler->at(1e4).w_B.allFinite());
  ASSERT_FALSE(euler->is_too_far(1e4));
  const std::string free = why_no_state(*euler, kFree, 1e4);
  EXPECT_NE(free.find("step is too long"), std::string::npos) << free;
  EXPECT_EQ(free.find("torque"), std::string::npos) << free;

  const Problem torn{kI, kFree.start, {BodyTorque{{1e200, 0, 0}}}};
  const auto rk4 = make_motion(torn, {Method::rk4, 0.5});
  ASSERT_FALSE(rk4->at(9).w_B.allFinite());
  EXPECT_NE(why_no_state(*rk4, torn, 9).find("torque"), std::string::npos);
  EXPECT_NE(why_no_state(*euler, kFree, 1e300).find("more steps"), std::string::npos);
}

}  // namespace
}  // namespace polhode
