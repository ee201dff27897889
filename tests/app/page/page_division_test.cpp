// SPDX-License-Identifier: MIT
#include "app/page/page_division.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/narration/still_numbers.h"
#include "app/page/text/page_text.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/page/sheet_checks.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace polhode {
namespace {

using testing::ElementsAre;

Lesson lesson_of(const std::string& body) {
  const std::string text =
      "+++\nformat = 1\nid = \"page\"\ntitle = \"Pages\"\n[scene]\nbody = \"textbook\"\n"
      "omega = [0.9, 0.4, 1.0]\n+++\n# S {s}\n" +
      body;
  LessonReading reading = check_lesson(text, "page.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

/// Some lines of a page that holds about thirty of them.
std::string lines(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "Words that go on for a line of the page, which holds some sixty letters. ";
  return text + "\n";
}

std::vector<int> pages_of(const Lesson& lesson, Size size = {1600, 900}) {
  return pages_of_stage({.lesson = lesson, .stage = lesson.stages[0], .size = size}, test_fonts()).value();
}

constexpr const char* kQuestion =
    "```ask q\ntype = \"number\"\nprompt = \"How many?\"\nanswer = 1\nbecause = \"So it "
    "is.\"\n```\n";

TEST(PageDivision, ShortStepsStandTogetherAndLongOnesApart) {
  EXPECT_THAT(pages_of(lesson_of("One.\n\n---\n\nTwo.\n")), ElementsAre(2));
  EXPECT_THAT(pages_of(lesson_of(lines(14) + "\n---\n\n" + lines(14))), ElementsAre(1, 2));
}

TEST(PageDivision, AStepThatIsLongerThanAPageHasItsOwn) {
  EXPECT_THAT(pages_of(lesson_of("One.\n\n---\n\n" + lines(40) + "\n---\n\nThree.\n")), ElementsAre(1, 2, 3));
}

TEST(PageDivision, OfDivisionsThatAreAsGoodTheQuestionEndsItsPage) {
  const std::string long_step = lines(3) + "\n---\n\n";
  EXPECT_THAT(pages_of(lesson_of(long_step + kQuestion + "\n---\n\n" + long_step + lines(3))),
              ElementsAre(2, 4));
  EXPECT_THAT(pages_of(lesson_of(long_step + long_step + kQuestion + "\n---\n\n" + lines(3))),
              ElementsAre(3, 4));
}

TEST(PageDivision, NothingFollowsAPrediction) {
  constexpr const char* kPrediction =
      "```ask p\ntype = \"predict\"\nprompt = \"Which?\"\nbecause = \"So it is.\"\n\n- [x] this\n- [ ] "
      "that\n```\n";
  for (const int long_part : {1, 10, 20})
    EXPECT_THAT(pages_of(lesson_of(std::string(kPrediction) + "\n---\n\n" + lines(long_part))),
                ElementsAre(1, 2))
        << long_part;
}

TEST(PageDivision, APageHasNoMorePicturesThanOneCanSee) {
  std::string steps;
  for (int i = 1; i <= 8; ++i)
    steps += fmt::format("{}```scene\nat = {}\n```\nWords.\n", i > 1 ? "\n---\n\n" : "", 0.1 * i);
  int last = 0;
  for (const int end : pages_of(lesson_of(steps))) {
    EXPECT_LE(end - last, kMostFiguresOnPage);
    last = end;
  }
  EXPECT_EQ(last, 8);
}

// Whatever the lecture has: nothing is lost, nothing stands twice, and no type is smaller for company.
TEST(PageDivision, OfTheLectureHasEachStepWholeAndInNormalType) {
  const Lesson lesson =
      or_fail(load_lesson((test::source_dir() / "lessons/euler-equations.md").string())).lesson;
  StillNumbers numbers;
  int number = 0;
  for (const Stage& stage : lesson.stages) {
    PageRequest request{
        .lesson = lesson, .stage = stage, .number = ++number, .size = {1600, 900}, .still_numbers = &numbers};
    int last = 0;
    const std::vector<int> ends = pages_of_stage(request, test_fonts()).value();
    for (const int end : ends) {
      ASSERT_GT(end, last) << stage.id;
      std::vector<FiguredStep> before;
      for (int step = last + 1; step < end; ++step) before.push_back({.step = step});
      request.step = end;
      request.before = before;
      const FittedText text = text_of_page(request, test_fonts()).value();
      EXPECT_EQ(text.whole_from, last + 1) << stage.id;
      EXPECT_EQ(text.step_tops.size(), before.size() + 1) << stage.id;
      if (!before.empty()) {
        EXPECT_EQ(text.scale, 1.0) << stage.id << ' ' << end;
      }
      last = end;
    }
    EXPECT_EQ(last, std::ssize(stage.steps)) << stage.id;
  }
}

}  // namespace
}  // namespace polhode
