// SPDX-License-Identifier: MIT
// A counterexample in the figure.
#include "app/session/lesson_session.h"
#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

std::shared_ptr<const LoadedLesson> lesson() {
  static const auto kLesson = test::loaded_text(
      "+++\nformat = 1\nid = \"asked\"\ntitle = \"Asked\"\n+++\n# Asked {asked}\nText.\n\n"
      "```scene\nomega = [0, 12, 0.1]\nshow = [\"omega\"]\nrate = 0.01\nat = 0.1\ncaption = \"A book\"\n```\n"
      "```ask a\ntype = \"expression\"\nprompt = \"What?\"\nanswer = \"w1*w2*(I2 - I1)\"\n```\n");
  return kLesson;
}

TEST(ShownCounterexample, IsTheBodyThatIsSaid) {
  LessonSession session(lesson());
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(judged.counterexample && judged.counterexample->body);
  const CounterBody& body = *judged.counterexample->body;
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  const Scene& shown = session.model()->scene;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ(shown.body.moments[i], body.I[k]);
    EXPECT_EQ(shown.w0_B[i], body.w[k]);
  }
  const Vec3 w = shown.w0_B;
  EXPECT_NE(w[0] * w[1] * (shown.body.moments[0] - shown.body.moments[1]), 0) << "there the answer fails";
  EXPECT_TRUE(shown.caption.empty()) << "it is no book";
  EXPECT_FALSE(shown.rate) << "nor as fast";
  EXPECT_EQ(session.t_s(), 0);
  ASSERT_NE(session.counterexample(), nullptr);
  EXPECT_EQ(session.counterexample()->state, judged.counterexample->state);
}

TEST(ShownCounterexample, GivesBackWhatWasShownBefore) {
  LessonSession session(lesson());
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  session.scrub_to(0.3);
  const Scene before = session.model()->scene;
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample))
      << "another one does not hide the way back";
  session.leave_counterexample();
  EXPECT_EQ(session.model()->scene, before);
  EXPECT_EQ(session.t_s(), 0.3);
  EXPECT_FALSE(session.is_aside());
}

TEST(ShownCounterexample, IsNoneAnyMoreOnceItsBodyIsChanged) {
  LessonSession session(lesson());
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  session.set_camera({.azimuth_rad = 1});
  EXPECT_NE(session.counterexample(), nullptr);
  SceneEdits edits = session.edits();
  edits.w0_B = Vec3(1, 2, 3);
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.counterexample(), nullptr);
  EXPECT_TRUE(session.is_aside());
  session.reset_edits();
  EXPECT_FALSE(session.is_aside());
  EXPECT_EQ(session.model()->scene.caption, "A book");
}

TEST(ShownCounterexample, TurnsUnderTheTorqueThatIsSaid) {
  LessonSession session(lesson());
  Counterexample counter{"I = (2, 3, 4), ω = (1, 0, 0), N = (0, 1, 0)", "1", "2", CounterBody{}};
  counter.body->I = {2, 3, 4};
  counter.body->w = {1, 0, 0};
  counter.body->N = {0, 1, 0};
  ASSERT_TRUE(session.show_counterexample(counter));
  EXPECT_EQ(session.model()->scene.torque, Torque{BodyTorque{Vec3(0, 1, 0)}});
  counter.state = "I = (2, 3, 4), ω = (1, 0, 0), N = 0";
  counter.body->N = {0, 0, 0};
  ASSERT_TRUE(session.show_counterexample(counter));
  EXPECT_EQ(session.model()->scene.torque, Torque{});
  counter.body.reset();
  EXPECT_FALSE(session.show_counterexample(counter).ok());
}

// Whatever the lesson's figure shows of its own: what the words speak of has to be seen.
TEST(ShownCounterexample, IsSeen) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"bare\"\ntitle = \"Bare\"\n+++\n# Asked {asked}\nText.\n\n"
      "```scene\nomega = [0, 12, 0.1]\nshow = [\"axes-space\"]\n```\n"
      "```ask a\ntype = \"expression\"\nprompt = \"What?\"\nanswer = \"w1*w2*(I2 - I1)\"\n```\n"));
  const Scene before = session.model()->scene;
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  for (const Overlay overlay : {Overlay::shape, Overlay::omega, Overlay::axes_body})
    EXPECT_TRUE(session.model()->scene.show.contains(overlay)) << static_cast<int>(overlay);
  session.leave_counterexample();
  EXPECT_EQ(session.model()->scene, before);
}

// A, dA/dt and constants are in no figure: one that shows the rest would say nothing.
TEST(ShownCounterexample, IsNotOfferedWhereNoFigureShowsIt) {
  LessonSession session(lesson());
  AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  Counterexample& counter = *judged.counterexample;
  EXPECT_TRUE(session.can_show(counter));
  counter.body->has_more = true;
  EXPECT_FALSE(session.can_show(counter));
  EXPECT_FALSE(session.show_counterexample(counter).ok());
  EXPECT_FALSE(session.is_aside());
}

TEST(ShownCounterexample, GoesWithTheAnswerThatFailed) {
  LessonSession session(lesson());
  const Ask& ask = *session.questions().front();
  const Counterexample counter = *session.answer(ask, "w1*w2*(I1 - I2)").counterexample;
  ASSERT_TRUE(session.show_counterexample(counter));
  session.answer(ask, "w1*w2*I3");
  EXPECT_FALSE(session.is_aside()) << "that one fails for another body";
  ASSERT_TRUE(session.show_counterexample(counter));
  session.answer(ask, "w1*w2*(I2 - I1)");
  EXPECT_FALSE(session.is_aside());
  ASSERT_TRUE(session.show_counterexample(counter));
  session.forget_answer(ask);
  EXPECT_FALSE(session.is_aside());
  ASSERT_TRUE(session.show_counterexample(counter));
  SceneEdits edits = session.edits();
  edits.w0_B = Vec3(1, 2, 3);
  ASSERT_TRUE(session.set_edits(edits));
  session.answer(ask, "w1");
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 2, 3)) << "what was made by hand stays";
}

// A question about a torque keeps its arrow.
TEST(ShownCounterexample, KeepsTheTorqueOfWhichItSaysNothing) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"driven\"\ntitle = \"Driven\"\n+++\n# Asked {asked}\nText.\n\n"
      "```scene\nomega = [0, 12, 0.1]\ntorque = \"body:0.1,0.2,0\"\nshow = [\"omega\"]\n```\n"
      "```ask a\ntype = \"expression\"\nprompt = \"What?\"\nanswer = \"w1*w2*(I2 - I1)\"\n```\n"));
  const Torque lessons = session.model()->scene.torque;
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(judged.counterexample);
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  EXPECT_EQ(session.model()->scene.torque, lessons);
}

// 2026-11-28: it was shown by a button, and Ctrl+Z did not know of it.
TEST(ShownCounterexample, IsUndoneAndMadeAgain) {
  LessonSession session(lesson());
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  session.begin_change();
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  session.scrub_to(0.3);
  const Scene before = session.model()->scene;
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  const Scene shown = session.model()->scene;
  ASSERT_TRUE(session.can_undo());
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.model()->scene, before);
  EXPECT_EQ(session.t_s(), 0.3);
  EXPECT_FALSE(session.is_aside());
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.model()->scene, shown);
  ASSERT_NE(session.counterexample(), nullptr);
  EXPECT_EQ(session.counterexample()->state, judged.counterexample->state);
  // What is changed by hand in its place comes first.
  session.begin_change();
  SceneEdits edits = session.edits();
  edits.w0_B = Vec3(3, 2, 1);
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.counterexample(), nullptr);
  EXPECT_TRUE(session.undo());
  EXPECT_NE(session.counterexample(), nullptr) << "as it was";
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.model()->scene, before);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.edits().empty());
  EXPECT_FALSE(session.can_undo());
}

TEST(ShownCounterexample, ThatWasLeftLeavesNothingToUndo) {
  LessonSession session(lesson());
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  session.leave_counterexample();
  EXPECT_FALSE(session.can_undo());
  EXPECT_FALSE(session.can_redo());
  EXPECT_TRUE(session.edits().empty());
}

// What the chip says of it, that an answer fails for it, is true of that answer.
TEST(ShownCounterexample, IsNotMadeAgainAfterAnotherAnswer) {
  LessonSession session(lesson());
  const Ask& ask = *session.questions().front();
  const Counterexample counter = *session.answer(ask, "w1*w2*(I1 - I2)").counterexample;
  ASSERT_TRUE(session.show_counterexample(counter));
  ASSERT_TRUE(session.undo());
  session.answer(ask, "w1*w2*(I2 - I1)");
  EXPECT_FALSE(session.redo());
  EXPECT_FALSE(session.is_aside());
  // Nor is it come back to from what was made of it by hand.
  const Scene before = session.model()->scene;
  const Counterexample other = *session.answer(ask, "w1*w2*(I1 - I2)").counterexample;
  ASSERT_TRUE(session.show_counterexample(other));
  session.begin_change();
  SceneEdits edits = session.edits();
  edits.w0_B = Vec3(1, 2, 3);
  ASSERT_TRUE(session.set_edits(edits));
  session.answer(ask, "w1*w2*(I2 - I1)");
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.counterexample(), nullptr);
  EXPECT_FALSE(session.is_aside());
  EXPECT_EQ(session.model()->scene, before);
}

// 2026-11-28: an arrow of the lesson's was ω, and a second one with a second name lay on it.
TEST(ShownCounterexample, HasOneArrowOfAVector) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"drawn\"\ntitle = \"Drawn\"\n+++\n# Asked {asked}\nText.\n\n"
      "```scene\nomega = [0, 12, 0.1]\nshow = [\"shape\"]\narrows = [{ of = \"omega\", name_at = 0.5 "
      "}]\n```\n"
      "```ask a\ntype = \"expression\"\nprompt = \"What?\"\nanswer = \"w1*w2*(I2 - I1)\"\n```\n"));
  const AnswerJudgement judged = session.answer(*session.questions().front(), "w1*w2*(I1 - I2)");
  ASSERT_TRUE(session.show_counterexample(*judged.counterexample));
  EXPECT_FALSE(session.model()->scene.show.contains(Overlay::omega));
  EXPECT_EQ(session.model()->scene.marks.arrows.size(), 1u);
}

}  // namespace
}  // namespace polhode
