// SPDX-License-Identifier: MIT
// What stands in the text column of a page to read, and where.
#include "app/page/text/page_text.h"

#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/page/sheet_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace polhode {
namespace {

Lesson lesson_of(const std::string& stages) {
  LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"text\"\ntitle = \"Text\"\n[scene]\nbody = \"textbook\"\n"
      "omega = [0.9, 0.4, 1.0]\n+++\n" +
          stages,
      "text.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

/// The page to read with the steps `first` to `last` of the stage, both from 1.
FittedText page_of(const Lesson& lesson, int stage, int first, int last, Size size = {1600, 900}) {
  std::vector<FiguredStep> before;
  for (int step = first; step < last; ++step) before.push_back({.step = step});
  const PageRequest request{.lesson = lesson,
                            .stage = lesson.stages[static_cast<std::size_t>(stage - 1)],
                            .number = stage,
                            .step = last,
                            .before = before,
                            .size = size};
  return text_of_page(request, test_fonts()).value();
}

constexpr double kPlace = 900.0;

double title_of(const FittedText& text) { return text.stack.pieces.at(1).sheet.texts.front().at.y(); }

TEST(PageText, ThatIsShortStandsInTheMiddleOfItsPlace) {
  constexpr const char* kPicture = "```scene\nshow = [\"omega\"]\n```\n";
  std::string lines;
  for (int i = 0; i < 20; ++i)
    lines += "Words that go on for a line of the page, which holds sixty letters.\n";
  const Lesson few = lesson_of(std::string("# S {s}\n") + kPicture + "Words.\n"),
               many = lesson_of(std::string("# S {s}\n") + kPicture + lines);
  const FittedText short_text = page_of(few, 1, 1, 1), long_text = page_of(many, 1, 1, 1);
  EXPECT_LT(title_of(long_text), 0.2 * kPlace);
  EXPECT_GT(title_of(short_text), title_of(long_text) + 0.2 * kPlace);
  EXPECT_EQ(short_text.stack.pieces.front().sheet.texts.front().at.y(),
            long_text.stack.pieces.front().sheet.texts.front().at.y())
      << "the header stays above";
  const FittedText upright = page_of(few, 1, 1, 1, {900, 1600});
  EXPECT_LT(title_of(upright), 0.2 * kPlace) << "below its figure it stays there";
}

TEST(PageText, RepeatsOnlyWhatItsStepsSayThatTheyGoOnFrom) {
  constexpr const char* kSteps = "# S {s}\n```math a\nx = 1\n```\n\n---\n\n```math b\ny = 2\n```\n\n---\n\n";
  const Lesson silent = lesson_of(std::string(kSteps) + "Words.\n"),
               says = lesson_of(std::string(kSteps) + "```scene\nfrom = \"a\"\n```\nWords.\n");
  EXPECT_TRUE(page_of(silent, 1, 3, 3).equations.empty());
  const FittedText text = page_of(says, 1, 3, 3);
  ASSERT_EQ(text.equations.size(), 1U);
  EXPECT_EQ(text.equations[0]->id, "a");
}

TEST(PageText, HasTheAnswersToTheStageBeforeAndAtTheEndItsOwn) {
  constexpr const char* kAsk =
      "```ask q\ntype = \"number\"\nprompt = \"How many?\"\nanswer = 1\nbecause = \"So it is.\"\n```\n";
  const Lesson lesson =
      lesson_of(std::string("# A {a}\n") + kAsk + "\n---\n\nMore.\n\n# B {b}\nWords.\n\n---\n\n" + kAsk);
  const auto answers = [&](int stage, int first, int last) {
    std::vector<FiguredStep> before(static_cast<std::size_t>(last - first));
    const PageRequest request{.lesson = lesson,
                              .stage = lesson.stages[static_cast<std::size_t>(stage - 1)],
                              .number = stage,
                              .step = last,
                              .before = before,
                              .size = {1600, 900}};
    return answers_at_foot(request, first);
  };
  EXPECT_EQ(answers(1, 1, 2), "") << "nobody sees them beside their questions";
  EXPECT_EQ(answers(2, 1, 1), "Answers to stage 1: step 1, 1");
  EXPECT_EQ(answers(2, 2, 2), "Answers to stage 2: step 2, 1") << "no page comes after it";
  EXPECT_EQ(answers(2, 1, 2), "Answers to stage 1: step 1, 1. Answers to stage 2: step 2, 1");
  const PageRequest alone{
      .lesson = lesson, .stage = lesson.stages[1], .number = 2, .step = 1, .size = {1600, 900}};
  EXPECT_EQ(answers_at_foot(alone, 1), "") << "a page of a window tells them when they are given";
}

}  // namespace
}  // namespace polhode
