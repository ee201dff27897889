// SPDX-License-Identifier: MIT
#include "app/narration/verdict_row.h"

#include "lessons/claims/proof.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/claim_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Claim claim_of(const std::string& text, ClaimKind kind) {
  const SourceText source(text);
  Report report(source, "text");
  Claim claim;
  claim.kind = kind;
  claim.lines = read_claim_lines(source, 1, source.line_count(), kind, report);
  EXPECT_FALSE(report.has_errors()) << text;
  for (ClaimLine& line : claim.lines) line.judgement = judge(line, kind, Prover());
  return claim;
}

VerdictRow row_of(const std::string& text, ClaimKind kind, const SceneModel* model = nullptr) {
  return verdict_row(claim_of(text, kind), model ? &model->scene : nullptr, model);
}

std::string live_text_of(const std::string& text, ClaimKind kind, const Scene& scene, double t_s) {
  const SceneModel model = make_model(scene);
  return live_text(claim_of(text, kind), *live_state(model, t_s), scene.views.front());
}

Scene spinning() {
  Scene scene;
  scene.w0_B = Vec3(0.5, 0.25, 2.0);
  return scene;
}

TEST(VerdictRow, SaysTheKindInAWordAndWhatIsKnown) {
  EXPECT_EQ(row_of("ddt(L) = N", ClaimKind::motion).word, "MOTION");
  EXPECT_THAT(row_of("ddt(L) = N", ClaimKind::motion).note, HasSubstr("proved"));
  EXPECT_THAT(row_of("ddt(L) = N", ClaimKind::law).note, Not(HasSubstr("proved"))) << "nature decides";
  EXPECT_EQ(row_of("star(L) = 0", ClaimKind::is_false).note,
            "at I = (2, 3, 4), ω = (1, 1, 0), N = 0: (0, 0, −1) ≠ 0");
  EXPECT_TRUE(row_of("star(L) = 0", ClaimKind::is_false).refutes);
  EXPECT_THAT(row_of("ddt(T) = 0 => N = 0", ClaimKind::non_sequitur).note,
              HasSubstr("the premise holds, yet"));
}

TEST(VerdictRow, WhatIsNotProvedIsNotCalledSo) {
  const VerdictRow row = row_of("ddt(L) = N\nddt(L) = -N", ClaimKind::motion);
  EXPECT_FALSE(row.proved);
  EXPECT_THAT(row.note, HasSubstr("does not hold: at I = (2, 3, 4)"));
}

TEST(VerdictRow, NamesTheMethodOfAMeasurement) {
  Scene scene = spinning();
  const SceneModel exact = make_model(scene);
  EXPECT_EQ(row_of("ddt(T) = 0", ClaimKind::measured, &exact).note, "on the exact motion");
  scene.motion.method = Method::rk4;
  scene.motion.step_s = 0.02;
  const SceneModel computed = make_model(scene);
  EXPECT_EQ(row_of("ddt(T) = 0", ClaimKind::measured, &computed).note, "with rk4, $h$ = 0.02 s");
}

TEST(LiveText, ShowsBothSidesTheResidualAndWhatIsAllowed) {
  EXPECT_THAT(live_text_of("T = dot(omega, L)/2", ClaimKind::law, spinning(), 0.0),
              ::testing::StartsWith("5.18 = 5.18,  apart "));
  EXPECT_THAT(live_text_of("T = dot(omega, L)/2", ClaimKind::identity, spinning(), 0.0),
              HasSubstr("rounding"))
      << "an identity is no evidence";
}

TEST(LiveText, VectorsNameTheirFrame) {
  Scene scene = spinning();
  scene.views = {View::body};
  EXPECT_THAT(live_text_of("omega = omega", ClaimKind::law, scene, 0.0),
              HasSubstr("in $S^*$ (0.50, 0.25, 2.00) = (0.50, 0.25, 2.00)"));
  EXPECT_THAT(live_text_of("ddt(L) = 0", ClaimKind::free, spinning(), 0.0), HasSubstr("in $S$ 0 = 0"));
}

TEST(LiveText, WhatDiffersIsNotCalledEqual) {
  EXPECT_THAT(live_text_of("T = 0", ClaimKind::law, spinning(), 0.0), HasSubstr("5.18 ≠ 0,  apart 0.99 > "));
  EXPECT_EQ(live_text_of("T = 0", ClaimKind::is_false, spinning(), 0.0), "5.18 ≠ 0");
}

TEST(LiveText, SetsAFactorOfTenApart) {
  Scene scene = spinning();
  scene.w0_B *= 1e3;
  EXPECT_THAT(live_text_of("T = T", ClaimKind::law, scene, 0.0), HasSubstr("5.18${\\cdot}10^{6}$"));
}

// A page could not say whose sides they are.
TEST(LiveText, OfSeveralLinesSaysOnlyHowFarTheWorstIsOff) {
  const std::string text = live_text_of("T = dot(omega, L)/2\nddt(L) = N", ClaimKind::law, spinning(), 0.0);
  EXPECT_THAT(text, ::testing::StartsWith("apart "));
  EXPECT_THAT(text, Not(HasSubstr("=")));
  EXPECT_EQ(live_text_of("T = 0\nw1 = 0", ClaimKind::is_false, spinning(), 0.0), "");
}

// Two vectors that differ, under what is proved, would seem to refute it.
TEST(LiveText, ShowsNoNumbersOfAStepThatDecidesNothing) {
  Scene scene = spinning();
  scene.motion.method = Method::splitting;
  scene.motion.step_s = 0.4;
  EXPECT_EQ(live_text_of("star(L) = cross(L, omega)", ClaimKind::free, scene, 1.0),
            "the step is too long to tell");
  EXPECT_EQ(live_text_of("star(L) = 0", ClaimKind::is_false, scene, 1.0), "")
      << "its numbers may differ by the step alone, and may agree by it";
}

}  // namespace
}  // namespace polhode
