// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/outcome_key.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TextReport;

std::optional<std::vector<int>> outcomes_from(TextReport& at, std::size_t count) {
  return read_outcomes(testing::toml(at.text).entries.front(), count, at.report);
}

TEST(OutcomeKey, IsANumberOrSome) {
  TextReport one("outcome = 2");
  EXPECT_THAT(outcomes_from(one, 3).value(), ElementsAre(2));
  TextReport some("outcome = [3, 1]");
  EXPECT_THAT(outcomes_from(some, 3).value(), ElementsAre(1, 3));
  EXPECT_THAT(some.lines(), IsEmpty());
}

TEST(OutcomeKey, RefusesWhatTheLessonDoesNotName) {
  const std::pair<const char*, const char*> cases[] = {
      {"outcome = 4", "1:11: error: an outcome is the number of one in the front matter, 1 to 3"},
      {"outcome = 0", "1 to 3"},
      {"outcome = -1", "1 to 3"},
      {"outcome = 1.0", "1 to 3"},
      {"outcome = 'first'", "1 to 3"},
      {"outcome = []", "1:11: error: no outcome is named"},
      {"outcome = [1, 4]", "1:15: error: an outcome is the number"},
      {"outcome = [1, 2, 1]", "1:18: error: outcome 1 twice"}};
  for (const auto& [text, wanted] : cases) {
    TextReport at(text);
    EXPECT_FALSE(outcomes_from(at, 3)) << text;
    EXPECT_THAT(at.lines(), ElementsAre(HasSubstr(wanted)));
  }
}

TEST(OutcomeKey, OfALessonWithoutOutcomesSaysWhereTheyBelong) {
  TextReport at("outcome = 1");
  EXPECT_FALSE(outcomes_from(at, 0));
  EXPECT_THAT(at.lines(), ElementsAre("1:1: error: the lesson names no outcomes (list them in the front "
                                      "matter: outcomes = [\"…\"])"));
}

TEST(OutcomeKey, IsReadFromQuestionsOfALesson) {
  const std::string before =
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\noutcomes = [\"know x\", \"know y\"]\n+++\n# A "
      "{a}\nText.\n\n"
      "```ask q\ntype = 'choice'\nprompt = 'Which?'\nchoices = ['x', 'y']\nanswer = 1\noutcome = ";
  const LessonReading read = read_lesson(before + "[2]\n```\n", "a.md");
  ASSERT_TRUE(read.lesson) << testing::lines_of(read.diagnostics).front();
  EXPECT_THAT(blocks_of<Ask>(read.lesson->stages[0].steps[0])[0]->outcomes, ElementsAre(2));
  EXPECT_THAT(testing::complaints(before + "3\n```\n"),
              ElementsAre(HasSubstr("15:11: error: an outcome is")));
}

}  // namespace
}  // namespace polhode
