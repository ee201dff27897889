// SPDX-License-Identifier: MIT
#include "app/session/answers/progress.h"

#include "tests/app/session/quiz_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;

TEST(Progress, CountsForEachOutcomeTheQuestionsThatTestIt) {
  const Lesson& lesson = test::quiz()->lesson;
  const AnswerLog answers{{"first/sign", {1, 2, 0, "", "", {}}},
                          {"first/which", {0, 1, 0, "", "", {}}},
                          {"first/order", {0, 0, 1, "", "", {}}},
                          {"gone/question", {1, 1, 0, "", "", {}}}};
  const Progress progress = progress_of(lesson, answers);
  EXPECT_EQ(progress.all, (QuestionCount{1, 2, 4}));
  // sign tests the first, which and derive both, order none.
  EXPECT_THAT(progress.outcomes, ElementsAre(QuestionCount{1, 2, 3}, QuestionCount{0, 1, 2}));
  EXPECT_EQ(progress.others, (QuestionCount{0, 0, 1}));
  EXPECT_EQ(words_of(progress.all), "1 of 4 right, 2 answered");
  EXPECT_EQ(words_of(progress.all, Language::de), "1 von 4 richtig, 2 beantwortet");
  EXPECT_EQ(open_words(progress.all), "2 not answered, 1 not yet right");
  EXPECT_EQ(open_words({.right = 3, .answered = 3, .asked = 3}), "");
  const ToRepeat repeat = to_repeat(lesson, answers);
  EXPECT_EQ(repeat.wrong.size(), 1U);
  EXPECT_EQ(repeat.skipped.size(), 2U);
  EXPECT_EQ(words_of({2, 2, 3}), "2 of 3 right");
}

TEST(Questions, StandInTheOrderInWhichTheyAreAsked) {
  std::vector<std::string> names;
  for (const PlacedAsk& question : questions_of(test::quiz()->lesson)) names.push_back(question.name);
  EXPECT_THAT(names, ElementsAre("first/sign", "first/which", "first/order", "second/derive"));
  EXPECT_EQ(questions_of(test::quiz()->lesson).back().place, (StepPlace{1, 1}));
  const std::vector<PlacedAsk> second = questions_of_stage(test::quiz()->lesson, 1);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second.front().name, "second/derive");
}

}  // namespace
}  // namespace polhode
