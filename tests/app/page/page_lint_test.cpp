// SPDX-License-Identifier: MIT
#include "app/page/page_lint.h"

#include "lessons/reader/reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace polhode {
namespace {

using testing::HasSubstr;

/// The first step has a line, the second as many paragraphs as are asked for, from line 9 on.
std::vector<Diagnostic> found_with(int paragraphs) {
  std::string text =
      "+++\nformat = 1\nid = \"long\"\ntitle = \"Long\"\n+++\n# A stage {one}\nShort.\n\n---\n\n";
  for (int i = 0; i < paragraphs; ++i)
    text +=
        "Some words that fill a line of the column and then some more of the line below it, all in all "
        "two.\n\n";
  const LessonReading reading = read_lesson(text, "long.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  static const Fonts kFonts = Fonts::open().value();
  return page_diagnostics(*reading.lesson, kFonts, "long.md");
}

TEST(PageLint, AStepThatFitsIsFine) { EXPECT_TRUE(found_with(2).empty()); }

TEST(PageLint, MoreWordsThanOneReadsWhileSomebodySpeaksAreWarnedOf) {
  const auto found = found_with(3);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].place.line, 11);
  EXPECT_THAT(found[0].message, HasSubstr("step 2 of stage \"one\" has 66 words"));
}

std::vector<Diagnostic> found_in(const std::string& stages) {
  const LessonReading reading =
      read_lesson("+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# A stage {one}\n" + stages, "x.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  static const Fonts kFonts = Fonts::open().value();
  return page_diagnostics(*reading.lesson, kFonts, "x.md");
}

TEST(PageLint, FormulasCountAsWordsAndThreeDisplaysAreTooMany) {
  std::string sums = "Now";
  for (int i = 0; i < 44; ++i) sums += " $a+b$";
  EXPECT_TRUE(found_in(sums + "\n").empty());
  EXPECT_THAT(found_in(sums + " more\n").at(0).message, HasSubstr("has 46 words"));
  const auto math = [](const std::string& id) { return "```math " + id + "\nx\n```\n"; };
  EXPECT_TRUE(found_in(math("a") + math("b")).empty());
  EXPECT_THAT(found_in(math("a") + math("b") + math("c")).at(0).message, HasSubstr("3 displayed formulas"));
}

TEST(PageLint, AStepThatMakesTheTypeOfItsStageSmallerIsNamed) {
  const auto math = [](const std::string& id, int rows) {
    std::string lines;
    for (int i = 1; i < rows; ++i) lines += "a &= b \\\\\n";
    return "```math " + id + "\n\\begin{aligned}\n" + lines + "a &= b\n\\end{aligned}\n```\n";
  };
  const auto found =
      found_in("Words.\n\n---\n\nTwo lines of words, so that there is something to be read above it.\n" +
               math("a", 4) + "and\n" + math("b", 3));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("step 2 of stage \"one\" is long for a slide: all slides"));
}

TEST(PageLint, WhatTheEdgeOfThePictureCutsIsWarnedOf) {
  const auto with = [](const std::string& show, double zoom) {
    return found_in("a\n\n```scene\nbody = \"book\"\nomega = [1, 2, 3]\nshow = [" + show +
                    "]\ncamera = { azimuth_deg = 34, elevation_deg = 20, zoom = " + std::to_string(zoom) +
                    " }\n```\n");
  };
  EXPECT_TRUE(with("\"L\", \"shape\"", 1.0).empty());
  ASSERT_EQ(with("\"L\"", 2.2).size(), 1u);
  EXPECT_THAT(with("\"L\"", 2.2)[0].message, HasSubstr("the tip of an arrow lies outside the picture"));
  ASSERT_EQ(with("\"shape\"", 3.0).size(), 1u);
  EXPECT_THAT(with("\"shape\"", 3.0)[0].message, HasSubstr("the body is cut by the edge"));
}

// A book that is pushed is in the middle of its way at the still.
TEST(PageLint, WhatAPredictionPlaysIsSeenToItsEnd) {
  const auto with = [](const std::string& to, const std::string& camera) {
    return found_in(
        "a\n\n```scene\nbody = \"book\"\nomega = [0, 0, 0]\nvelocity = [0, 3, 0]\nat = 1\nduration = 2\n"
        "show = [\"shape\"]\ncamera = { azimuth_deg = 0, elevation_deg = 60" +
        camera + " }\n```\n```ask a\ntype = \"predict\"\nprompt = \"Where?\"\nplays = [0, " + to +
        "]\n\n- [x] there\n- [ ] here\n```\n");
  };
  EXPECT_TRUE(with("2", "").empty()) << "the whole film is held";
  EXPECT_TRUE(with("1", ", zoom = 2").empty());
  const auto found = with("2", ", zoom = 2");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("when \"a\" has been played the body is cut by the edge"));
}

TEST(PageLint, APictureThatStaysNeedsItsReason) {
  const std::string scene = "a\n\n```scene\nshow = [\"omega\"]\n```\n\n---\n\nb\n";
  const auto with = [&](const std::string& keys) {
    return found_in(scene + "\n```scene\n" + keys + "\n```\n");
  };
  ASSERT_EQ(found_in(scene).size(), 1u);
  EXPECT_THAT(found_in(scene)[0].message,
              HasSubstr("step 2 of stage \"one\" has the picture of the step before"));
  EXPECT_EQ(with("caption = \"words alone\"\nduration = 3").size(), 1u);
  for (const char* change :
       {"at = 1", "show = [\"L\"]", "highlight = [\"omega\"]", "camera = { azimuth_deg = 50 }",
        "meters = [\"omega\"]", "arrows = [{ of = \"L\" }]", "same = \"a question about it\""})
    EXPECT_TRUE(with(change).empty()) << change;
  const auto both = with("at = 1\nsame = \"a question about it\"");
  ASSERT_EQ(both.size(), 1u);
  EXPECT_THAT(both[0].message, HasSubstr("says why its picture stays, and changes it"));
}

TEST(PageLint, ASlideWithoutRoomForWhatItGoesOnFromIsWarnedOf) {
  std::string wide = "a = 1";
  for (int i = 0; i < 20; ++i) wide += " + b_{00}";
  const auto warned = [&](const std::string& from) {
    const auto found =
        found_in("a\n\n```math wide\n" + wide + "\n```\n\n---\n\nb\n\n```scene\nat = 1\n" + from + "```\n");
    return std::count_if(found.begin(), found.end(), [](const Diagnostic& one) {
      return one.message.find("its slide has no room for \"one/wide\", which it goes on from") !=
             std::string::npos;
    });
  };
  EXPECT_EQ(warned("from = \"wide\"\n"), 1);
  EXPECT_EQ(warned(""), 0) << "nobody asked for it";
  EXPECT_EQ(warned("from = \"none\"\n"), 0);
}

TEST(PageLint, ALongStepIsWarnedOfWhereItBegins) {
  const auto found = found_with(17);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].file, "long.md");
  EXPECT_EQ(found[0].place.line, 11);
  EXPECT_THAT(found[0].message, HasSubstr("step 2 of stage \"one\" is long"));
  EXPECT_THAT(found[0].hint, HasSubstr("---"));
}

TEST(PageLint, AStepThatNoPageHoldsIsAnError) {
  const auto found = found_with(150);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_EQ(found[0].place.line, 11);
}

TEST(PageLint, WarnsOnceOfMarksThatShowNothing) {
  const LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"marks\"\ntitle = \"Marks\"\n+++\n# A stage {one}\nWords.\n\n```scene\n"
      "arrows = [{ of = \"N\" }, { of = \"L\" }]\nangles = [{ from = \"e3\", to = \"2*e3\" "
      "}]\n```\n\n---\n\nMore.\n",
      "marks.md");
  ASSERT_TRUE(reading.lesson);
  const auto found = page_diagnostics(*reading.lesson, Fonts::open().value(), "marks.md");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_THAT(found[2].message, HasSubstr("has the picture of the step before")) << "and of marks no more";
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].message,
            "step 1 of stage \"one\": the arrow of \"N\" shows nothing: \"N\" is 0 throughout");
  EXPECT_THAT(found[1].message, HasSubstr("they are parallel throughout"));
}

/// What checking costs of a lesson of five steps, each with a motion of its own, 2000 steps of explicit Euler
/// long, and an equation that ends in `number`.
std::int64_t evaluations_with(const std::string& number) {
  std::string text = "+++\nformat = 1\nid = \"five\"\ntitle = \"Five\"\n+++\n# A stage {one}\n";
  for (int i = 1; i <= 5; ++i) {
    const std::string n = std::to_string(i);
    text += (i > 1 ? "\n---\n\n```math e" : "\n```math e") + n + "\nT = " + number +
            "\n```\n```scene\nbody = \"book\"\nomega = [0.1, 2, 0." + n +
            "]\nmotion = { method = \"explicit-euler\", step = 0.001 }\nat = 2\nshow = [\"omega\"]\n```\n";
  }
  const LessonReading reading = read_lesson(text, "five.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  static const Fonts kFonts = Fonts::open().value();
  std::int64_t made = 0;
  EXPECT_TRUE(
      page_diagnostics(*reading.lesson, kFonts, "five.md", [&](std::int64_t n) { made += n; }).empty());
  return made;
}

TEST(PageLint, TheNumbersOfEarlierStepsCostOneMotionForEachStep) {
  const std::int64_t more = evaluations_with("\\live{T}") - evaluations_with("7.80{\\cdot}10^{-3}");
  EXPECT_GE(more, 4 * 2000) << "of four steps numbers stay; what they cost is not told";
  // Rates are taken from seven states about the still, each reached again from a checkpoint.
  EXPECT_LE(more, 4 * 3000) << "computed for each later page and each of its sizes";
}

TEST(SceneErrors, AreOfFiguresThatCannotBe) {
  LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"far\"\ntitle = \"Far\"\n+++\n# A stage {one}\nOne.\n\n```scene\n"
      "show = [\"L\"]\n```\n\n---\n\nTwo.\n\n---\n\nThree.\n\n```scene\nat = 1\n```\n",
      "far.md");
  ASSERT_TRUE(reading.lesson);
  EXPECT_TRUE(scene_errors(*reading.lesson, "far.md").empty());
  Step& last = reading.lesson->stages.front().steps.back();
  Scene endless = *last.scene;
  endless.w0_B[0] = std::numeric_limits<double>::infinity();
  last.scene = std::make_shared<const Scene>(endless);
  const auto found = scene_errors(*reading.lesson, "far.md");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_THAT(found[0].message, HasSubstr("step 3 of stage \"one\" cannot be drawn: "));
  const auto unfinished = scene_errors(*reading.lesson, "far.md", [](std::int64_t) { throw BudgetSpent(); });
  ASSERT_EQ(unfinished.size(), 1u);
  EXPECT_THAT(unfinished[0].message, HasSubstr("too long to check"));
}

}  // namespace
}  // namespace polhode
