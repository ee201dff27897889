// SPDX-License-Identifier: MIT
#include "app/session/steering.h"

#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;
using ::testing::HasSubstr;

/// Stage "apart" asks for an angle of ω and L by ω alone, "when" for a time by ω and t.
std::shared_ptr<const LoadedLesson> lesson() {
  static const auto kLesson = test::loaded_text(
      "+++\nformat = 1\nid = \"steered\"\ntitle = \"Steered\"\n+++\n# Apart {apart}\nText.\n\n"
      "```scene\nomega = [0.3, 0.2, 1.5]\nshow = [\"omega\"]\nat = 0.5\n```\n"
      "```ask a\ntype = \"state\"\nprompt = \"Drag.\"\n"
      "goals = [{ of = \"atan2(norm(cross(omega, L)), dot(omega, L))\", is = 20, within = 1, unit = \"deg\" "
      "}]\n"
      "change = [\"omega\"]\nsolution = { omega = [1.5, 0, 0.45] }\n```\n"
      "# When {when}\nText.\n\n```scene\nomega = [0.3, 3, 0]\nshow = [\"omega\"]\n```\n"
      "```ask b\ntype = \"state\"\nprompt = \"Drag.\"\n"
      "goals = [{ of = \"w2\", at_most = 0, unit = \"rad/s\" }]\nchange = [\"omega\", \"t\"]\n"
      "solution = { omega = [0, -1, 1], t = 0 }\n```\n");
  return kLesson;
}

const Ask& ask_of(const LessonSession& session) { return *session.questions().front(); }

TEST(Steering, FollowsTheSceneAndIsJudgedAsItStands) {
  LessonSession session(lesson());
  const StateTask& task = *ask_of(session).task;
  EXPECT_EQ(text_of(steering_of(session, task).state), "") << "nothing was changed yet";
  EXPECT_FALSE(are_reached(steering_of(session, task).goals));
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1.5, 0, 0.45)}));
  session.scrub_to(0.7);
  const Steering steering = steering_of(session, task);
  EXPECT_EQ(steering.t_s, 0) << "the time is not the reader's to choose";
  EXPECT_TRUE(are_reached(steering.goals));
  EXPECT_EQ(text_of(steering.state), "omega = [1.5, 0.0, 0.45]");
  EXPECT_EQ(session.answer(ask_of(session), text_of(steering.state)).mark, Mark::right);
  EXPECT_EQ(session.record(ask_of(session))->last, "omega = [1.5, 0.0, 0.45]");
  EXPECT_EQ(session.record(ask_of(session))->right, 1);
}

TEST(Steering, ReadingsAreThoseOfTheVerdict) {
  LessonSession session(lesson());
  const StateTask& task = *ask_of(session).task;
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1.5, 0.01 * i, 0.3 + 0.01 * i)}));
    const Steering steering = steering_of(session, task);
    EXPECT_EQ(judge_state(task, text_of(steering.state)).mark == Mark::right, are_reached(steering.goals));
  }
}

TEST(Steering, WhatElseWasChangedIsSaidAndCanBePutBack) {
  LessonSession session(lesson());
  const StateTask& task = *ask_of(session).task;
  SceneEdits edits{.body = find_body("book"), .w0_B = Vec3(1, 1, 1)};
  edits.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01};
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(steering_of(session, task).elsewhere, "the moments of inertia, the method");
  ASSERT_TRUE(session.set_edits(put_back(session.edits(), task)));
  EXPECT_EQ(steering_of(session, task).elsewhere, "");
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 1, 1));
}

TEST(Steering, TimeIsPartOfTheStateWhereItIsAskedFor) {
  LessonSession session(lesson());
  session.go_to({1, 0});
  session.scrub_to(0.25);
  EXPECT_EQ(text_of(steering_of(session, *ask_of(session).task).state), "t = 0.25");
}

}  // namespace
}  // namespace polhode
