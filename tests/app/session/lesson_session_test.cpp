// SPDX-License-Identifier: MIT
// Where we are in a lesson, and what was answered.
#include "app/session/lesson_session.h"

#include "tests/app/session/example_lesson.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using test::example;
using ::testing::ElementsAre;
using Mark = AnswerJudgement::Mark;

std::vector<StepPlace> all_places(const Lesson& lesson) {
  std::vector<StepPlace> places;
  for (std::size_t stage = 0; stage < lesson.stages.size(); ++stage)
    for (std::size_t step = 0; step < lesson.stages[stage].steps.size(); ++step)
      places.push_back({stage, step});
  return places;
}

TEST(LessonSession, WalksThroughEveryStepOfEveryLessonAndBack) {
  for (const char* id : test::kLessons) {
    LessonSession session(test::loaded_lesson(id));
    const std::vector<StepPlace> places = all_places(session.lesson());
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(session.place(), places[i]);
      EXPECT_EQ(session.model() != nullptr, session.has_scene());
      EXPECT_EQ(session.next_step(), i + 1 < places.size());
    }
    EXPECT_EQ(session.place(), places.back());
    EXPECT_EQ(session.visited().size(), session.lesson().stages.size());
    for (std::size_t i = places.size(); i-- > 0;) {
      EXPECT_EQ(session.place(), places[i]);
      EXPECT_EQ(session.previous_step(), i > 0);
    }
  }
}

TEST(LessonSession, GoesFromStageToStageByTheirBeginnings) {
  LessonSession session(example());
  session.go_to({0, 2});
  EXPECT_TRUE(session.previous_stage());
  EXPECT_EQ(session.place(), (StepPlace{0, 0})) << "first to the beginning of this one";
  EXPECT_FALSE(session.previous_stage());
  session.go_to({0, 2});
  EXPECT_TRUE(session.next_stage());
  EXPECT_TRUE(session.next_stage());
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
  EXPECT_FALSE(session.next_stage());
  EXPECT_TRUE(session.previous_stage());
  EXPECT_EQ(session.place(), (StepPlace{1, 0}));
}

// 2026-11-26: `--stage words` on a first start counted the first stage as seen.
TEST(LessonSession, WhereItIsBegunNothingElseWasSeen) {
  LessonSession first(example());
  first.begin_at({1, 0});
  EXPECT_THAT(first.visited(), ElementsAre("words"));
  LessonSession again(example());
  again.set_visited({"free"});
  again.begin_at({1, 0});
  EXPECT_THAT(again.visited(), ElementsAre("free", "words"));
}

TEST(LessonSession, TakesThePlaceNearestToOneThatDoesNotExist) {
  LessonSession session(example());
  session.go_to({0, 99});
  EXPECT_EQ(session.place(), (StepPlace{0, 3}));
  session.go_to({99, 99});
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
}

TEST(LessonSession, KnowsWhichStagesWereSeen) {
  LessonSession session(example());
  EXPECT_THAT(session.visited(), ElementsAre("free"));
  session.go_to({2, 0});
  EXPECT_THAT(session.visited(), ElementsAre("free", "top"));
  session.set_visited({"words", "gone"});
  EXPECT_THAT(session.visited(), ElementsAre("top", "words")) << "where we are, and what there is";
}

TEST(LessonSession, TravelsForwardWithinAStageOnly) {
  LessonSession session(example());
  EXPECT_EQ(session.transition(), 1);
  session.next_step();
  EXPECT_EQ(session.transition(), 0);
  EXPECT_TRUE(session.is_moving());
  session.advance(kMorphSeconds / 2);
  EXPECT_NEAR(session.transition(), 0.5, 1e-12);
  session.advance(kMorphSeconds);
  EXPECT_EQ(session.transition(), 1);
  EXPECT_FALSE(session.is_moving());
  for (const StepPlace place : {StepPlace{0, 0}, StepPlace{0, 2}, StepPlace{1, 0}}) {
    session.go_to(place);
    EXPECT_EQ(session.transition(), 1) << place.stage << ' ' << place.step;
  }
}

TEST(LessonSession, DoesNotTravelWithReducedMotion) {
  LessonSession session(example());
  session.preferences.reduced_motion = true;
  session.next_step();
  EXPECT_EQ(session.transition(), 1);
  session.preferences.reduced_motion = false;
  session.next_step();
  EXPECT_LT(session.transition(), 1);
  session.preferences.reduced_motion = true;
  EXPECT_EQ(session.transition(), 1) << "at once";
  EXPECT_FALSE(session.is_moving());
}

TEST(LessonSession, EachQuestionHasItsOwnVerdict) {
  const auto asking = [](const char* id, const char* answer) {
    return fmt::format("```ask {}\ntype = \"expression\"\nprompt = 'What?'\nanswer = \"{}\"\n```\n", id,
                       answer);
  };
  LessonSession session(
      test::loaded_text("+++\nformat = 1\nid = \"two\"\ntitle = \"Two\"\n+++\n# Two {two}\nAsk.\n\n" +
                        asking("first", "w1") + asking("second", "w2")));
  const std::vector<const Ask*> asks = session.questions();
  ASSERT_EQ(asks.size(), 2u);
  session.answer(*asks[0], "w1*(");
  session.answer(*asks[1], "w2");
  ASSERT_TRUE(session.judged(*asks[0]) && session.judged(*asks[1]));
  EXPECT_EQ(session.judged(*asks[0])->text, "w1*(");
  EXPECT_EQ(session.judged(*asks[0])->judgement.mark, Mark::unreadable);
  EXPECT_EQ(session.judged(*asks[1])->text, "w2");
  EXPECT_EQ(session.judged(*asks[1])->judgement.mark, Mark::right);
}

TEST(LessonSession, JudgesAnAnswerAndKeepsIt) {
  LessonSession session(example());
  EXPECT_TRUE(session.questions().empty());
  session.next_step();
  ASSERT_EQ(session.questions().size(), 1u);
  const Ask& ask = *session.questions()[0];
  EXPECT_EQ(session.judged(ask), nullptr);
  EXPECT_EQ(session.record(ask), nullptr);

  EXPECT_EQ(session.answer(ask, "seven").mark, Mark::unreadable);
  ASSERT_NE(session.judged(ask), nullptr);
  EXPECT_EQ(session.record(ask), nullptr) << "it was no try";
  EXPECT_EQ(session.answer(ask, "1").mark, Mark::wrong);
  EXPECT_EQ(session.answer(ask, "B").mark, Mark::right);
  EXPECT_EQ(session.answer(ask, "A").mark, Mark::wrong);
  EXPECT_EQ(*session.record(ask), (AnswerRecord{1, 3, 0, "A", "B", {{"choice-A", 2}}}));
  EXPECT_EQ(session.judged(ask)->text, "A");
  EXPECT_EQ(session.answers().count("free/axis"), 1u) << "the name that `polhode answer` uses";

  session.next_step();
  session.previous_step();
  EXPECT_EQ(session.judged(ask), nullptr) << "the place was left";
  EXPECT_NE(session.record(ask), nullptr);
  session.forget_answer(ask);
  EXPECT_EQ(session.record(ask), nullptr);
}

TEST(LessonSession, ShowsOneHintAfterTheOther) {
  LessonSession session(example());
  session.next_step();
  const Ask& ask = *session.questions()[0];
  for (int shown : {1, 2, 3, 3}) {  // behind the last hint the answer
    session.show_hint(ask);
    ASSERT_NE(session.record(ask), nullptr);
    EXPECT_EQ(session.record(ask)->hints, shown);
  }
}

TEST(LessonSession, StaysWhereItWasInAnotherReadingOfTheLesson) {
  LessonSession session(example());
  session.go_to({0, 3});
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  session.scrub_to(0.25);
  session.set_playing(true);
  const std::string text = example()->lesson.source;
  const std::string more = "\n# New {new}\n\nBefore it.\n\n# Free {free}";
  std::string longer = text;
  longer.replace(longer.find("\n# Free {free}"), 14, more);
  session.replace_lesson(test::loaded_text(longer));
  EXPECT_EQ(session.place(), (StepPlace{1, 3}));
  EXPECT_EQ(session.t_s(), 0.25);
  EXPECT_TRUE(session.is_playing());
  EXPECT_EQ(session.model()->scene.w0_B, Vec3(1, 2, 3));

  std::string shorter = text.substr(0, text.find("\n---"));
  session.replace_lesson(test::loaded_text(shorter));
  EXPECT_EQ(session.place(), (StepPlace{0, 0}));
  EXPECT_THAT(session.visited(), ElementsAre("free"));
  std::string other = text.substr(0, text.find("\n# Free")) + "\n# Other {other}\n\nText.\n";
  session.replace_lesson(test::loaded_text(other));
  EXPECT_EQ(session.stage().id, "other");
  EXPECT_EQ(session.model(), nullptr);
}

TEST(LessonSession, DropsEditsThatANewReadingForbids) {
  LessonSession session(example());
  ASSERT_TRUE(session.set_edits({.motion = MotionSpec{.method = Method::rk4_projected, .step_s = 0.01}}));
  std::string text = example()->lesson.source;
  text.replace(text.find("at = 0.5"), 8, "torque = \"damping:0.1\"");
  session.replace_lesson(test::loaded_text(text));
  EXPECT_TRUE(session.edits().empty()) << "rk4-projected serves no torque";
}

TEST(LessonSession, ChangesTheSizeOfTextWithinBounds) {
  LessonSession session(example());
  session.change_text_scale(1);
  EXPECT_NEAR(session.preferences.text_scale, kTextScaleFactor, 1e-15);
  session.change_text_scale(100);
  EXPECT_EQ(session.preferences.text_scale, kMostTextScale);
  session.change_text_scale(-100);
  EXPECT_EQ(session.preferences.text_scale, kLeastTextScale);
}

}  // namespace
}  // namespace polhode
