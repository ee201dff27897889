// SPDX-License-Identifier: MIT
// A prediction is answered by the motion: Ask::plays.
#include "app/session/answers/answer_keys.h"
#include "app/session/lesson_session.h"
#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

std::shared_ptr<const LoadedLesson> lesson() {
  return test::loaded_text(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[scene]\nbody = \"textbook\"\nomega = [0.1, 2.0, 0.1]\n"
      "+++\n# S {s}\n```scene\nat = 0.5\nduration = 2\nrate = 1\n```\n"
      "```ask p\ntype = 'predict'\nprompt = 'p'\nplays = [0.5, 2]\nshuffle = false\n"
      "- [x] this\n- [ ] that\n  No.\n```\n---\nMore.\n");
}

struct Predicting {
  Predicting() { session.answer(ask, "B"); }
  LessonSession session{lesson()};
  const Ask& ask = *session.questions().front();
};

TEST(Prediction, IsPlayedBeforeItsVerdict) {
  Predicting at;
  EXPECT_TRUE(at.session.is_awaited(at.ask));
  EXPECT_TRUE(at.session.is_playing());
  EXPECT_EQ(at.session.t_s(), 0.5);
  EXPECT_EQ(at.session.record(at.ask)->tries, 1) << "what was picked is kept at once";
  EXPECT_FALSE(answer_by_key(at.session, "A")) << "nothing is changed while it plays";
  at.session.advance(1);
  EXPECT_EQ(at.session.t_s(), 1.5);
  EXPECT_TRUE(at.session.is_awaited(at.ask));
  at.session.advance(1);
  EXPECT_EQ(at.session.t_s(), 2) << "the scene's loop does not begin again";
  EXPECT_FALSE(at.session.is_awaited(at.ask));
  EXPECT_FALSE(at.session.is_playing());
  EXPECT_EQ(at.session.judged(at.ask)->judgement.choice, 2);
}

TEST(Prediction, WaitsWhileItIsPausedAndCanBeSaidAtOnce) {
  Predicting at;
  at.session.set_playing(false);
  at.session.advance(10);
  EXPECT_TRUE(at.session.is_awaited(at.ask));
  at.session.end_play();
  EXPECT_FALSE(at.session.is_awaited(at.ask));
  EXPECT_EQ(at.session.t_s(), 2);
}

TEST(Prediction, PlaysTheMotionOfTheLesson) {
  LessonSession session(lesson());
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  session.answer(*session.questions().front(), "A");
  EXPECT_EQ(session.model()->scene.w0_B, Vec3(0.1, 2, 0.1));
}

TEST(Prediction, IsJudgedAtOnceWhereNothingPlaysByItself) {
  LessonSession session(lesson());
  session.preferences.reduced_motion = true;
  const Ask& ask = *session.questions().front();
  session.answer(ask, "A");
  EXPECT_FALSE(session.is_awaited(ask));
  EXPECT_FALSE(session.is_playing());
  EXPECT_EQ(session.t_s(), 2) << "what it comes to is seen";
}

// What comes is not given away: a flip behind the still has no mark before the verdict.
TEST(Prediction, HidesWhatComesUntilItsVerdict) {
  const auto flipping = test::loaded_text(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[scene]\nbody = \"textbook\"\nomega = [0.1, 3.0, 0.1]\n"
      "+++\n# S {s}\n```scene\nshow = [\"omega\"]\nat = 0.5\nduration = 8\nrate = 1\n```\n"
      "```ask p\ntype = 'predict'\nprompt = 'p'\nplays = [0.5, 6]\nshuffle = false\n"
      "- [x] this\n- [ ] that\n  No.\n```\n---\nMore.\n");
  LessonSession session(flipping);
  const Ask& ask = *session.questions().front();
  ASSERT_FALSE(session.flips().empty());
  ASSERT_GT(session.flips().back(), 0.5);
  EXPECT_TRUE(session.is_predicting());
  for (const double t_s : session.shown_flips()) EXPECT_LE(t_s, 0.5);
  session.answer(ask, "A");
  EXPECT_TRUE(session.is_predicting()) << "it is still to be seen";
  session.end_play();
  EXPECT_FALSE(session.is_predicting());
  EXPECT_EQ(session.shown_flips(), session.flips());
  session.forget_answer(ask);
  EXPECT_TRUE(session.is_predicting());
  session.next_step();
  EXPECT_FALSE(session.is_predicting()) << "nothing is asked here";
}

TEST(Prediction, IsNotAwaitedElsewhereNorWhenForgottenNorUnread) {
  Predicting left;
  left.session.next_step();
  left.session.previous_step();
  EXPECT_FALSE(left.session.is_awaited(left.ask));
  Predicting forgotten;
  forgotten.session.forget_answer(forgotten.ask);
  EXPECT_FALSE(forgotten.session.is_awaited(forgotten.ask));
  LessonSession unread(lesson());
  unread.answer(*unread.questions().front(), "seven");
  EXPECT_FALSE(unread.is_awaited(*unread.questions().front()));
}

}  // namespace
}  // namespace polhode
