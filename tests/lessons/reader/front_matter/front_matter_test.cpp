// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/front_matter.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;

constexpr const char* kHead = "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n";

TEST(FrontMatter, ReadsEverything) {
  TextReport at(
      std::string(kHead) +
      "[body.plate]\nmoments = [1, 2, 3]\ndraw = 'box'\n[body.brick]\nshape = 'box'\nsize_m = [1, 2, 3]\n"
      "mass_kg = 12\n[symbols]\nL = { tex = '\\vec L', role = 'L', say = 'angular momentum', unit = 'x' }\n"
      "[scene]\nbody = 'plate'\nat = 3\n+++\nrest");
  const FrontMatter front = read_front_matter(at.texts);
  EXPECT_THAT(at.lines(), IsEmpty());
  EXPECT_EQ(front.id, "a");
  EXPECT_EQ(front.title, "A");
  EXPECT_EQ(at.source.line(front.next_line), "rest");
  EXPECT_EQ(front.bodies.named.at("plate").moments, PrincipalMoments(1, 2, 3));
  EXPECT_EQ(front.bodies.named.at("plate").shape->kind, ShapeKind::box);
  EXPECT_EQ(front.bodies.named.at("brick").moments, PrincipalMoments(13, 10, 5));
  EXPECT_TRUE(front.bodies.complete);
  EXPECT_EQ(front.symbols.at("L").tex, "\\vec L");
  EXPECT_EQ(front.symbols.at("L").role, "L");
  EXPECT_EQ(front.symbols.at("L").say, "angular momentum");
  EXPECT_EQ(front.symbols.at("L").unit, "x");
  EXPECT_EQ(front.scene.scene.body.name, "plate");
  EXPECT_EQ(front.scene.scene.at_s, 3);
}

TEST(FrontMatter, ABodyOfMomentsMayLookLikeAnyShape) {
  TextReport at(
      std::string(kHead) +
      "[body.ball]\nmoments = [1, 1, 0.6]\ndraw = 'ellipsoid'\nsize_m = [0.2, 0.2, 0.3]\nmass_kg = 2\n"
      "[body.bad]\nmoments = [1, 1, 3]\ndraw = 'box'\nsize_m = [1, 1, 1]\n"
      "[body.flat]\nmoments = [1, 1, 1]\ndraw = 'box'\nsize_m = [1, 0, 1]\n"
      "[body.bare]\nmoments = [1, 1, 1]\ndraw = 'cylinder'\n+++\n");
  const FrontMatter front = read_front_matter(at.texts);
  const Body& ball = front.bodies.named.at("ball");
  EXPECT_EQ(ball.moments, PrincipalMoments(1, 1, 0.6));
  EXPECT_EQ(ball.shape, (Shape{ShapeKind::ellipsoid, Vec3(0.2, 0.2, 0.3)}));
  EXPECT_EQ(ball.mass_kg, 2);
  EXPECT_THAT(
      at.lines(),
      ElementsAre("11:1: error: " + *why_impossible(1.0, 1.0, 3.0),
                  "17:1: error: sizes must be finite and > 0",
                  "20:8: error: only a box follows from the moments (write \"box\", or size_m = [x, y, z] "
                  "as well, in m)"));
}

TEST(FrontMatter, ReportsImpossibleMomentsWithTheReasonOfPhysics) {
  TextReport at(std::string(kHead) + "[body.plate]\nmoments = [1.0, 2.0, 3.5]\n+++\n");
  const FrontMatter front = read_front_matter(at.texts);
  EXPECT_FALSE(front.bodies.complete);
  EXPECT_THAT(at.lines(), ElementsAre("6:1: error: " + *why_impossible(1.0, 2.0, 3.5)));
}

TEST(FrontMatter, WhatSymbolsSayIsOnePlainLine) {  // 2026-11-22: an ESC of TOML went into transcripts
  for (const char* bad :
       {"say = \"\\u001b[31mred\"", "unit = \"a\\nb\"", "say = \"\\u202elive\"", "unit = \"\\u009bm\""}) {
    TextReport at(kHead + std::string("[symbols]\nL = { tex = '\\vec L', ") + bad + " }\n+++\n");
    const FrontMatter front = read_front_matter(at.texts);
    EXPECT_THAT(at.lines(), ElementsAre(::testing::AllOf(
                                ::testing::StartsWith("6:"),
                                ::testing::HasSubstr("is one line of text without control characters"))));
    EXPECT_TRUE(front.symbols.at("L").say.empty() && front.symbols.at("L").unit.empty());
  }
}

TEST(FrontMatter, ReadsWhatSymbolsMeanAndWhatTheAxesAre) {
  TextReport at(kHead +
                std::string("axes = \"xyz\"\n[symbols]\nE = { tex = 'E', means = \"2*T\" }\nI = { tex = "
                            "'\\mathbf J', means = \"J\" }\n+++\n"));
  const FrontMatter front = read_front_matter(at.texts);
  EXPECT_THAT(at.lines(), IsEmpty());
  EXPECT_TRUE(front.notation.xyz_are_body_axes);
  ASSERT_EQ(front.notation.symbols.size(), 2U);
  EXPECT_EQ(front.symbols.at("E").means, "2*T");
  ASSERT_NE(front.notation.vocabulary.find("E"), nullptr);
  EXPECT_EQ(front.notation.vocabulary.find("E")->means.text, "2*T");
  EXPECT_EQ(front.symbols.at("I").means, "J");
}

TEST(FrontMatter, ASymbolThatMeansSomethingMeansNothingElse) {
  const auto complaint = [](const std::string& symbols) {
    TextReport at(kHead + ("[symbols]\n" + symbols + "\n+++\n"));
    read_front_matter(at.texts);
    const auto lines = at.lines();
    return lines.empty() ? std::string() : lines.front();
  };
  for (const char* known : {"0", "2", "12", "T", "\\vec L", "T^2", "TT", "2T", "\\frac{T}{2}",
                            "\\dot{\\vec\\omega}", "\\mathbf 1", "\\mathbf I"})
    EXPECT_THAT(complaint("a = { tex = '" + std::string(known) + "', means = 'm' }"),
                ::testing::HasSubstr("is known already"))
        << known;
  for (const char* sign :
       {"i", "t", "d", "=", "\\omega_i", "Τ", "\\pi", "\\omega_{1,}", "T_{.}", "\\omega^2"})
    EXPECT_THAT(complaint("a = { tex = '" + std::string(sign) + "', means = 'm' }"),
                ::testing::HasSubstr("has a sign that formulas use otherwise"))
        << sign;
  EXPECT_THAT(complaint("a = { tex = 'Q', means = 'm' }\nb = { tex = '{Q}', means = 'T' }"),
              ::testing::HasSubstr("looks like symbol \"a\""));
  EXPECT_THAT(complaint("L = { tex = '\\vec N' }"), ::testing::HasSubstr("has the name of another quantity"));
  EXPECT_EQ(
      complaint(
          "L = { tex = '\\vec L' }\nE = { tex = 'E', means = 'T' }\nk2 = { tex = '\\kappa^2', means = 'h' }"),
      "");
}

TEST(FrontMatter, WhatASymbolMeansIsCheckedWhereItStands) {
  TextReport at(kHead +
                std::string("axes = \"abc\"\n[symbols]\nE = { tex = 'E', means = \"2*mass\" }\n+++\n"));
  const FrontMatter front = read_front_matter(at.texts);
  EXPECT_THAT(at.lines(),
              ElementsAre(::testing::AllOf(::testing::StartsWith("5:"), ::testing::HasSubstr("axes \"abc\"")),
                          ::testing::AllOf(::testing::StartsWith("7:29"), ::testing::HasSubstr("mass"))));
  EXPECT_EQ(front.symbols.at("E").means, "");
}

TEST(FrontMatter, GoesOnAfterASyntaxError) {
  TextReport at("+++\nid = \n+++\nrest");
  const FrontMatter front = read_front_matter(at.texts);
  EXPECT_EQ(at.source.line(front.next_line), "rest");
  EXPECT_FALSE(front.bodies.complete);
  EXPECT_EQ(at.lines().size(), 1U);
}

TEST(FrontMatter, MayEndWithTheText) {
  TextReport at(std::string(kHead) + "+++");
  EXPECT_EQ(read_front_matter(at.texts).next_line, at.source.line_count() + 1);
  EXPECT_THAT(at.lines(), IsEmpty());
}

TEST(FrontMatter, MacrosServeSymbolsAboveThem) {
  TextReport at(std::string(kHead) +
                "symbols.w = { tex = '\\w' }\n[macros]\nw = '\\vec\\omega'\nddt = { arguments = 1, tex = "
                "'\\frac{d#1}{dt}' }\n+++\n");
  const FrontMatter front = read_front_matter(at.texts);
  EXPECT_THAT(at.lines(), IsEmpty());
  EXPECT_EQ(at.texts.macros().at("ddt").arguments, 1);
  EXPECT_EQ(at.texts.macros().at("ddt").body, "\\frac{d#1}{dt}");
  EXPECT_NE(front.symbols.at("w").math.root, nullptr);
}

class FrontMatterRefuses : public ::testing::TestWithParam<const char*> {};
TEST_P(FrontMatterRefuses, Lines) {
  TextReport at(std::string(kHead) + GetParam() + "\n+++\n");
  read_front_matter(at.texts);
  EXPECT_TRUE(at.report.has_errors()) << GetParam();
}
INSTANTIATE_TEST_SUITE_P(
    All, FrontMatterRefuses,
    ::testing::Values(
        "body = 'book'", "scene = 1", "symbols = 'L'", "symbols.L = 'L'", "body.plate = 1", "body.plate = {}",
        "body.plate = { shape = 'box' }", "body.p_q = { moments = [1, 1, 1] }", "include = 'other.md'",
        "macros = 1", "macros.w2 = 'x'", "macros.w = 1", "macros.w = { arguments = 1 }",
        "macros.w = { tex = 'x', arguments = 10 }", "macros.w = { tex = 'x', arguments = 'one' }",
        "symbols.L = { tex = '\\vecc' }", "symbols.L = { tex = '{' }", "symbols.L = {}",
        "body.p = { moments = [1, 1, 1], mass_kg = 0 }", "body.p = { moments = [1, 1, 1], draw = 'ball' }",
        "body.p = { shape = 'box', size_m = [1, 1, 1], mass_kg = 1, draw = 'box' }",
        "body.p = { shape = 'box', size_m = [1, -1, 1], mass_kg = 1 }",
        "body.p = { shape = 'ring', size_m = [1, 1, 1], mass_kg = 1 }"));

}  // namespace
}  // namespace polhode
