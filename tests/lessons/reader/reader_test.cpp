// SPDX-License-Identifier: MIT
#include "lessons/reader/reader.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::complaints;
using ::testing::ElementsAre;
using testing::front_matter;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lesson_with;

TEST(ReadLesson, GivesTheExampleOfTheReferenceAsWritten) {
  const LessonReading reading = read_lesson(testing::example_lesson(), "example.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty());
  ASSERT_TRUE(reading.lesson);
  const Lesson& lesson = *reading.lesson;
  EXPECT_EQ(lesson.id, "spin-about-three-axes");
  EXPECT_EQ(lesson.title, "One body, three spins");
  ASSERT_EQ(lesson.stages.size(), 2U);
  EXPECT_EQ(lesson.symbols.at("omega").say, "angular velocity");
  const Stage& first = lesson.stages[0];
  EXPECT_EQ(first.id, "conserved");
  ASSERT_EQ(first.steps.size(), 2U);
  EXPECT_EQ(first.steps[0].scene->w0_B, Vec3(0.1, 3.0, 0.1));
  EXPECT_THAT(first.steps[0].scene->views, ElementsAre(View::space, View::body));
  EXPECT_THAT(first.steps[1].scene->views, ElementsAre(View::body));
  EXPECT_THAT(first.steps[1].scene->highlight, ElementsAre("body"));
  EXPECT_EQ(lesson.find_stage("stable")->steps[0].scene->motion.method, Method::rk4);
  EXPECT_THAT(std::get<Ask>(lesson.stages[1].steps[0].blocks[0]).answers, ElementsAre(2));
}

TEST(ReadLesson, PutsTheFileNameIntoEveryDiagnostic) {
  const LessonReading reading = read_lesson("", "folder/a.md");
  ASSERT_EQ(reading.diagnostics.size(), 1U);
  EXPECT_EQ(reading.diagnostics[0].file, "folder/a.md");
  EXPECT_FALSE(reading.lesson);
}

TEST(ReadLesson, TakesWindowsLineEndsAndAByteOrderMark) {
  std::string text = testing::example_lesson();
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 2) text.insert(i, 1, '\r');
  const LessonReading reading = read_lesson("\xEF\xBB\xBF" + text, "example.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty());
  ASSERT_TRUE(reading.lesson);
  EXPECT_EQ(reading.lesson->stages[0].title, "What is conserved");
}

TEST(ReadLesson, GivesALessonInSpiteOfWarnings) {
  const LessonReading reading = read_lesson(lesson_with("It costs $5.\n"), "sample.md");
  EXPECT_EQ(reading.diagnostics.size(), 1U);
  EXPECT_TRUE(reading.lesson);
}

TEST(ReadLesson, WarnsOfMacrosThatAreUsedNowhere) {
  const std::string macros = "[macros]\nw = '\\vec\\omega'\nww = '\\w_2'\n";
  const auto unused = [&](const std::string& body) { return testing::complaints_of(body, macros); };
  EXPECT_THAT(unused("Here $\\w$.\n"), ElementsAre(HasSubstr("\"ww\" is used nowhere")));
  EXPECT_THAT(unused("Here $\\ww$.\n"), IsEmpty());
}

TEST(ReadLesson, ReportsFrontMatterAndTextAtOnce) {
  EXPECT_THAT(
      complaints(
          "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\ncolour = 1\n+++\n# A {a}\n```scene\nat = ''\n```\n"),
      ElementsAre("5:1: error: unknown key \"colour\" in the front matter (one of format, id, title, body, "
                  "language, axes, "
                  "macros, constants, define, symbols, assume, scene, author, licence, outcomes, "
                  "prerequisites, next, labels, references)",
                  "9:6: error: \"at\" takes a number, found a string"));
}

TEST(ReadLesson, DoesNotBlameBodiesThatAWrongFrontMatterMayHold) {
  const auto lines = complaints("+++\nformat = \n+++\n# A {a}\n```scene\nbody = 'mine'\n```\n");
  EXPECT_EQ(lines.size(), 1U);
}

// As far as figures go, and without what other stages say.
TEST(ReadStage, HasTheFiguresOfTheWholeLesson) {
  for (const char* name : {"euler-equations", "heavy-top"}) {
    const std::string text = testing::read_file(test::source_dir() / "lessons" / (std::string(name) + ".md"));
    const LessonReading whole = read_lesson(text, name);
    ASSERT_TRUE(whole.lesson) << name;
    for (std::size_t i = 0; i < whole.lesson->stages.size(); ++i) {
      const Stage& stage = whole.lesson->stages[i];
      const LessonReading alone = read_stage(text, name, stage.id);
      ASSERT_TRUE(alone.lesson) << stage.id << ' '
                                << ::testing::PrintToString(testing::lines_of(alone.diagnostics));
      ASSERT_EQ(alone.lesson->stages.size(), whole.lesson->stages.size());
      for (std::size_t j = 0; j < alone.lesson->stages.size(); ++j) {
        EXPECT_EQ(alone.lesson->stages[j].id, whole.lesson->stages[j].id);
        EXPECT_TRUE(j == i || alone.lesson->stages[j].steps.at(0).blocks.empty());
      }
      const std::vector<Step>& steps = alone.lesson->stages[i].steps;
      ASSERT_EQ(steps.size(), stage.steps.size()) << stage.id;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        ASSERT_EQ(steps[k].scene == nullptr, stage.steps[k].scene == nullptr);
        EXPECT_TRUE(steps[k].scene == nullptr || *steps[k].scene == *stage.steps[k].scene)
            << stage.id << ' ' << k;
        EXPECT_EQ(steps[k].captions.size(), stage.steps[k].captions.size());
        EXPECT_EQ(steps[k].blocks.size(), stage.steps[k].blocks.size());
        EXPECT_EQ(steps[k].varied == nullptr, stage.steps[k].varied == nullptr);
      }
    }
  }
}

TEST(ReadStage, SaysWhatIsWrongInItAlone) {
  const std::string text =
      front_matter() + "# A {a}\n```scene\nat = ''\n```\n# B {b}\nText, see [](#nowhere).\n";
  EXPECT_TRUE(read_stage(text, "x.md", "b").lesson);
  EXPECT_TRUE(read_stage(text, "x.md", "").lesson);
  EXPECT_FALSE(read_stage(text, "x.md", "a").lesson);
  EXPECT_FALSE(read_stage("# A {a}\n", "x.md", "").lesson) << "without front matter";
}

TEST(ReadLesson, IsTheSameWhenReadAgain) {
  const std::string text =
      testing::read_file(test::source_dir() / "tests/data/lessons/invalid/scene-keys.md");
  EXPECT_EQ(complaints(text), complaints(text));
}

}  // namespace
}  // namespace polhode
