// SPDX-License-Identifier: MIT
#include "lessons/reader/stage_builder.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lesson_with;
using ::testing::SizeIs;

Stage stage_of(const std::string& body) {
  const LessonReading reading = read_lesson(lesson_with(body), "sample.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty()) << body;
  return reading.lesson ? reading.lesson->stages.at(0) : Stage{};
}

TEST(Stages, HaveStepsAndBlocksInTheirOrder) {
  const Stage stage = stage_of(
      "Text $x$.\n\nMore.\n```math a\nx \\tag{1}\n```\n```claim a law\nL = L\n```\n---\n> [!said] a\n> "
      "[!meant] b\n");
  ASSERT_THAT(stage.steps, SizeIs(2));
  ASSERT_THAT(stage.steps[0].blocks, SizeIs(3));
  const auto& prose = std::get<Prose>(stage.steps[0].blocks[0]);
  EXPECT_EQ(prose.markdown, "Text $x$.\n\nMore.");
  EXPECT_EQ(prose.place, (SourcePlace{9, 1}));
  const auto& equation = std::get<Equation>(stage.steps[0].blocks[1]);
  EXPECT_EQ(equation.id, "a");
  EXPECT_EQ(equation.tex, "x \\tag{1}");
  EXPECT_EQ(equation.tag, "1");
  EXPECT_EQ(equation.place, (SourcePlace{12, 1}));
  const auto& claim = std::get<Claim>(stage.steps[0].blocks[2]);
  EXPECT_EQ(claim.equation, "a");
  EXPECT_EQ(claim.kind, ClaimKind::law);
  EXPECT_THAT(claim.lines, SizeIs(1));
  ASSERT_THAT(stage.steps[1].blocks, SizeIs(2));
  EXPECT_EQ(std::get<Callout>(stage.steps[1].blocks[1]).markdown, "b");
}

std::string words_of(const RichText& title) {
  std::string words;
  for_each_span(title, [&](const TextSpan& span) { words += span.text; });
  return words;
}

TEST(Steps, AreNamedByATitle) {
  const Stage stage =
      stage_of("## One holds $L$\na\n\n---\n## Two follows\nb\n\n## Three stands alone\nc\n\n---\nd\n");
  ASSERT_THAT(stage.steps, SizeIs(4));
  EXPECT_EQ(words_of(stage.steps[0].title), "One holds L");
  EXPECT_EQ(words_of(stage.steps[1].title), "Two follows");
  EXPECT_EQ(words_of(stage.steps[2].title), "Three stands alone");
  EXPECT_TRUE(stage.steps[3].title.empty());
  EXPECT_EQ(stage.steps[0].place, stage.place);
  EXPECT_EQ(stage.steps[2].place, (SourcePlace{16, 1})) << "of the title that it begins with";
  for (const Step& step : stage.steps) EXPECT_THAT(step.blocks, SizeIs(1));
}

TEST(Steps, TitlesThatNameNothingAreErrors) {
  const auto said = [](const std::string& body) {
    return testing::lines_of(read_lesson(lesson_with(body), "sample.md").diagnostics);
  };
  EXPECT_THAT(said("##\ntext\n"), ElementsAre(HasSubstr("this step has no title")));
  EXPECT_THAT(said("## A {id}\ntext\n"), ElementsAre(HasSubstr(":6: error: a step has no id")));
  EXPECT_THAT(said("text\n\n## A\n\n## B\nmore\n"), ElementsAre(HasSubstr("this step is empty")));
  EXPECT_THAT(said("## [](#sample)\ntext\n"), ElementsAre(HasSubstr("a link in a title needs a text")));
}

TEST(Scenes, AreAbsentUntilTheFirstAndThenPersist) {
  const Stage stage = stage_of("a\n\n---\n```scene\nat = 1\n```\n---\nb\n\n---\n```scene\nshow = 'L'\n```\n");
  ASSERT_THAT(stage.steps, SizeIs(4));
  EXPECT_FALSE(stage.steps[0].scene);
  EXPECT_EQ(stage.steps[1].scene->at_s, 1);
  EXPECT_EQ(stage.steps[1].scene->body.name, "book") << "from the front matter";
  EXPECT_EQ(stage.steps[2].scene->at_s, 1);
  EXPECT_EQ(stage.steps[3].scene->at_s, 1);
  EXPECT_TRUE(stage.steps[3].scene->show.contains(Overlay::L));
}

TEST(Scenes, StartAfreshInEachStage) {
  const LessonReading reading = read_lesson(
      lesson_with("```scene\nat = 1\n```\n# Next {next}\n```scene\nrate = 2\n```\n# Last {last}\ntext\n"),
      "");
  ASSERT_TRUE(reading.lesson);
  EXPECT_EQ(reading.lesson->stages[1].steps[0].scene->at_s, 0);
  EXPECT_EQ(reading.lesson->stages[1].steps[0].scene->rate, 2);
  EXPECT_FALSE(reading.lesson->stages[2].steps[0].scene) << "a stage without a scene shows text alone";
}

TEST(Scenes, MayHighlightTermsAndOverlaysOfTheirStageOnly) {
  const std::string math = "```math a\n\\term{turn}{x}\n```\n";
  stage_of(math + "```scene\nhighlight = ['turn', 'polhode']\n```\n");
  stage_of("```scene\nhighlight = 'turn'\n```\n---\n" + math);
  EXPECT_THAT(testing::complaints(lesson_with(math + "# Next {next}\n```scene\nhighlight = 'turn'\n```\n")),
              SizeIs(1));
}

TEST(PrintedClaims, AreWhatTheFormulaSays) {
  const Stage stage =
      stage_of("```math a free\n2T = \\vec\\omega\\cdot\\vec L\\,,\\quad\n\\frac{dT}{dt} = 0\n```\n");
  const auto& claim = std::get<Claim>(stage.steps[0].blocks.at(1));
  EXPECT_EQ(claim.origin, Claim::Origin::formula);
  EXPECT_EQ(claim.equation, "a");
  EXPECT_EQ(claim.kind, ClaimKind::free);
  ASSERT_THAT(claim.lines, SizeIs(2));
  EXPECT_EQ(claim.lines[0].equality.left.text, "2*T");
  EXPECT_EQ(claim.lines[1].equality.left.text, "ddt(T)");
  EXPECT_EQ(claim.lines[1].place.line, claim.lines[0].place.line + 1) << "where it stands in the lesson";
}

TEST(PrintedClaims, AChainGoesOnAndSoDoesTheNextFormula) {
  const Stage stage = stage_of(
      "```math a law\n\\vec N = \\vec N = \\frac{d\\vec L}{dt}\n```\n```math b law\n= "
      "\\vec\\omega\\times\\vec L + \\frac{d^*\\vec L}{dt}\n```\n");
  const auto& chain = std::get<Claim>(stage.steps[0].blocks.at(1));
  ASSERT_THAT(chain.lines, SizeIs(2));
  EXPECT_FALSE(chain.lines[0].goes_on);
  EXPECT_TRUE(chain.lines[1].goes_on);
  const auto& next = std::get<Claim>(stage.steps[0].blocks.at(3));
  ASSERT_THAT(next.lines, SizeIs(1));
  EXPECT_EQ(next.lines[0].equality.left.text, "ddt(L)");
}

TEST(PrintedClaims, OfAPartAreWhatIsMarked) {
  const Stage stage = stage_of(
      "```math a identity\n\\proved{2T = \\vec\\omega\\cdot\\vec L}\\,,\\quad \\zeta > 0\\,,\\quad "
      "\\proved{T = T}\n```\n");
  const auto& claim = std::get<Claim>(stage.steps[0].blocks.at(1));
  EXPECT_EQ(claim.origin, Claim::Origin::part);
  ASSERT_THAT(claim.lines, SizeIs(2));
  EXPECT_EQ(claim.lines[0].equality.left.text, "2*T");
  EXPECT_FALSE(claim.lines[1].goes_on);
}

TEST(PrintedClaims, WhatCannotBeReadIsAnErrorAtItsPlace) {
  EXPECT_THAT(testing::complaints(lesson_with("```math a law\nT = \\zeta\n```\n")),
              ElementsAre(HasSubstr("this formula cannot be proved as printed")));
  EXPECT_THAT(testing::complaints(lesson_with("```math a lawful\nT = T\n```\n")),
              ElementsAre(HasSubstr("unknown kind of claim \"lawful\"")));
  EXPECT_THAT(testing::complaints(lesson_with("```math a law well\nT = T\n```\n")),
              ElementsAre(HasSubstr("this fence opens with ```math ID, or ```math ID KIND")));
  EXPECT_THAT(testing::complaints(lesson_with("```math a\nT\n```\n```claim a law well\nT = T\n```\n")),
              ElementsAre(HasSubstr("in-other-words")));
}

TEST(Claims, MayComeBeforeTheirEquation) { stage_of("```claim a law\nL = L\n```\n```math a\nx\n```\n"); }

TEST(Claims, NameEquationsOfTheirStageOnly) {
  EXPECT_THAT(
      testing::complaints(lesson_with("```math a\nx\n```\n# Next {next}\n```claim a law\nL = L\n```\n")),
      ElementsAre("13:10: error: no equation \"a\" in this stage (the stage has no ```math fence)"));
}

TEST(Ids, AreFreeAgainInTheNextStage) {
  EXPECT_THAT(testing::complaints(lesson_with("```math a\nx\n```\n# Next {next}\n```math a\ny\n```\n")),
              IsEmpty());
}

TEST(Tags, AreWarnedOfIfTwoEquationsOfTheLessonHaveOne) {
  EXPECT_THAT(testing::complaints(
                  lesson_with("```math a\nx \\tag{1}\n```\n# Next {next}\n```math a\ny \\tag{1}\n```\n")),
              ElementsAre("14:8: warning: another equation has tag (1), on line 10"));
}

TEST(Tags, StayWithAnEquationThatIsPrintedOnceMore) {
  EXPECT_THAT(testing::complaints(
                  lesson_with("```math a\nx \\tag{1}\n```\n# Next {next}\n```math b\nx \\tag{1}\n```\n")),
              IsEmpty());
}

TEST(Tags, OfOneEquationAreKeptTogether) {
  const Stage stage = stage_of("```math a\nx \\tag{7} \\\\\ny \\tag{8}\n```\n");
  EXPECT_EQ(std::get<Equation>(stage.steps[0].blocks[0]).tag, "7, 8");
}

TEST(Fences, MayBeMadeOfTildes) {
  EXPECT_EQ(std::get<Equation>(stage_of("~~~ math a\nx\n~~~\n").steps[0].blocks[0]).tex, "x");
}

TEST(Scenes, WarnOfWhatShowsNothing) {
  EXPECT_THAT(
      testing::complaints(lesson_with("Text.\n\n```scene\ntorque = \"damping:0.1\"\nshow = [\"omega\", "
                                      "\"polhode\"]\n```\n")),
      ElementsAre("13:18: warning: in the scene of line 11 \"polhode\" shows nothing: it belongs to motion "
                  "without torque, and a torque acts"));
  EXPECT_THAT(
      testing::complaints(lesson_with("Text.\n\n```scene\nshow = [\"polhode\"]\n```\n---\n```scene\ntorque = "
                                      "\"damping:0.1\"\n```\n")),
      ElementsAre(HasSubstr("12:9: warning: in the scene of line 15 \"polhode\" shows nothing")));
}

}  // namespace
}  // namespace polhode
