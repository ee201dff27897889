// SPDX-License-Identifier: MIT
#include "app/session/method_cost.h"

#include "app/session/accuracy_meter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

namespace polhode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Scene scene_with(const MotionSpec& motion) {
  Scene scene;
  scene.body.moments = PrincipalMoments(1, 2, 3);
  scene.w0_B = Vec3(0.1, 1.5, 0.2);
  scene.show = {Overlay::shape, Overlay::omega};
  scene.motion = motion;
  return scene;
}

AccuracyReading meter_of(const Scene& scene, double t_s) {
  const SceneModel model = make_model(scene, ModelFor::page);
  return AccuracyMeter(model).at(model, t_s);
}

TEST(AccuracyMeter, WhatIsExactHasNoErrorAndKeepsItsInvariants) {
  const AccuracyReading meter = meter_of(scene_with({}), 100);
  EXPECT_FALSE(meter.error);
  EXPECT_LT(meter.drift.T, 1e-12);
  EXPECT_LT(meter.drift.L_direction_rad, 1e-12);
  EXPECT_GT(meter.ns_per_frame, 0);
}

TEST(AccuracyMeter, TheErrorIsThatAgainstTheExactMotion) {
  const Scene scene = scene_with({.method = Method::rk4, .step_s = 0.2});
  const double t_s = 40;
  const AccuracyReading meter = meter_of(scene, t_s);
  const Problem problem = problem_of(scene);
  const StateError want = error_of(make_motion(problem, {Method::rk4, 0.2})->at(t_s),
                                   make_motion(problem, {Method::exact})->at(t_s));
  ASSERT_TRUE(meter.error);
  EXPECT_EQ(meter.error->omega, want.omega);
  EXPECT_EQ(meter.error->attitude_rad, want.attitude_rad);
  EXPECT_GT(want.omega, 1e-6);  // else nothing was compared
}

TEST(AccuracyMeter, ErrorAndDriftVanishAtTheStart) {
  const AccuracyReading meter = meter_of(scene_with({.method = Method::rk4, .step_s = 0.2}), 0);
  EXPECT_EQ(meter.error.value().omega, 0);
  EXPECT_EQ(meter.error.value().attitude_rad, 0);
  EXPECT_LT(meter.drift.L, 1e-15);
}

// Explicit Euler gains energy at every step, so that the largest drift is the one at the end.
TEST(AccuracyMeter, TheDriftIsTheLargestOnTheWay) {
  const Scene scene = scene_with({.method = Method::explicit_euler, .step_s = 0.01});
  const SceneModel model = make_model(scene, ModelFor::page);
  const AccuracyMeter meter(model);
  const double t_s = 20;
  const RigidBodyState end = model.motion->at(t_s);
  EXPECT_EQ(meter.at(model, t_s).drift.T, drift_along(problem_of(scene), {&end, 1}).T);
  EXPECT_GT(meter.at(model, 2 * t_s).drift.T, 1.5 * meter.at(model, t_s).drift.T);
  EXPECT_GT(meter.at(model, -t_s).drift.T, 0);
}

TEST(AccuracyMeter, TorqueLeavesNothingToCompareWith) {
  Scene scene = scene_with({});
  scene.torque = {LinearDamping{0.1}};
  const AccuracyReading meter = meter_of(scene, 5);
  EXPECT_FALSE(meter.error);
  EXPECT_TRUE(std::isnan(meter.drift.T) && std::isnan(meter.drift.L));
  EXPECT_GT(meter.ns_per_frame, 0);
}

TEST(AccuracyMeter, BeyondTheReachAllIsNaN) {
  const Scene scene = scene_with({.method = Method::rk4, .step_s = 1e-9});
  const SceneModel model = make_model(scene, ModelFor::page);
  const AccuracyReading meter = AccuracyMeter(model).at(model, 100 * model.motion->max_time_s());
  EXPECT_TRUE(std::isnan(meter.error.value().omega));
  EXPECT_TRUE(std::isnan(meter.drift.T) && std::isnan(meter.ns_per_frame));
}

TEST(AccuracyMeter, ABodyAtRestHasATradeToo) {
  Scene scene = scene_with({});
  scene.w0_B = Vec3::Zero();
  EXPECT_TRUE(std::isnan(meter_of(scene, 1).drift.T));
}

// Ten times the steps cost ten times the time; a way that is known already makes them no cheaper.
TEST(AccuracyMeter, AFrameCostsWhatItsStepsCost) {
  const auto ns_with_step = [](double step_s) {
    const SceneModel model =
        make_model(scene_with({.method = Method::rk4_projected, .step_s = step_s}), ModelFor::page);
    static_cast<void>(model.motion->at(2));
    return AccuracyMeter(model).at(model, 1).ns_per_frame;
  };
  const double frame_s = make_model(scene_with({}), ModelFor::page).rate / 25;
  const double ratio = ns_with_step(frame_s / 20'000) / ns_with_step(frame_s / 2000);
  EXPECT_GT(ratio, 4);
  EXPECT_LT(ratio, 25);
}

WorkPrecisionRow row(Method method, double ns, double error) {
  WorkPrecisionRow made;
  made.method = method;
  if (method == Method::rk4) made.step_s = 0.02;
  if (method == Method::dormand_prince_8) made.tolerance = 1e-6;
  made.ns_per_period = ns;
  made.error_omega = made.error_attitude_rad = error;
  return made;
}

TEST(ParetoSteps, GoFromFastToAccurateWithTheClosedFormLast) {
  const auto steps = pareto_steps({row(Method::exact, 1, 0), row(Method::dormand_prince_8, 9, 1e-6),
                                   row(Method::rk4, 8, 1e-3), row(Method::rk4, 20, 1e-5)});
  std::vector<std::string> names;
  for (const ParetoStep& step : steps) names.push_back(named_in(Language::en, step.choice));
  EXPECT_THAT(names,
              ElementsAre("rk4, step 0.02 s", "dormand-prince-8, tolerance 1e-6", "exact, closed form"));
  EXPECT_EQ(named_in(Language::de, steps[0].choice), "rk4, Schritt 0,02 s");
  EXPECT_EQ(named_in(Language::de, steps[2].choice), "exact, geschlossene Form");
  EXPECT_EQ(steps[1].choice.tolerance, 1e-6);
  EXPECT_EQ(steps[1].error, 1e-6);
  EXPECT_EQ(steps[1].ns_per_period, 9);
}

std::vector<ParetoStep> measured(const Problem& problem) {
  FrontMeasurement measurement(problem, 0.2);
  while (!measurement.is_ready()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const auto steps = measurement.steps();
  EXPECT_EQ(measurement.steps().size(), steps.size());  // asked again
  return steps;
}

TEST(FrontMeasurement, EachStepIsMoreAccurateAndMakesAMotion) {
  const Problem problem = problem_of(scene_with({}));
  const auto steps = measured(problem);
  ASSERT_GT(steps.size(), 2u);
  EXPECT_EQ(steps.back().choice.method, Method::exact);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_LE(steps[i].error, steps[i - 1].error);
  for (std::size_t i = 2; i < steps.size(); ++i)
    EXPECT_GE(steps[i - 1].ns_per_period, steps[i - 2].ns_per_period);
  for (const ParetoStep& step : steps)
    EXPECT_NO_THROW(make_motion(problem, step.choice)) << named_in(Language::en, step.choice);
}

TEST(FrontMeasurement, UnderATorqueThereIsNoClosedForm) {
  Problem problem = problem_of(scene_with({}));
  problem.torque = {LinearDamping{0.1}};
  const auto steps = measured(problem);
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(steps.back().choice.method, Method::exact);
}

TEST(FrontMeasurement, NothingIsMeasuredOfABodyAtRest) {
  Problem problem = problem_of(scene_with({}));
  problem.start.w_B = Vec3::Zero();
  EXPECT_THAT(measured(problem), IsEmpty());
}

TEST(FrontMeasurement, IsLeftWithoutWaitingForItsEnd) {
  const auto start = std::chrono::steady_clock::now();
  {
    const FrontMeasurement measurement(problem_of(scene_with({})), 60);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(measurement.is_ready());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

}  // namespace
}  // namespace polhode
