// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/footnotes.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::complaints;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::lesson_with;
using ::testing::SizeIs;

std::vector<Footnote> notes_of(const Step& step) {
  std::vector<Footnote> notes;
  for (const Footnote* note : blocks_of<Footnote>(step)) notes.push_back(*note);
  return notes;
}

std::string words_of(const RichText& text) {
  std::string words;
  for (const TextBlock& block : text)
    for (const TextSpan& span : block.spans) words += span.text;
  return words;
}

TEST(Footnotes, OpenWithTheirMarkAndAColon) {
  const auto opening = footnote_opening("[^a-1]: Text");
  ASSERT_TRUE(opening);
  EXPECT_EQ(opening->id, "a-1");
  EXPECT_EQ(opening->text, " Text");
  for (const char* none : {"[^a] Text", " [^a]: Text", "[a]: Text", "[^a", ""})
    EXPECT_FALSE(footnote_opening(none));
}

TEST(Footnotes, HaveRaisedNumbers) {
  EXPECT_EQ(raised_number(1), "¹");
  EXPECT_EQ(raised_number(120), "¹²⁰");
}

TEST(Footnotes, StandAtTheEndOfTheirStepInTheOrderOfTheirMarks) {
  const LessonReading reading =
      read_lesson(lesson_with("[^b]: Second\nnote, *on* two lines.\n[^a]: First $x$.\n\nText[^a] here.\n\n"
                              "> [!said] More[^b].\n\n---\nNext[^a].\n\n[^a]: Third.\n"),
                  "sample.md");
  ASSERT_TRUE(reading.lesson) << testing::lines_of(reading.diagnostics)[0];
  const Stage& stage = reading.lesson->stages[0];
  const auto first = notes_of(stage.steps[0]), second = notes_of(stage.steps[1]);
  ASSERT_THAT(first, SizeIs(2));
  ASSERT_THAT(second, SizeIs(1));
  EXPECT_EQ(words_of(first[0].text), "First x.");
  EXPECT_EQ(first[0].number, 1);
  EXPECT_EQ(words_of(first[1].text), "Second note, on two lines.");
  EXPECT_EQ(first[1].place, (SourcePlace{9, 3}));
  EXPECT_EQ(words_of(second[0].text), "Third.");
  EXPECT_EQ(second[0].number, 3) << "on a page that shows both steps the marks differ";
  EXPECT_TRUE(std::holds_alternative<Footnote>(stage.steps[0].blocks.back()));
  EXPECT_EQ(std::get<Prose>(stage.steps[0].blocks[0]).markdown, "Text[^a] here.");
}

TEST(Footnotes, ThatDoNotFitTheirMarksAreReported) {
  EXPECT_THAT(
      complaints(lesson_with("A[^on].\n\n[^one]: One.\n[^one]: Again.\n[^b c]: Bad.\n[^e]:\n[^f]: [^e]")),
      ElementsAre(
          "9:4: error: this step has no footnote \"on\" (did you mean \"one\"?)",
          "11:3: error: nothing in this step refers to footnote \"one\" (write [^one] where it "
          "belongs)",
          "12:3: error: footnote \"one\" is there already, on line 11",
          "13:3: error: bad id \"b c\" (an id has 1 to 64 of the characters a-z, A-Z, 0-9 and -)",
          "14:3: error: nothing in this step refers to footnote \"e\" (write [^e] where it belongs)",
          "15:3: error: nothing in this step refers to footnote \"f\" (write [^f] where it belongs)"));
  EXPECT_THAT(complaints(lesson_with("A[^1].\n\n---\nB.\n\n[^1]: One.")), SizeIs(2)) << "of another step";
  EXPECT_THAT(complaints(lesson_with("A[^1].\n\n[^1]: See [^1].\n")),
              ElementsAre("11:11: error: the mark of a footnote stands in text and call-outs only"));
  EXPECT_THAT(complaints(lesson_with("A[^1].\n\n[^1]:\n")),
              ElementsAre("11:3: error: this footnote is empty"));
  EXPECT_THAT(
      complaints(lesson_with("> [!said] A\n> [^1]: One.\n")),
      ElementsAre("10:3: error: a footnote begins at the margin, below an empty line or another one"));
}

TEST(Footnotes, EndAtTheLimit) {
  std::string marks, notes;
  for (std::size_t i = 1; i <= kMaxFootnotes; ++i) {
    marks += "[^" + std::to_string(i) + "] ";
    notes += "[^" + std::to_string(i) + "]: Note.\n";
  }
  EXPECT_THAT(complaints(lesson_with(marks + "\n\n" + notes)), IsEmpty());
  EXPECT_THAT(
      complaints(lesson_with(marks + "[^x]\n\n" + notes + "[^x]: More.\n")),
      ElementsAre("9:114: error: this step has no footnote \"x\" (one of 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, "
                  "12, 13, 14, 15, 16, 17, 18, 19, 20)",
                  "31:3: error: a step has at most 20 footnotes"));
}

}  // namespace
}  // namespace polhode
