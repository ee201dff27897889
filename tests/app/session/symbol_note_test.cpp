// SPDX-License-Identifier: MIT
#include "app/session/symbol_note.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "lessons/reader/reader.h"
#include "tests/app/session/example_lesson.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

Lesson lesson_named(const std::string& id) {
  return or_fail(load_lesson((test::source_dir() / "lessons" / (id + ".md")).string())).lesson;
}

const Lesson& lecture() {
  static const Lesson kLesson = lesson_named("euler-equations");
  return kLesson;
}

Scene steady() {  // about axis 3, L up: ω and L stand still in space and body
  Scene scene;
  scene.body.moments = PrincipalMoments(1.0, 1.75, 2.5);
  scene.w0_B = Vec3(0, 0, 1.2);
  scene.show = {Overlay::omega};
  return scene;
}

// 2026-11-26: panels wrote 1.0336e+38 J, 2e-18.
TEST(Readable, IsANumberForPeople) {
  EXPECT_EQ(readable(1.0336e38, 4), "1.034·10³⁸");
  EXPECT_EQ(readable(2e-18, 1), "2·10⁻¹⁸");
  EXPECT_EQ(readable(-12), "−12.0");
  EXPECT_EQ(readable(9996), "1.00·10⁴");
  EXPECT_EQ(readable(0), "0");
  EXPECT_EQ(readable(std::nan("")), "");
  EXPECT_EQ(readable(Vec3(0.9, -0.305, 0)), "(0.900, −0.305, 0)");
  EXPECT_EQ(with_minus("-0.5"), "−0.5");
}

TEST(SymbolNote, SaysWhatASymbolIsAndWhatItIsNow) {
  const SceneModel model = make_model(steady());
  const SymbolNote omega = note_of(lecture(), "omega", &model, 0.5);
  EXPECT_EQ(omega.meaning, "angular velocity");
  EXPECT_EQ(omega.unit, "rad/s");
  EXPECT_EQ(omega.value, "(0, 0, 1.20)");
  EXPECT_EQ(omega.frame, "space");
  EXPECT_EQ(note_of(lecture(), "L", &model, 0.5).value, "(0, 0, 3.00)");
  EXPECT_EQ(note_of(lecture(), "N", &model, 0.5).value, "(0, 0, 0)");
  const SymbolNote T = note_of(lecture(), "T", &model, 0.5);
  EXPECT_EQ(T.value, "1.80");
  EXPECT_EQ(T.unit, "J");
  EXPECT_EQ(T.frame, "");
  const SymbolNote I = note_of(lecture(), "I", &model, 0.5);
  EXPECT_EQ(I.value, "(1.00, 1.75, 2.50)");
  EXPECT_EQ(I.frame, "body");
}

TEST(SymbolNote, OfWhatALessonDefinesHasItsValue) {
  const LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[constants]\nc = { value = 2.5, tex = 'c', unit = \"N m\" "
      "}\n"
      "[define]\nE = { means = \"T + c\", tex = 'E', say = \"energy\", unit = \"J\" }\n+++\n# A {a}\nText.\n",
      "a.md");
  ASSERT_TRUE(reading.lesson);
  const SceneModel model = make_model(steady());
  EXPECT_EQ(note_of(*reading.lesson, "c", &model, 0.5).value, "2.50");
  const SymbolNote energy = note_of(*reading.lesson, "E", &model, 0.5);
  EXPECT_EQ(energy.value, "4.30") << "1.80 J and 2.5 J";
  EXPECT_EQ(energy.meaning, "energy");
}

TEST(SymbolNote, HasTheValueInTheFrameOfTheFirstView) {
  Scene scene = steady();
  scene.w0_B = Vec3(0.31, -0.2, 1.13);
  scene.views = {View::body, View::space};
  const SceneModel body = make_model(scene);
  EXPECT_EQ(note_of(lecture(), "omega", &body, 0).value, "(0.31, −0.20, 1.13)");
  EXPECT_EQ(note_of(lecture(), "omega", &body, 0).frame, "body");
  scene.views = {View::space};
  const SceneModel space = make_model(scene);
  EXPECT_NE(note_of(lecture(), "omega", &space, 0).value, "(0.31, −0.20, 1.13)");
}

TEST(SymbolNote, SetsAPowerOfTenApart) {
  Scene scene = steady();
  const auto L_at = [&](double speed) {
    scene.w0_B = Vec3(0, 0, speed);
    const SceneModel model = make_model(scene);
    return note_of(lecture(), "L", &model, 0).value;
  };
  EXPECT_EQ(L_at(1.24e-6), "(0, 0, 3.10)·10⁻⁶");
  EXPECT_EQ(L_at(4e4), "(0, 0, 1.00)·10⁵");
  EXPECT_EQ(L_at(40), "(0, 0, 100)");
  EXPECT_EQ(L_at(0.01), "(0, 0, 0.0250)");
  EXPECT_EQ(L_at(3.9984), "(0, 0, 10.0)") << "9.996";
}

TEST(SymbolNote, HasNoValueOfWhatTheSceneHasNot) {
  const SceneModel model = make_model(steady());
  for (const char* name : {"p", "v", "F", "m", "A", "R"}) {
    const SymbolNote note = note_of(lecture(), name, &model, 0);
    EXPECT_EQ(note.value, "") << name;
    EXPECT_NE(note.meaning, "") << name;
  }
  Scene drifting = steady();
  drifting.v0_S = Vec3(0.5, 0, 0);
  const SceneModel moved = make_model(drifting);
  EXPECT_EQ(note_of(lecture(), "v", &moved, 0).value, "(0.500, 0, 0)");
  EXPECT_NE(note_of(lecture(), "p", &moved, 0).value, "");
  EXPECT_EQ(note_of(lecture(), "omega", nullptr, 0).value, "");
  EXPECT_EQ(note_of(lecture(), "omega", nullptr, 0).meaning, "angular velocity");
}

TEST(SymbolNote, OfATermIsItsFormulaInWords) {
  LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"page\"\ntitle = \"Terms\"\n[symbols]\nL = { tex = '\\vec L', role = \"L\", "
      "say = \"angular momentum\" }\n+++\n# One {one}\n```math a\n\\term{left}{a + b} = \\term{right}{\\vec "
      "L}\n```\n\n---\n"
      "```math b\n\\term{left}{c} = d\n```\n\n# Two {two}\n```math c\n\\frac{\\term{left}{x}}{y} = 1\n```\n",
      "terms.md");
  ASSERT_TRUE(reading.lesson);
  const Lesson& lesson = *reading.lesson;
  EXPECT_EQ(note_of(lesson, "left", nullptr, 0, "one", 0).meaning, "a plus b");
  EXPECT_EQ(note_of(lesson, "left", nullptr, 0, "one", 1).meaning, "c") << "seen last";
  EXPECT_EQ(note_of(lesson, "left", nullptr, 0, "two", 0).meaning, "x");
  EXPECT_EQ(note_of(lesson, "left", nullptr, 0).meaning, "a plus b");
  EXPECT_EQ(note_of(lesson, "right", nullptr, 0, "one", 1).meaning, "angular momentum");
  EXPECT_EQ(note_of(lesson, "right", nullptr, 0, "two", 0).meaning, "angular momentum") << "from elsewhere";
  const SymbolNote none = note_of(lesson, "nothing", nullptr, 0, "one", 0);
  EXPECT_EQ(none.meaning + none.unit + none.value + none.frame, "");
}

std::vector<std::string> terms_on(const Step& step) {
  std::vector<std::string> terms;
  for (const Block& block : step.blocks)
    if (const auto* equation = std::get_if<Equation>(&block))
      terms.insert(terms.end(), equation->math.terms.begin(), equation->math.terms.end());
  return terms;
}

TEST(SymbolNote, OfEverySymbolOfTheLessonsSaysSomething) {
  const SceneModel model = make_model(steady());
  for (const char* id : test::kLessons) {
    const Lesson lesson = lesson_named(id);
    for (const auto& [name, symbol] : lesson.symbols) {
      const SymbolNote note = note_of(lesson, name, &model, 0.3);
      EXPECT_NE(note.meaning, "") << id << ' ' << name;
      EXPECT_NE(note.unit, "") << id << ' ' << name;
    }
    for (const Stage& stage : lesson.stages)
      for (std::size_t step = 0; step < stage.steps.size(); ++step)
        for (const std::string& term : terms_on(stage.steps[step]))
          EXPECT_NE(note_of(lesson, term, nullptr, 0, stage.id, step).meaning, "") << id << ' ' << term;
  }
}

TEST(SymbolNote, OfALinkSaysWhereItLeads) {
  LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[symbols]\nL = { tex = '\\vec L', say = \"L\", note = "
      "\"the angular momentum\" }\n[references]\nLL = \"Landau\"\n+++\n# How $\\vec L$ turns {one}\n[cite: "
      "LL]\n",
      "a.md");
  ASSERT_TRUE(reading.lesson);
  const auto meaning = [&](const std::string& name) {
    return note_of(*reading.lesson, name, nullptr, 0).meaning;
  };
  EXPECT_EQ(meaning("#one"), "Go to: How vector L turns");
  EXPECT_EQ(meaning("cite:LL"), "Landau");
  EXPECT_EQ(meaning("https://a.b"), "Click to copy: https://a.b");
  EXPECT_EQ(meaning("other#one"), "In another lesson: other#one");
  EXPECT_EQ(meaning("L"), "the angular momentum") << "not what is spoken";
}

// 2026-11-28: in a German lesson notes had decimal points, and said where links lead in English.
TEST(SymbolNote, IsInTheLessonsLanguage) {
  const Lesson lesson = lesson_named("intermediate-axis.de");
  const SceneModel model = make_model(steady());
  EXPECT_EQ(note_of(lesson, "L", &model, 0.5).value, "(0; 0; 3,00)");
  EXPECT_EQ(note_of(lesson, "https://example.org", nullptr, 0).meaning,
            "Ein Klick kopiert: https://example.org");
}

}  // namespace
}  // namespace polhode
