// SPDX-License-Identifier: MIT
#include "lessons/claims/motion_words.h"

#include "lessons/reader/checks/claim_check.h"
#include "physics/body/bodies.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

/// What a word of the language comes to on a scene at t.
std::optional<double> value_on(const Scene& scene, const std::string& text, double t_s = 0) {
  Vocabulary vocabulary;
  std::map<int, Dimension> dimensions;
  add_motion_words(vocabulary, dimensions);
  testing::TextReport report(text);
  const auto expression = read_expression(text, {1, 1}, report.report, &vocabulary);
  if (!expression) {
    ADD_FAILURE() << text;
    return std::nullopt;
  }
  const SceneModel model = make_model(scene, ModelFor::numbers);
  return MotionNumbers(model, t_s).value_of(*expression);
}

Scene pencil() {
  Scene scene;
  scene.body = {"pencil", PrincipalMoments(1, 1, 0.3), std::nullopt};
  scene.w0_B = Vec3(0.8, 0, 2);
  return scene;
}

/// A top of I1 = 1, I3 = 0.4 kg m² and m g l = 3 N m that leans by 60° and spins at 12 rad/s, at rest in θ
/// and φ.
Scene top() {
  Scene scene;
  scene.body = {"top", PrincipalMoments(1, 1, 0.4), std::nullopt};
  scene.w0_B = Vec3(0, 0, 12);
  scene.attitude = Quat(Eigen::AngleAxisd(std::numbers::pi / 3, Vec3::UnitX()));
  scene.torque = {HeavyTop{3, Vec3::UnitZ()}};
  return scene;
}

TEST(MotionWords, FlipsComeTwiceAPeriod) {
  Scene book;
  book.body = {"book", PrincipalMoments(1, 1.75, 2.5), std::nullopt};
  book.w0_B = Vec3(0.3, 3, 0);
  EXPECT_EQ(value_on(book, "flip_interval"), 0.5 * value_on(book, "period").value());
  book.w0_B = Vec3(3, 0.3, 0);
  EXPECT_FALSE(value_on(book, "flip_interval")) << "it wobbles about axis 1";
}

TEST(MotionWords, SayHowFarAMotionIsKnown) {
  Scene book;
  book.body = {"book", PrincipalMoments(1, 1.75, 2.5), std::nullopt};
  book.w0_B = Vec3(0.3, 3, 0);
  const Horizon horizon = horizon_of(problem_of(book));
  EXPECT_EQ(value_on(book, "condition"), horizon.condition);
  EXPECT_EQ(value_on(book, "horizon"), *horizon.periods_1e_1 * value_on(book, "period").value());
  EXPECT_FALSE(value_on(top(), "horizon"));
}

TEST(MotionWords, AreThoseOfFreeMotion) {
  EXPECT_NEAR(value_on(pencil(), "precession").value(), std::hypot(0.8, 0.6), kRounding);
  EXPECT_NEAR(value_on(pencil(), "body_precession").value(), -0.7 * 2, kRounding);
  EXPECT_NEAR(value_on(pencil(), "2*pi/body_precession").value(), -2 * std::numbers::pi / 1.4, 8 * kRounding);
  EXPECT_NEAR(value_on(pencil(), "precession*I1 - norm(L)").value(), 0, kRounding) << "beside quantities";
  // ω comes back to where it was in the body.
  EXPECT_NEAR(value_on(pencil(), "period").value(), 2 * std::numbers::pi / 1.4, 64 * kRounding);
  EXPECT_NEAR(value_on(pencil(), "body_cone").value(), std::atan2(0.8, 2), kRounding);
  EXPECT_NEAR(value_on(pencil(), "space_cone").value(), std::atan2(0.8, 0.6) - std::atan2(0.8, 2), kRounding);
  for (const char* word : {"slow_precession", "fast_precession", "nutation", "least_tilt", "most_tilt"})
    EXPECT_FALSE(value_on(pencil(), word)) << word;
  Scene uneven = pencil();
  uneven.body.moments = PrincipalMoments(1, 1.75, 2.5);
  for (const char* word : {"precession", "body_cone", "space_cone"})
    EXPECT_FALSE(value_on(uneven, word)) << word;
}

// The slow and the fast rate solve I1 cosθ Ω² − I3 ω3 Ω + mgl = 0; let go, the axis turns back where it was.
TEST(MotionWords, AreThoseOfATop) {
  const double a = 0.5, b = 0.4 * 12, c = 3, root = std::sqrt(b * b - 4 * a * c);
  EXPECT_NEAR(value_on(top(), "slow_precession").value(), (b - root) / (2 * a), 64 * kRounding);
  EXPECT_NEAR(value_on(top(), "fast_precession").value(), (b + root) / (2 * a), 64 * kRounding);
  EXPECT_NEAR(value_on(top(), "least_tilt").value(), std::numbers::pi / 3, 1e-7) << "u is near a root of f";
  EXPECT_GT(value_on(top(), "most_tilt").value(), std::numbers::pi / 3);
  EXPECT_FALSE(value_on(top(), "period")) << "of the polhode: not under a torque";
  EXPECT_FALSE(value_on(top(), "precession")) << "free";
  EXPECT_FALSE(value_on(top(), "drift_T")) << "the torque changes it";
}

// f(u) of symmetric_top.h: at the other turning point β(1 − u²) (u0 − u) − a²(u0 − u)² = 0.
TEST(MotionWords, KnowTheLowerTurningPoint) {
  const double beta = 2 * 3, a = 0.4 * 12, u0 = 0.5;
  const double p = a * a / (2 * beta), u = p - std::sqrt(p * p - 2 * p * u0 + 1);
  EXPECT_NEAR(value_on(top(), "cos(most_tilt)").value(), u, 1e-9);
}

// Half as long a step: the error of a method of order 4 is a sixteenth.
TEST(MotionWords, AreThoseOfMethods) {
  Scene scene = pencil();
  scene.body.moments = PrincipalMoments(1, 1.75, 2.5);
  EXPECT_FALSE(value_on(scene, "error_omega", 1)) << "the closed form is what others are compared with";
  EXPECT_FALSE(value_on(scene, "evaluations", 1));
  const auto with_step = [&](double step_s, const char* word) {
    scene.motion.method = Method::rk4;
    scene.motion.step_s = step_s;
    return value_on(scene, word, 2).value();
  };
  for (const char* word : {"error_omega", "error_attitude"})
    EXPECT_NEAR(with_step(0.1, word) / with_step(0.05, word), 16, 2)
        << word << ": the next order is still seen";
  for (const char* word : {"drift_T", "drift_L", "drift_direction"}) {
    EXPECT_GT(with_step(0.1, word), 1e-9) << word;
    EXPECT_LT(with_step(0.1, word), 1e-3) << word;
  }
  EXPECT_NEAR(with_step(0.1, "evaluations"), 4 * 20, 0);
}

TEST(MotionWords, AreNoWordsOfALessonThatHasThemItself) {
  Vocabulary vocabulary;
  vocabulary.add_constant("period", 2.5, "P");
  std::map<int, Dimension> dimensions;
  add_motion_words(vocabulary, dimensions);
  testing::TextReport report("period");
  const auto expression = read_expression("period", {1, 1}, report.report, &vocabulary);
  ASSERT_TRUE(expression);
  EXPECT_FALSE(has_motion_words(*expression));
  const SceneModel model = make_model(pencil(), ModelFor::numbers);
  EXPECT_EQ(MotionNumbers(model, 0).value_of(*expression), 2.5);
}

TEST(MotionWords, HaveNamesUnitsAndTex) {
  std::set<std::string_view> names;
  for (const MotionWord& word : motion_words()) {
    EXPECT_TRUE(names.insert(word.name).second) << word.name;
    EXPECT_EQ(why_no_word(word.name), "");
    EXPECT_TRUE(dimension_of_unit(word.unit)) << word.name;
    EXPECT_TRUE(parse_math(word.tex)) << word.name;
  }
}

// In what is typed they are those of the still; a number that runs has none.
TEST(MotionWords, StandInWhatIsTyped) {
  const auto faults = [](const std::string& formula) {
    LessonReading reading =
        read_lesson(testing::lesson_with("a $" + formula +
                                         "$\n\n```scene\nbody = \"needle\"\nomega = [1, 0, 0]\nat = 1\n"
                                         "motion = { method = \"explicit-euler\", step = 0.5 }\n```\n"),
                    "a.md");
    if (!reading.lesson) return testing::lines_of(reading.diagnostics);
    return testing::lines_of(check_claims(*reading.lesson, "a.md"));
  };
  EXPECT_THAT(faults("\\value{2}{evaluations}"), IsEmpty());
  EXPECT_THAT(faults("\\value{3}{evaluations}"),
              ElementsAre(HasSubstr("this number is 2 at t = 1 s, and 3 is typed")));
  EXPECT_THAT(faults("\\value{3}{period}"), ElementsAre(HasSubstr("this has no value")));
  EXPECT_THAT(faults("\\value[unit={s}]{3}{evaluations}"), ElementsAre(HasSubstr("units disagree")));
  EXPECT_THAT(
      faults("\\live{period}"),
      ElementsAre(HasSubstr("this is a number of the motion as a whole, and \\live shows what it is now")));
}

}  // namespace
}  // namespace polhode
