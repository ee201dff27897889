// SPDX-License-Identifier: MIT
// The tops of FORMAT.md's recipes do what their text says: the motion that the program computes is held
// against Euler's angles by Runge-Kutta steps of our own, and what is promised against both.
#include "lessons/reader/reader.h"
#include "physics/body/euler_angles.h"
#include "physics/method.h"
#include "render/scene/model/scene_problem.h"
#include "tests/lessons/support.h"
#include "tests/support/euler_angle_top.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kSamples = 400;
// A disc of 1 kg, 12 cm across and 2 cm thick, 12 cm from the pivot, by hand.
constexpr double kI1 = 0.0036 / 4 + 0.0004 / 12 + 0.0144, kI3 = 0.0036 / 2, kMgl = 9.80665 * 0.12;

const Lesson& recipes() {
  static const Lesson kLesson = [] {
    const std::string text = testing::read_file(test::source_dir() / "lessons" / "FORMAT.md");
    const std::string opening = "\n````markdown\n";
    const std::size_t begin = text.find(opening, text.find("\n## Recipes\n")) + opening.size();
    LessonReading reading =
        read_lesson(text.substr(begin, text.find("\n````\n", begin) + 1 - begin), "recipes.md");
    if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
    EXPECT_THAT(testing::lines_of(reading.diagnostics), ::testing::IsEmpty());
    return std::move(*reading.lesson);
  }();
  return kLesson;
}

const Scene& scene_of(std::string_view stage, std::size_t step = 0) {
  return *recipes().find_stage(stage)->steps.at(step).scene;
}

struct Sample {
  double theta, phi, theta_rate, phi_rate;
};

/// Over the scene's duration, by the program; both ways are the same.
std::vector<Sample> motion_of(const Scene& scene) {
  const Problem problem = problem_of(scene);
  const auto motion = make_motion(problem, {default_method(problem), {}, {}});
  const test::EulerAngleTop top{kI1, kI3, kMgl, problem.start.w_B[2]};
  const EulerAngles start = euler_angles_of(problem.start.q_SB);
  test::EulerAngleTop::State y = {start.theta_rad, start.phi_rad, start.psi_rad, 0,
                                  problem.start.w_B[1] / std::sin(start.theta_rad)};
  std::vector<Sample> samples;
  const double step_s = span_s(scene) / kSamples;
  for (int i = 0; i <= kSamples; ++i) {
    const EulerAngles angles = euler_angles_of(motion->at(i * step_s).q_SB);
    // 1e-10 a step of Dormand-Prince, some thousands of them; ours errs by (|ω|h)⁴ |ω|t/120 < 1e-9. What is
    // as little as 1° from the vertical turns about it by as much more.
    const double error = 1e-6;
    EXPECT_NEAR(angles.theta_rad, y[0], error);
    EXPECT_NEAR(std::remainder(angles.phi_rad - y[1], 2 * std::numbers::pi), 0, error / std::sin(y[0]));
    samples.push_back({y[0], y[1], y[3], y[4]});
    y = top.after(y, step_s, 200);
  }
  return samples;
}

template <class Of>
std::pair<double, double> range_of(const std::vector<Sample>& samples, const Of& of) {
  const auto less = [&](const Sample& a, const Sample& b) { return of(a) < of(b); };
  const auto [least, most] = std::minmax_element(samples.begin(), samples.end(), less);
  return {of(*least), of(*most)};
}
double theta(const Sample& s) { return s.theta; }
double phi_rate(const Sample& s) { return s.phi_rate; }

TEST(Recipes, AreALessonWithoutFaultsEachStageWithAScene) {
  ASSERT_EQ(recipes().stages.size(), 5U);
  for (const Stage& stage : recipes().stages)
    for (const Step& step : stage.steps) EXPECT_TRUE(step.scene) << stage.id;
}

TEST(Recipes, ATiltedTopLetGoHasCusps) {
  const auto samples = motion_of(scene_of("cusps"));
  const auto [upper, lower] = range_of(samples, theta);
  EXPECT_NEAR(upper, 60 * kDegree, 1e-9) << "it never rises above where it was";
  EXPECT_GT(lower, 70 * kDegree);
  // φ̇ = (b − a u)/sin²θ with b = a u0: it is 0 at the upper turning point alone, and positive elsewhere.
  EXPECT_NEAR(range_of(samples, phi_rate).first, 0, 1e-9);
  const auto comes_back = std::count_if(samples.begin() + 1, samples.end(), [&](const Sample& s) {
    return s.theta < 60.2 * kDegree && std::abs(s.phi_rate) < 0.2;
  });
  EXPECT_GT(comes_back, 3);
}

TEST(Recipes, APushedBackTopHasLoopsAndOnePushedForwardWaves) {
  const auto loops = range_of(motion_of(scene_of("loops")), phi_rate);
  EXPECT_NEAR(loops.first, -4, 1e-9);
  EXPECT_GT(loops.second, 3);
  const auto samples = motion_of(scene_of("waves"));
  const auto waves = range_of(samples, phi_rate);
  EXPECT_NEAR(waves.first, 2, 1e-9);
  EXPECT_GT(waves.second, 4);
  EXPECT_NEAR(range_of(samples, theta).first, 60 * kDegree, 1e-9);
}

TEST(Recipes, ASteadyTopStaysAtItsTilt) {
  for (std::size_t step : {0U, 1U}) {
    const auto samples = motion_of(scene_of("steady", step));
    const auto [upper, lower] = range_of(samples, theta);
    EXPECT_NEAR(upper, 60 * kDegree, 1e-8);
    EXPECT_NEAR(lower, 60 * kDegree, 1e-8);
    const double b = kI3 * 200, sign = step == 0 ? -1 : 1;
    const double rate = (b + sign * std::sqrt(b * b - 4 * kI1 * 0.5 * kMgl)) / (2 * kI1 * 0.5);
    EXPECT_NEAR(samples.back().phi - samples.front().phi, rate * span_s(scene_of("steady", step)), 1e-7);
    const double without_weight = b / (kI1 * 0.5);
    if (step == 1) {
      EXPECT_NEAR(rate / without_weight, 1, 0.1) << "less than a tenth";
    }
  }
}

TEST(Recipes, ASleepingTopWakesBelowItsLeastSpin) {
  EXPECT_LT(range_of(motion_of(scene_of("sleeping", 0)), theta).second, 1.6 * kDegree);
  EXPECT_NEAR(range_of(motion_of(scene_of("sleeping", 1)), theta).second, 59 * kDegree, 0.5 * kDegree);
  EXPECT_NEAR(std::sqrt(4 * kI1 * kMgl) / kI3, 149, 0.5) << "as the text says";
}

/// The second lesson of that chapter: free motion.
const Lesson& free_recipes() {
  static const Lesson kLesson = [] {
    const std::string text = testing::read_file(test::source_dir() / "lessons" / "FORMAT.md");
    const std::string opening = "\n````markdown\n";
    const std::size_t begin = text.find(opening, text.find("\nFree motion has its own:")) + opening.size();
    LessonReading reading =
        read_lesson(text.substr(begin, text.find("\n````\n", begin) + 1 - begin), "free.md");
    if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
    EXPECT_THAT(testing::lines_of(reading.diagnostics), ::testing::IsEmpty());
    return std::move(*reading.lesson);
  }();
  return kLesson;
}

TEST(Recipes, AThinPlateWobblesTwiceWhileItSpinsOnce) {
  const Scene& scene = *free_recipes().find_stage("plate")->steps.at(0).scene;
  const Vec3 I = scene.body.moments.vector();
  // ω₃ is the spin on the body beside the precession: seen from space the axis goes round at |L|/I₁, and the
  // body turns about L at ω₃ near the axis; for I₃ = 2I₁ and a small tilt the ratio is 2 to the second order
  // in the tilt.
  const double wobble = I.cwiseProduct(scene.w0_B).norm() / I[0],
               tilt = I[0] * scene.w0_B[0] / (I[2] * scene.w0_B[2]);
  EXPECT_NEAR(wobble / scene.w0_B[2], 2, 2 * tilt * tilt);
}

TEST(Recipes, APointOfTheBodyConeRestsWhereTheConesTouch) {
  const Scene& scene = *free_recipes().find_stage("rolling")->steps.at(0).scene;
  // At t = 0 the point w_a ê₁ + w_s ê₃ is ω itself, and dr/dt = ω×r = 0.
  EXPECT_LT(scene.w0_B.cross(Vec3(1.2, 0, 2.4)).norm(), 1e-12);
}

}  // namespace
}  // namespace polhode
