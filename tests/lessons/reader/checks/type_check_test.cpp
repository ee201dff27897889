// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/type_check.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> complaints(const std::string& text) {
  const LessonReading reading = read_lesson(text, "lesson.md");
  EXPECT_TRUE(reading.lesson) << (reading.diagnostics.empty() ? "" : to_string(reading.diagnostics[0]));
  const auto fonts = Fonts::open();
  EXPECT_TRUE(fonts) << fonts.error();
  if (!reading.lesson || !fonts) return {"not read"};
  return testing::lines_of(check_type(*reading.lesson, *fonts, "lesson.md"));
}

TEST(TypeCheck, EveryLessonHasItsGlyphs) {
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    if (path.filename() == "FORMAT.md" || path.filename() == "README.md") continue;
    EXPECT_THAT(complaints(testing::read_file(path)), IsEmpty()) << path;
  }
  EXPECT_THAT(complaints(testing::example_lesson()), IsEmpty());
}

TEST(TypeCheck, SaysWhereAGlyphIsMissing) {
  EXPECT_THAT(
      complaints(
          testing::front_matter() +
          "# Ω 水 {a}\nω *a 火*\n\n> [!said] x\n> 土\n```ask a\ntype = 'choice'\nprompt = \"\\u0041 金\"\n"
          "choices = ['木', 'b']\nanswer = 1\nhints = ['日']\n```\n```scene\ncaption = 'ω 月'\n```\n"),
      ElementsAre("8:5: error: no font has the character U+6C34 (write another one)",
                  "9:6: error: no font has the character U+706B (write another one)",
                  "12:3: error: no font has the character U+571F (write another one)",
                  "15:18: error: no font has the character U+91D1 (write another one)",
                  "16:13: error: no font has the character U+6728 (write another one)",
                  "18:11: error: no font has the character U+65E5 (write another one)",
                  "21:14: error: no font has the character U+6708 (write another one)"));
}

TEST(TypeCheck, ReadsTheTitleOfTheLesson) {
  EXPECT_THAT(complaints("+++\nformat = 1\nid = \"a\"\ntitle = \"A 水\"\n+++\n# B {b}\nc\n"),
              ElementsAre("4:12: error: no font has the character U+6C34 (write another one)"));
}

TEST(TypeCheck, SaysWhatRunsFromRightToLeft) {
  EXPECT_THAT(complaints(testing::lesson_with("a ש\n")),
              ElementsAre("9:3: error: text from right to left is not set: U+05E9"));
}

TEST(TypeCheck, SaysACaptionOnce) {
  EXPECT_THAT(complaints(testing::lesson_with("```scene\ncaption = '月'\n```\n---\na\n\n---\nb\n")),
              ElementsAre("10:12: error: no font has the character U+6708 (write another one)"));
}

}  // namespace
}  // namespace polhode
