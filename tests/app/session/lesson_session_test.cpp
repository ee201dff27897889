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
using Outcome = AnswerJudgement::Outcome;

std::vector<Place> all_places(const Lesson& lesson) {
  std::vector<Place> places;
  for (std::size_t stage = 0; stage < lesson.stages.size(); ++stage)
    for (std::size_t step = 0; step < lesson.stages[stage].steps.size(); ++step)
      places.push_back({stage, step});
  return places;
}

TEST(Companion, WalksThroughEveryStepOfEveryLessonAndBack) {
  for (const char* id : test::kLessons) {
    Companion companion(test::loaded_lesson(id));
    const std::vector<Place> places = all_places(companion.lesson());
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(companion.place(), places[i]);
      EXPECT_EQ(companion.model() != nullptr, companion.has_scene());
      EXPECT_EQ(companion.next_step(), i + 1 < places.size());
    }
    EXPECT_EQ(companion.place(), places.back());
    EXPECT_EQ(companion.visited().size(), companion.lesson().stages.size());
    for (std::size_t i = places.size(); i-- > 0;) {
      EXPECT_EQ(companion.place(), places[i]);
      EXPECT_EQ(companion.previous_step(), i > 0);
    }
  }
}

TEST(Companion, GoesFromStageToStageByTheirBeginnings) {
  Companion companion(example());
  companion.go_to({0, 2});
  EXPECT_TRUE(companion.previous_stage());
  EXPECT_EQ(companion.place(), (Place{0, 0})) << "first to the beginning of this one";
  EXPECT_FALSE(companion.previous_stage());
  companion.go_to({0, 2});
  EXPECT_TRUE(companion.next_stage());
  EXPECT_TRUE(companion.next_stage());
  EXPECT_EQ(companion.place(), (Place{2, 0}));
  EXPECT_FALSE(companion.next_stage());
  EXPECT_TRUE(companion.previous_stage());
  EXPECT_EQ(companion.place(), (Place{1, 0}));
}

TEST(Companion, TakesThePlaceNearestToOneThatDoesNotExist) {
  Companion companion(example());
  companion.go_to({0, 99});
  EXPECT_EQ(companion.place(), (Place{0, 3}));
  companion.go_to({99, 99});
  EXPECT_EQ(companion.place(), (Place{2, 0}));
}

TEST(Companion, KnowsWhichStagesWereSeen) {
  Companion companion(example());
  EXPECT_THAT(companion.visited(), ElementsAre("free"));
  companion.go_to({2, 0});
  EXPECT_THAT(companion.visited(), ElementsAre("free", "top"));
  companion.set_visited({"words", "gone"});
  EXPECT_THAT(companion.visited(), ElementsAre("top", "words")) << "where we are, and what there is";
}

TEST(Companion, TravelsForwardWithinAStageOnly) {
  Companion companion(example());
  EXPECT_EQ(companion.travel(), 1);
  companion.next_step();
  EXPECT_EQ(companion.travel(), 0);
  EXPECT_TRUE(companion.is_moving());
  companion.advance(kMorphSeconds / 2);
  EXPECT_NEAR(companion.travel(), 0.5, 1e-12);
  companion.advance(kMorphSeconds);
  EXPECT_EQ(companion.travel(), 1);
  EXPECT_FALSE(companion.is_moving());
  for (const Place place : {Place{0, 0}, Place{0, 2}, Place{1, 0}}) {
    companion.go_to(place);
    EXPECT_EQ(companion.travel(), 1) << place.stage << ' ' << place.step;
  }
}

TEST(Companion, DoesNotTravelWithReducedMotion) {
  Companion companion(example());
  companion.preferences.reduced_motion = true;
  companion.next_step();
  EXPECT_EQ(companion.travel(), 1);
  companion.preferences.reduced_motion = false;
  companion.next_step();
  EXPECT_LT(companion.travel(), 1);
  companion.preferences.reduced_motion = true;
  EXPECT_EQ(companion.travel(), 1) << "at once";
  EXPECT_FALSE(companion.is_moving());
}

TEST(Companion, EachQuestionHasItsOwnVerdict) {
  const auto asking = [](const char* id, const char* answer) {
    return fmt::format("```ask {}\ntype = \"expression\"\nprompt = 'What?'\nanswer = \"{}\"\n```\n", id,
                       answer);
  };
  Companion companion(
      test::loaded_text("+++\nformat = 1\nid = \"two\"\ntitle = \"Two\"\n+++\n# Two {two}\nAsk.\n\n" +
                        asking("first", "w1") + asking("second", "w2")));
  const std::vector<const Ask*> asks = companion.questions();
  ASSERT_EQ(asks.size(), 2u);
  companion.answer(*asks[0], "w1*(");
  companion.answer(*asks[1], "w2");
  ASSERT_TRUE(companion.judged(*asks[0]) && companion.judged(*asks[1]));
  EXPECT_EQ(companion.judged(*asks[0])->text, "w1*(");
  EXPECT_EQ(companion.judged(*asks[0])->judgement.outcome, Outcome::unreadable);
  EXPECT_EQ(companion.judged(*asks[1])->text, "w2");
  EXPECT_EQ(companion.judged(*asks[1])->judgement.outcome, Outcome::right);
}

TEST(Companion, JudgesAnAnswerAndKeepsIt) {
  Companion companion(example());
  EXPECT_TRUE(companion.questions().empty());
  companion.next_step();
  ASSERT_EQ(companion.questions().size(), 1u);
  const Ask& ask = *companion.questions()[0];
  EXPECT_EQ(companion.judged(ask), nullptr);
  EXPECT_EQ(companion.record(ask), nullptr);

  EXPECT_EQ(companion.answer(ask, "seven").outcome, Outcome::unreadable);
  ASSERT_NE(companion.judged(ask), nullptr);
  EXPECT_EQ(companion.record(ask), nullptr) << "it was no try";
  EXPECT_EQ(companion.answer(ask, "1").outcome, Outcome::wrong);
  EXPECT_EQ(companion.answer(ask, "B").outcome, Outcome::right);
  EXPECT_EQ(companion.answer(ask, "A").outcome, Outcome::wrong);
  EXPECT_EQ(*companion.record(ask), (AnswerRecord{true, 3, 0, "A"}));
  EXPECT_EQ(companion.judged(ask)->text, "A");
  EXPECT_EQ(companion.answers().count("free/axis"), 1u) << "the name that `polhode answer` uses";

  companion.next_step();
  companion.previous_step();
  EXPECT_EQ(companion.judged(ask), nullptr) << "the place was left";
  EXPECT_NE(companion.record(ask), nullptr);
  companion.forget_answer(ask);
  EXPECT_EQ(companion.record(ask), nullptr);
}

TEST(Companion, ShowsOneHintAfterTheOther) {
  Companion companion(example());
  companion.next_step();
  const Ask& ask = *companion.questions()[0];
  for (int shown : {1, 2, 2}) {
    companion.show_hint(ask);
    ASSERT_NE(companion.record(ask), nullptr);
    EXPECT_EQ(companion.record(ask)->hints, shown);
  }
}

TEST(Companion, StaysWhereItWasInAnotherReadingOfTheLesson) {
  Companion companion(example());
  companion.go_to({0, 3});
  ASSERT_TRUE(companion.set_edits({.w0_B = Vec3(1, 2, 3)}));
  companion.scrub_to(0.25);
  companion.set_playing(true);
  const std::string text = example()->lesson.source;
  const std::string more = "\n# New {new}\n\nBefore it.\n\n# Free {free}";
  std::string longer = text;
  longer.replace(longer.find("\n# Free {free}"), 14, more);
  companion.replace_lesson(test::loaded_text(longer));
  EXPECT_EQ(companion.place(), (Place{1, 3}));
  EXPECT_EQ(companion.t_s(), 0.25);
  EXPECT_TRUE(companion.is_playing());
  EXPECT_EQ(companion.model()->scene.w0_B, Vec3(1, 2, 3));

  std::string shorter = text.substr(0, text.find("\n---"));
  companion.replace_lesson(test::loaded_text(shorter));
  EXPECT_EQ(companion.place(), (Place{0, 0}));
  EXPECT_THAT(companion.visited(), ElementsAre("free"));
  std::string other = text.substr(0, text.find("\n# Free")) + "\n# Other {other}\n\nText.\n";
  companion.replace_lesson(test::loaded_text(other));
  EXPECT_EQ(companion.stage().id, "other");
  EXPECT_EQ(companion.model(), nullptr);
}

TEST(Companion, DropsEditsThatANewReadingForbids) {
  Companion companion(example());
  ASSERT_TRUE(companion.set_edits({.motion = MotionSpec{.method = Method::rk4_projected, .step_s = 0.01}}));
  std::string text = example()->lesson.source;
  text.replace(text.find("at = 0.5"), 8, "torque = \"damping:0.1\"");
  companion.replace_lesson(test::loaded_text(text));
  EXPECT_TRUE(companion.edits().empty()) << "rk4-projected serves no torque";
}

TEST(Companion, ChangesTheSizeOfTextWithinBounds) {
  Companion companion(example());
  companion.change_text_scale(1);
  EXPECT_NEAR(companion.preferences.text_scale, kTextScaleFactor, 1e-15);
  companion.change_text_scale(100);
  EXPECT_EQ(companion.preferences.text_scale, kMostTextScale);
  companion.change_text_scale(-100);
  EXPECT_EQ(companion.preferences.text_scale, kLeastTextScale);
}

}  // namespace
}  // namespace polhode
