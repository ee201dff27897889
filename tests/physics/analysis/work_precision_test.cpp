// SPDX-License-Identifier: MIT
#include "physics/analysis/work_precision.h"

#include "base/stopwatch.h"
#include "physics/analysis/conditioning.h"
#include "physics/geometry/poinsot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

using testing::ElementsAre;
using Rows = std::vector<WorkPrecisionRow>;

WorkPrecisionRow row(double ns, double error_omega, double error_attitude_rad) {
  WorkPrecisionRow made;
  made.ns_per_period = ns;
  made.error_omega = error_omega;
  made.error_attitude_rad = error_attitude_rad;
  return made;
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
  const Rows rows = {row(1, 1e-2, 5e-2),                        // the fastest
                     row(2, 1e-3, 1e-2),                        // faster than the next and as accurate
                     row(3, 1e-2, 1e-2),  row(4, 1e-9, 1e-9),   // the most accurate
                     row(4, 1e-9, 1e-9),                        // nothing beats its equal
                     row(5, 1e-9, 1e-9),  row(0.1, NAN, 1e-9),  // no result at all
                     row(0.1, 1e-9, NAN), row(0.1, 1e-9, 1)};   // no answer
  EXPECT_THAT(pareto_front(rows), ElementsAre(true, true, false, true, true, false, false, false, false));
}

TEST(ParetoFront, StepByStepLeavesTheClosedFormAside) {
  Rows rows = {row(1, 0, 0), row(9, 1e-6, 1e-6), row(10, 1e-5, 1e-5)};
  rows[1].method = rows[2].method = Method::rk4;
  EXPECT_THAT(pareto_front(rows), ElementsAre(true, false, false));
  EXPECT_THAT(front_step_by_step(rows), ElementsAre(false, true, false));
}

TEST(ParetoFront, OfNothingIsNothing) { EXPECT_TRUE(pareto_front(Rows{}).empty()); }

TEST(CheapestWithin, AsksBothErrors) {
  const Rows rows = {row(1, 1e-9, 1e-2), row(2, 1e-2, 1e-9), row(9, 1e-7, 1e-7), row(5, 1e-6, 1e-7),
                     row(0.1, NAN, 0)};
  EXPECT_EQ(cheapest_within(rows, 1e-6), 3u);  // equal to the tolerance is within
  EXPECT_EQ(cheapest_within(rows, 1e-2), 0u);
  EXPECT_EQ(cheapest_within(rows, 5e-7), 2u);
  EXPECT_EQ(cheapest_within(rows, 1e-8), std::nullopt);
}

const Problem kFree{PrincipalMoments(1, 2, 3), {Quat::Identity(), Vec3(0.1, 1.5, 0.2)}, {}};

WorkPrecisionPlan plan_with(std::vector<Method> methods, double periods, int most_settings) {
  WorkPrecisionPlan plan;
  plan.period_s = polhode_period(kFree.I, kFree.start.w_B).value();
  plan.periods = periods;
  plan.methods = std::move(methods);
  plan.most_settings = most_settings;
  plan.cpu_seconds = 1e3;  // the number of rows must not hang on the speed of the machine
  return plan;
}

WorkPrecision measured(const Problem& problem, const WorkPrecisionPlan& plan) {
  return measure_work_precision(problem, plan, [](std::size_t) {}).value();
}

TEST(WorkPrecision, ErrorsFallWithTheOrder) {
  const std::vector<Method> methods = {Method::explicit_midpoint, Method::rk4, Method::moser_veselov_6};
  const auto found = measured(kFree, plan_with(methods, 1, 7));
  ASSERT_EQ(found.rows.size(), 7 * methods.size());
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const auto& coarse = found.rows[7 * m + 5];
    const auto& fine = found.rows[7 * m + 6];
    ASSERT_EQ(fine.method, methods[m]);
    EXPECT_EQ(*fine.step_s, *coarse.step_s / 2);
    const double order = facts_of(methods[m]).order;
    EXPECT_NEAR(std::log2(coarse.error_omega / fine.error_omega), order, 0.3) << name_of(fine.method);
    EXPECT_NEAR(std::log2(coarse.error_attitude_rad / fine.error_attitude_rad), order, 0.3);
    EXPECT_GT(fine.ns_per_period, 0);
  }
}

TEST(WorkPrecision, TolerancesFallByDecadesAndErrorsWithThem) {
  const auto found = measured(kFree, plan_with({Method::dormand_prince_8}, 2, 7));
  ASSERT_EQ(found.rows.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(std::log10(*found.rows[i].tolerance), -3.0 - static_cast<double>(i), 1e-12);
    EXPECT_FALSE(found.rows[i].step_s);
  }
  EXPECT_LT(found.rows[6].error(), 1e-3 * found.rows[0].error());
}

// VERIFY A1: the closed form was said to have the error 0 after any time, and was recommended for any
// tolerance.
TEST(WorkPrecision, NoRowIsBetterThanItsReference) {
  const std::vector<Method> methods = {Method::exact, Method::moser_veselov_10, Method::dormand_prince_8};
  for (const double periods : {1.0, 20.0}) {
    const auto plan = plan_with(methods, periods, 12);
    const auto found = measured(kFree, plan);
    const double own = closed_form_error(kFree.I, kFree.start.w_B, periods * plan.period_s);
    EXPECT_EQ(found.reference_error, own);
    bool reached = false;
    for (const WorkPrecisionRow& r : found.rows) {
      EXPECT_GE(r.error_omega, own) << name_of(r.method);
      EXPECT_GE(r.error_attitude_rad, own) << name_of(r.method);
      reached = reached || (goes_step_by_step(r.method) && r.error() == own);
    }
    EXPECT_TRUE(reached) << "a good method comes as near as the reference can tell";
  }
}

TEST(WorkPrecision, TheClosedFormIsNotRecommendedBeyondItsError) {
  const auto found = measured(kFree, plan_with({Method::exact}, 1e7, 40));
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_GT(found.rows[0].error(), 1e-12);
  EXPECT_EQ(cheapest_within(found.rows, 1e-12), std::nullopt);
  EXPECT_EQ(cheapest_within(found.rows, 1e-6), 0u);
}

TEST(WorkPrecision, TheClosedFormIsOneRowAndTheMeasure) {
  const auto found = measured(kFree, plan_with({Method::exact}, 100, 40));
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_EQ(found.rows[0].evaluations, 1);
  EXPECT_EQ(found.rows[0].error(), found.reference_error);
  EXPECT_LT(found.rows[0].drift_T, 1e-12);
  EXPECT_LT(found.rows[0].drift_L_direction_rad, 1e-12);
  EXPECT_FALSE(found.rows[0].step_s || found.rows[0].tolerance);
}

// Without time there is one row of each method; none of those that would take 1e10 steps.
TEST(WorkPrecision, EndsWithTheTimeAndWithTheReach) {
  WorkPrecisionPlan plan = plan_with({Method::exact, Method::rk4, Method::dormand_prince_8}, 3, 40);
  plan.cpu_seconds = 1e-9;
  EXPECT_EQ(measured(kFree, plan).rows.size(), 3u);
  plan.periods = 1e9;
  const auto found = measured(kFree, plan);
  EXPECT_EQ(found.rows.size(), 1u);
  EXPECT_THAT(found.out_of_reach, ElementsAre(Method::rk4, Method::dormand_prince_8));
}

// Steps as short as the torque wants them would take a hundred times the seconds there are, and the reference
// would be no answer at their end.
TEST(WorkPrecision, EndsWithTheTimeUnderAStiffTorque) {
  const Problem stiff{
      PrincipalMoments(1, 1.75, 2.5), {Quat::Identity(), Vec3(0.9, 0.4, 1.0)}, {LinearDamping{1e6}}};
  WorkPrecisionPlan plan = plan_with({Method::dormand_prince_8}, 3, 40);
  plan.cpu_seconds = 0.3;
  const double start_s = cpu_time_s();
  EXPECT_FALSE(measure_work_precision(stiff, plan, [](std::size_t) {}));
  EXPECT_LT(cpu_time_s() - start_s, 20 * plan.cpu_seconds) << "sanitizers take ten times as long";
}

TEST(WorkPrecision, StepsAreNoLongerThanTheMotion) {
  const auto found = measured(kFree, plan_with({Method::rk4}, 1e-3, 1));
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_LE(*found.rows[0].step_s, 1e-3 * plan_with({}, 1, 1).period_s);
}

// A million periods by explicit steps would take minutes, whatever the method and however short the time
// given.
TEST(WorkPrecision, LeavesOutWhatTheTimeCannotReach) {
  WorkPrecisionPlan plan = plan_with({Method::exact, Method::rk4, Method::dormand_prince_8}, 1e6, 40);
  plan.cpu_seconds = 1;
  const auto found = measured(kFree, plan);
  EXPECT_EQ(found.rows.size(), 1u);
  EXPECT_THAT(found.out_of_reach, ElementsAre(Method::rk4, Method::dormand_prince_8));
}

TEST(WorkPrecision, EndsWhereRoundingDoes) {
  const auto found = measured(kFree, plan_with({Method::rk4}, 1, 40));
  EXPECT_LT(found.rows.size(), 20u);  // measured 13: 10·2¹² steps
  EXPECT_LT(found.rows.back().error(), 1e-11);
}

TEST(WorkPrecision, TriesNoStepThatMissesTheTurning) {
  // A near-sphere: its polhode period takes 3e3 turns.
  const Problem near_sphere{PrincipalMoments(1, 1.0004, 1.001), kFree.start, {}};
  WorkPrecisionPlan plan = plan_with({Method::rk4}, 1, 1);
  plan.period_s = polhode_period(near_sphere.I, near_sphere.start.w_B).value();
  const auto found = measured(near_sphere, plan);
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_LT(*found.rows[0].step_s * kFree.start.w_B.norm(), M_PI);
}

TEST(WorkPrecision, UnderATorqueNothingIsSaidToBeBetterThanTheReference) {
  Problem damped = kFree;
  damped.torque = {LinearDamping{0.1}};
  const auto found =
      measured(damped, plan_with({Method::rk4, Method::dormand_prince_5, Method::dormand_prince_8}, 2, 11));
  EXPECT_LT(found.reference_error, 1e-10);
  for (const WorkPrecisionRow& r : found.rows) {
    EXPECT_GE(r.error(), found.reference_error);
    EXPECT_TRUE(std::isnan(r.drift_T) && std::isnan(r.drift_L) && std::isnan(r.drift_L_direction_rad));
  }
  EXPECT_LT(found.rows.back().error(), 1e-8);
}

TEST(WorkPrecision, ASinkKeepsLInSpace) {
  Problem brake = kFree;
  brake.torque = {EnergySink{0.1}};
  const auto found = measured(brake, plan_with({Method::dormand_prince_8}, 2, 9));
  EXPECT_TRUE(std::isnan(found.rows.back().drift_T));
  EXPECT_LT(found.rows.back().drift_L, 1e-6);
  EXPECT_LT(found.rows.back().drift_L_direction_rad, 1e-6);
}

TEST(WorkPrecision, RefusesAMotionWithoutAnEnd) {
  EXPECT_FALSE(measure_work_precision(kFree, plan_with({Method::exact}, 1e308, 1), [](std::size_t) {}));
}

}  // namespace
}  // namespace polhode
