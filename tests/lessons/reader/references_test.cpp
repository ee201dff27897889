// SPDX-License-Identifier: MIT
#include "lessons/reader/references.h"

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

constexpr const char* kEquations =
    "\n\n```math a\nx \\tag{7}\n```\n```math plain\ny\n```\n# The *second* $z$ {two}\n```math b\nz "
    "\\tag{8}\n```\n";

Lesson lesson_of(const std::string& text) {
  LessonReading reading = read_lesson(lesson_with(text + kEquations), "sample.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty()) << text;
  return reading.lesson ? std::move(*reading.lesson) : Lesson{};
}

/// "[text](link)" for each link of the first text.
std::string links_in(const Lesson& lesson) {
  std::string all;
  for (const TextSpan& span : std::get<Prose>(lesson.stages.at(0).steps[0].blocks[0]).text.at(0).spans)
    if (!span.link.empty()) all += '[' + span.text + "](" + span.link + ')';
  return all;
}

TEST(References, ShowWhatTheyLeadTo) {
  EXPECT_EQ(links_in(lesson_of("By [](#a) and [](#two/b), see [](#two).")),
            "[(7)](#sample/a)[(8)](#two/b)[The ](#two)[second](#two)[ ](#two)[z](#two)");
}

TEST(References, MayHaveATextOfTheirOwn) {
  EXPECT_EQ(
      links_in(
          lesson_of("[the *first* $x$](#a) [this](#sample) [that](#plain) [web](https://a.b) <https://c.d>")),
      "[the ](#sample/a)[first](#sample/a)[ ](#sample/a)[x](#sample/a)[this](#sample)[that](#sample/plain)"
      "[web](https://a.b)[https://c.d](https://c.d)");
}

TEST(References, MeanTheStageWhereAnEquationHasTheSameId) {
  const Lesson lesson = lesson_of("[s](#two) [e](#sample/two)\n\n```math two\nq\n```\n");
  EXPECT_EQ(links_in(lesson), "[s](#two)[e](#sample/two)");
  EXPECT_EQ(target_of(lesson, "#two"), (StepPlace{1, 0}));
  EXPECT_EQ(target_of(lesson, "#sample/two"), (StepPlace{0, 0}));
  EXPECT_EQ(target_of(lesson, "#sample/b"), std::nullopt);
  EXPECT_EQ(target_of(lesson, "https://a.b"), std::nullopt);
}

TEST(References, LeadToTheStepThatBringsTheEquation) {
  const Lesson lesson = lesson_of("x\n\n---\n```math late\nx\n```\n");
  EXPECT_EQ(target_of(lesson, "#sample/late"), (StepPlace{0, 1}));
}

TEST(References, OfFormulasAreNumbers) {
  const Lesson lesson = lesson_of("By $\\eqref{a}$.\n\n```math c\nx = \\eqref{two/b}\n```\n");
  const auto& equation = std::get<Equation>(lesson.stages[0].steps[0].blocks[1]);
  const auto say = [](std::string_view) { return std::string(); };
  EXPECT_EQ(spoken(equation.math, {}, say), "x equals (8)");
  const auto& prose = std::get<Prose>(lesson.stages[0].steps[0].blocks[0]);
  EXPECT_EQ(spoken(prose.text[0].spans[1].math, {}, say), "(7)");
}

TEST(References, ThatLeadNowhereAreReported) {
  const auto of = [](const std::string& text) { return complaints(lesson_with(text + kEquations)); };
  EXPECT_THAT(of("[x](#tow)"),
              ElementsAre("9:2: error: no stage, and no equation of this one, is called \"tow\" "
                          "(did you mean \"two\"?)"));
  EXPECT_THAT(of("[**x** y](#b)"),
              ElementsAre("9:4: error: no stage, and no equation of this one, is called \"b\" "
                          "(that of stage \"two\" is #two/b)"));
  EXPECT_THAT(of("[](#tvo/b)"),
              ElementsAre("9:1: error: no stage is called \"tvo\" (did you mean \"two\"?)"));
  EXPECT_THAT(of("[](#two/a)"),
              ElementsAre("9:1: error: no equation of stage \"two\" is called \"a\" (only b)"));
  EXPECT_THAT(of("[](#plain)"),
              ElementsAre("9:1: error: equation \"plain\" has no number to be shown (give it a "
                          "\\tag{…}, or the link a text)"));
  EXPECT_THAT(of("$\\eqref{c}$"),
              ElementsAre("9:9: error: no equation of this stage is called \"c\" (one of a, plain)"));
  EXPECT_THAT(of("$\\eqref{two}$"), SizeIs(1)) << "a stage has no number";
  EXPECT_THAT(of("[x](two)"),
              ElementsAre("9:2: error: this link leads nowhere: \"two\" (write https://…, #stage, "
                          "#equation, #stage/equation or lesson#stage)"));
  EXPECT_THAT(of("[](https://a.b)"),
              ElementsAre("9:1: error: a link out of the lesson needs a text ([text](…))"));
  EXPECT_THAT(of("[](other#two)"),
              ElementsAre("9:1: error: a link out of the lesson needs a text ([text](…))"));
  EXPECT_THAT(of("[x](other#)"),
              ElementsAre("9:2: error: bad link to another lesson: \"other#\" (write lesson#stage or "
                          "lesson#stage/equation)"));
  EXPECT_THAT(of("x\n\n# T [](#two) {t}\nx"),
              ElementsAre("11:5: error: a link in a title needs a text ([text](…))"));
  EXPECT_THAT(of("```scene\ncaption = 'By $\\eqref{a}$'\n```"),
              ElementsAre("10:23: error: \\eqref stands in texts and displays only"));
}

TEST(References, ToOtherLessonsAreListed) {
  const Lesson lesson = lesson_of("[x](other#two) [y](other#two/b)");
  ASSERT_THAT(lesson.other_lessons, SizeIs(2));
  EXPECT_EQ(lesson.other_lessons[1].lesson, "other");
  EXPECT_EQ(lesson.other_lessons[1].stage, "two");
  EXPECT_EQ(lesson.other_lessons[1].equation, "b");
  EXPECT_EQ(lesson.other_lessons[1].place, (SourcePlace{9, 17}));
}

TEST(References, ShowNoMoreThanALessonMayHold) {
  const std::string title(8000, 'x');
  std::string links;
  for (std::size_t i = 0; i <= kMaxShownReferenceBytes / title.size(); ++i) links += "[](#long) ";
  EXPECT_THAT(complaints(lesson_with(links + "\n\n# " + title + " {long}\nx\n")), SizeIs(1));
}

}  // namespace
}  // namespace polhode
