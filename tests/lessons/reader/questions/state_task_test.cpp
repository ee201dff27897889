// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/state_task.h"

#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/questions/state_keys.h"
#include "physics/body/euler.h"
#include "tests/lessons/support.h"
#include "tests/physics/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kAngle = "of = 'atan2(norm(cross(omega, L)), dot(omega, L))', unit = 'deg'";

std::string fence(const std::string& keys) {
  return "```ask a\ntype = 'state'\nprompt = 'Do it.'\n" + keys + "\n```\n";
}
std::string scene(const std::string& keys = "body = 'textbook'\nomega = [0.3, 0.2, 1.5]") {
  return "```scene\n" + keys + "\n```\n";
}

/// What is wrong with a lesson of one question, as lint says.
std::vector<std::string> faults(const std::string& body) {
  LessonReading reading = read_lesson(testing::lesson_with(body), "a.md");
  if (!reading.lesson) return testing::lines_of(reading.diagnostics);
  EXPECT_FALSE(prove_claims(*reading.lesson));
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}

std::shared_ptr<const StateTask> task_of(const std::string& body) {
  const LessonReading reading = read_lesson(testing::lesson_with(body), "a.md");
  EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
  if (!reading.lesson) throw std::runtime_error("no lesson");
  for (const Block& block : reading.lesson->stages.front().steps.front().blocks)
    if (const auto* ask = std::get_if<Ask>(&block)) return ask->task;
  throw std::runtime_error("no question");
}

std::string apart(const std::string& change = "['omega']", const std::string& more = "") {
  return fence(std::string("goals = [{ ") + kAngle +
               ", say = 'angle of ω and L', is = 20, within = 1 }]\nchange = " + change +
               "\nsolution = { omega = [1.5, 0, 0.45] }" + more);
}

TEST(StateTask, IsReadWithTheSceneOfItsStep) {
  const auto task = task_of(apart() + scene());
  ASSERT_EQ(task->goals.size(), 1u);
  const StateGoal& goal = task->goals.front();
  EXPECT_EQ(goal.is, 20);
  EXPECT_EQ(goal.least, 19);
  EXPECT_EQ(goal.most, 21);
  EXPECT_EQ(range_of(goal), "20° ± 1°");
  EXPECT_EQ(words_of(task->change), "ω");
  ASSERT_TRUE(task->scene);
  EXPECT_EQ(task->scene->w0_B, Vec3(0.3, 0.2, 1.5));
  EXPECT_THAT(faults(apart() + scene()), IsEmpty());
}

TEST(StateTask, IsJudgedByTheMotion) {
  const auto task = task_of(apart() + scene());
  EXPECT_EQ(judge_state(*task, "omega = [1.5, 0, 0.45]").mark, Mark::right);
  const AnswerJudgement wrong = judge_state(*task, "omega = [0, 0, 2]");
  EXPECT_EQ(wrong.mark, Mark::wrong);
  EXPECT_EQ(wrong.reason, "angle of ω and L is 0.0°, 20.0° too small");
}

// The angle is computed here from the definition alone.
TEST(StateTask, IsRightJustWhereTheGoalIsWithinItsRange) {
  const auto task = task_of(apart() + scene());
  const PrincipalMoments I(1.0, 1.75, 2.5);
  test::Random random(11);
  int right = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 w(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
    const Vec3 L = angular_momentum_B(I, w);
    const double angle_deg = std::atan2(w.cross(L).norm(), w.dot(L)) * 180 / std::numbers::pi;
    constexpr double kRounding = 1e-9;  // of both computations, deg
    if (std::abs(std::abs(angle_deg - 20) - 1) < kRounding) continue;
    SteeredState state;
    state.w0_B = w;
    const bool is_right = judge_state(*task, state).mark == Mark::right;
    EXPECT_EQ(is_right, std::abs(angle_deg - 20) < 1) << w.transpose() << ": " << angle_deg;
    right += is_right ? 1 : 0;
  }
  EXPECT_GT(right, 20);
}

TEST(StateTask, TrivialWaysOutAreRefused) {
  const auto task = task_of(apart() + scene());
  const AnswerJudgement at_rest = judge_state(*task, "omega = [0, 0, 0]");
  EXPECT_NE(at_rest.mark, Mark::right);
  EXPECT_THAT(at_rest.reason, HasSubstr("not defined"));
  for (const char* large : {"omega = [1e200, 0, 0]", "omega = [0, -1e308, 0]"})
    EXPECT_EQ(judge_state(*task, large).reason, "a number in this is too large") << large;
  EXPECT_EQ(judge_state(*task, "moments = [1, 1, 1]").mark, Mark::unreadable);
  EXPECT_THAT(judge_state(*task, "t = 3").reason, HasSubstr("keeps the time as it is"));
}

TEST(StateTask, TimeIsThatOfTheStateOrTheStart) {
  const std::string goals = "goals = [{ of = 'w2', is = 0, within = 0.01, unit = 'rad/s' }]\n";
  const std::string flip = scene("body = 'textbook'\nomega = [0.3, 3, 0]\nat = 1");
  const auto timed = task_of(fence(goals + "change = ['t']\nsolution = { t = 1 }") + flip);
  const SceneModel model = make_model(*timed->scene, ModelFor::numbers);
  double flip_s = 0;  // of the first flip, by halving
  for (double low = 0, high = 4; high - low > 1e-12; flip_s = low) {
    const double half = std::midpoint(low, high);
    (model.motion->w_B_at(half)[1] > 0 ? low : high) = half;
  }
  SteeredState state;
  state.t_s = flip_s;
  EXPECT_EQ(judge_state(*timed, state).mark, Mark::right);
  state.t_s = flip_s + 0.1;
  EXPECT_EQ(judge_state(*timed, state).mark, Mark::wrong);
  const auto at_start = task_of(fence(goals + "change = ['omega']\nsolution = { omega = [1, 0, 1] }") + flip);
  EXPECT_EQ(judge_state(*at_start, "omega = [2, 0, 1]").mark, Mark::right);
  EXPECT_EQ(judge_state(*at_start, "omega = [2, 0.5, 1]").mark, Mark::wrong);
}

// N = ω×(I·ω), equations (7) to (9) with ω̇ = 0.
TEST(StateTask, ATorqueHoldsASpin) {
  const auto task = task_of(
      fence("goals = [{ of = 'norm(ddt(omega))', at_most = 0.05, unit = 'rad/s²' }]\nchange = ['torque']\n"
            "solution = { torque = 'body:0.72,-1.8,0.6' }") +
      scene("body = 'textbook'\nomega = [1, 0.8, 1.2]"));
  EXPECT_EQ(judge_state(*task, "torque = \"body:0.72,-1.8,0.6\"").mark, Mark::right);
  EXPECT_EQ(judge_state(*task, "torque = \"body:-0.72,1.8,-0.6\"").mark, Mark::wrong);
  EXPECT_THAT(judge_state(*task, "torque = \"space:0.72,-1.8,0.6\"").reason, HasSubstr("body:x,y,z"));
}

TEST(StateTask, AMotionFlipsEveryThreeSeconds) {
  const std::string body =
      fence(
          "goals = [{ of = 'flip_interval', is = 3, within = 0.1, unit = 's' }]\nchange = ['omega']\n"
          "solution = { omega = [1.2, 3, 0] }") +
      scene("body = 'textbook'\nomega = [0.03, 3, 0]");
  const auto task = task_of(body);
  EXPECT_THAT(judge_state(*task, "omega = [3, 0, 0]").reason, HasSubstr("not defined")) << "it never flips";
  EXPECT_EQ(judge_state(*task, "omega = [0.03, 3, 0]").mark, Mark::wrong);
}

TEST(StateTask, WhatCannotBeIsSaid) {
  const auto task = task_of(apart("['omega', 't']") + scene());
  EXPECT_NE(judge_state(*task, "omega = [1e300, 1e300, 1e300]").mark, Mark::right);
  EXPECT_THAT(judge_state(*task, "t = 1e300").reason, HasSubstr("too far away"));
}

TEST(StateTask, LintProvesTheSolutionAndThatSomethingIsToBeDone) {
  EXPECT_THAT(faults(fence(std::string("goals = [{ ") + kAngle +
                           ", is = 20, within = 1 }]\nchange = ['omega']\n"
                           "solution = { omega = [1, 0, 0] }") +
                     scene()),
              ElementsAre(HasSubstr("does not reach its goal")));
  EXPECT_THAT(faults(apart() + scene("body = 'textbook'\nomega = [1.5, 0, 0.45]")),
              ElementsAre(HasSubstr("before anything is changed")));
  EXPECT_THAT(faults(apart("['moments']") + scene()), ElementsAre(HasSubstr("keeps ω as it is")));
}

TEST(StateTask, KeysThatAreWrongAreSaid) {
  const auto said = [](const std::string& keys) { return faults(fence(keys) + scene()); };
  const std::string rest = "\nchange = ['omega']\nsolution = { omega = [1, 1, 1] }";
  EXPECT_THAT(faults(apart()), ElementsAre(HasSubstr("needs a scene")));
  EXPECT_THAT(said(rest), ElementsAre(HasSubstr("lacks \"goals\"")));
  EXPECT_THAT(said("goals = []" + rest), ElementsAre(HasSubstr("1 to 4")));
  EXPECT_THAT(said("goals = [{ is = 1, within = 1 }]" + rest), ElementsAre(HasSubstr("\"of\"")));
  EXPECT_THAT(said("goals = [{ of = 'T', is = 1 }]" + rest), ElementsAre(HasSubstr("go together")));
  EXPECT_THAT(said("goals = [{ of = 'T', is = 1, within = 0 }]" + rest), ElementsAre(HasSubstr("positive")));
  EXPECT_THAT(said("goals = [{ of = 'T' }]" + rest), ElementsAre(HasSubstr("at_least")));
  EXPECT_THAT(said("goals = [{ of = 'T', at_least = 2, at_most = 1 }]" + rest),
              ElementsAre(HasSubstr("larger")));
  EXPECT_THAT(said("goals = [{ of = 'L', at_least = 2 }]" + rest), ElementsAre(HasSubstr("scalar")));
  EXPECT_THAT(said("goals = [{ of = 'h', at_least = 2 }]" + rest), ElementsAre(HasSubstr("any number")));
  EXPECT_THAT(said("goals = [{ of = 'T', at_least = 2, unit = 's' }]" + rest),
              ElementsAre(HasSubstr("units disagree")));
  EXPECT_THAT(
      said("goals = [{ of = 'T', at_least = 200 }]\nchange = ['omgea']\nsolution = { omega = [1, 1, 1] }"),
      ElementsAre(HasSubstr("omgea")));
  EXPECT_THAT(said("goals = [{ of = 'T', at_least = 200 }]\nchange = ['omega']\nsolution = 3"),
              ElementsAre(HasSubstr("is a table")));
  EXPECT_THAT(said("goals = [{ of = 'T', at_least = 200 }]\nanswer = 1" + rest),
              ElementsAre(HasSubstr("\"answer\" is not of questions")));
  EXPECT_THAT(faults(apart() + scene("omega = [0.3, 0.2, 1.5]\nattitude = [1, 1, 0, 0]")),
              ElementsAre(HasSubstr("\"attitude\" has to be in \"change\"")));
}

TEST(StateTask, ItIsSaidWhatIsToBeReachedAndChanged) {
  const LessonReading reading = read_lesson(testing::lesson_with(apart() + scene()), "a.md");
  ASSERT_TRUE(reading.lesson);
  const Ask* ask = blocks_of<Ask>(reading.lesson->stages.front().steps.front()).front();
  std::string text;
  for (const TextBlock& block : ask->prompt_text)
    for (const TextSpan& span : block.spans) text += span.text;
  EXPECT_EQ(text, "Do it.Goal: angle of ω and L = 20° ± 1°, at the start.You may change \\vec\\omega.");
  const RichText asked = without_goals(*ask);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked.front().spans.front().text, "Do it.");
}

TEST(StateGoals, AreReadWithNoMoreDigitsThanTellThemFromTheGoal) {
  StateGoal goal;
  goal.number.written.unit = "rad/s²";
  goal.most = 0.03;
  const auto told = [&](double value) {
    const bool is_reached = value <= *goal.most;
    return words_of(goal,
                    {.value = value, .off = is_reached ? 0 : value - *goal.most, .is_reached = is_reached});
  };
  EXPECT_EQ(told(0.37069), "0.371 rad/s², 0.341 rad/s² too large");
  EXPECT_EQ(told(76.8), "76.8 rad/s², 76.8 rad/s² too large");
  EXPECT_EQ(told(0.0304), "0.03040 rad/s², 0.00040 rad/s² too large") << "near the goal they tell it from it";
  EXPECT_EQ(told(0.0123456), "0.0123 rad/s²");
}

}  // namespace
}  // namespace polhode
