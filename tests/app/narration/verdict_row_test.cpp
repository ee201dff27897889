// SPDX-License-Identifier: MIT
#include "app/narration/verdict_row.h"

#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/claim_lines.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

Claim claim_of(const std::string& text, ClaimKind kind) {
  const SourceText source(text);
  Report report(source, "text");
  Claim claim;
  claim.kind = kind;
  claim.lines = read_claim_lines(source, 1, source.line_count(), kind, report);
  EXPECT_FALSE(report.has_errors()) << text;
  for (ClaimLine& line : claim.lines) {
    line.judgement = judge(line, kind, Prover());
    line.tex = tex_of(line, kind);
  }
  return claim;
}

VerdictRow row_of(const std::string& text, ClaimKind kind, const SceneModel* model = nullptr) {
  return verdict_row(claim_of(text, kind), model ? &model->scene : nullptr, model, Language::en);
}

std::vector<std::string> rows_of(const Claim& claim, const Scene& scene, double t_s) {
  const SceneModel model = make_model(scene);
  return live_rows(claim, *live_state(model, t_s), scene.views.front(), Language::en);
}
std::vector<std::string> rows_of(const std::string& text, ClaimKind kind, const Scene& scene, double t_s) {
  return rows_of(claim_of(text, kind), scene, t_s);
}

Scene spinning() {
  Scene scene;
  scene.w0_B = Vec3(0.5, 0.25, 2.0);
  return scene;
}

TEST(VerdictRow, SaysTheKindInAWordAndWhatIsKnown) {
  const VerdictRow motion = row_of("ddt(L) = N", ClaimKind::motion);
  EXPECT_EQ(motion.word, "true in every motion");
  EXPECT_EQ(motion.note, "");
  EXPECT_EQ(motion.certainty, Certainty::proved);
  EXPECT_EQ(row_of("ddt(L) = N", ClaimKind::law).certainty, Certainty::stated) << "nature decides";
  const VerdictRow wrong = row_of("star(L) = 0", ClaimKind::is_false);
  EXPECT_EQ(wrong.word, "false");
  EXPECT_EQ(wrong.example,
            "for example at $(I_1, I_2, I_3) = (2, 3, 4)$, $\\vec\\omega = (1, 1, 0)$, $\\vec N = 0$: "
            "$(0, 0, -1) \\ne 0$");
  EXPECT_EQ(wrong.certainty, Certainty::refuted);
  EXPECT_THAT(row_of("ddt(T) = 0 => N = 0", ClaimKind::non_sequitur).example,
              HasSubstr("the premise holds, and "));
}

std::string text_of(const char* path) {
  std::ostringstream text;
  text << std::ifstream(test::source_dir() / path).rdbuf();
  return text.str();
}

/// The verdict of a claim of this kind that holds.
VerdictRow row_of(ClaimKind kind, Claim::Origin origin) {
  Claim claim;
  claim.kind = kind;
  claim.origin = origin;
  const Scene scene = spinning();
  return verdict_row(claim, &scene, nullptr, Language::en);
}

TEST(VerdictRow, HasTheWordsThatTheTableOfTheFormatHas) {
  const std::string format = text_of("lessons/FORMAT.md");
  const std::size_t begin = format.find("| kind | holds | pages say |");
  ASSERT_NE(begin, format.npos);
  for (const std::string& name : claim_kind_names()) {
    const std::size_t row = format.find("\n| `" + name + "` | ", begin);
    ASSERT_NE(row, format.npos) << name;
    const std::string line = format.substr(row + 1, format.find('\n', row + 1) - row - 1);
    const std::string said = line.substr(line.rfind('|', line.size() - 2));
    for (const Claim::Origin origin : {Claim::Origin::beside, Claim::Origin::formula}) {
      const VerdictRow verdict = row_of(*claim_kind_from(name), origin);
      EXPECT_THAT(said, HasSubstr(verdict.word));
      EXPECT_EQ(said.find("✓ " + verdict.word) != said.npos, verdict.certainty == Certainty::proved) << said;
      EXPECT_EQ(said.find("✗ " + verdict.word) != said.npos, verdict.certainty == Certainty::refuted) << said;
    }
  }
}

// The lecture tells a student what each word means.
TEST(VerdictRow, HasTheWordsThatTheLectureExplains) {
  const std::string lecture = text_of("lessons/euler-equations.md");
  const std::size_t begin = lecture.find("## Most formulas say why they hold");
  ASSERT_NE(begin, lecture.npos);
  const std::string list = lecture.substr(begin, lecture.find("\n```", begin) - begin);
  std::set<std::string> explained, said;
  static const std::regex kBold(R"re(\*\*([^*]+)\*\*)re");
  for (std::sregex_iterator at(list.begin(), list.end(), kBold), end; at != end; ++at)
    explained.insert((*at)[1].str());
  for (const std::string& name : claim_kind_names()) {
    const ClaimKind kind = *claim_kind_from(name);
    if (kind != ClaimKind::non_sequitur) said.insert(row_of(kind, Claim::Origin::beside).word);
  }
  EXPECT_EQ(explained, said) << "non-sequiturs say of themselves that something does not follow";
}

TEST(VerdictRow, WhatIsNotProvedIsNotCalledSo) {
  const VerdictRow row = row_of("ddt(L) = N\nddt(L) = -N", ClaimKind::motion);
  EXPECT_EQ(row.certainty, Certainty::refuted);
  EXPECT_EQ(row.word, "does not hold");
  EXPECT_THAT(row.note, HasSubstr("at I = (2, 3, 4)"));
}

TEST(VerdictRow, NamesTheMethodOfAMeasurement) {
  Scene scene = spinning();
  const SceneModel exact = make_model(scene);
  EXPECT_EQ(row_of("ddt(T) = 0", ClaimKind::measured, &exact).note, "in closed form");
  scene.motion.method = Method::rk4;
  scene.motion.step_s = 0.02;
  const SceneModel computed = make_model(scene);
  EXPECT_EQ(row_of("ddt(T) = 0", ClaimKind::measured, &computed).note, "with rk4, $h$ = 0.02 s");
  EXPECT_EQ(row_of("ddt(T) = 0", ClaimKind::measured, &computed).word, "checked on this motion");
}

TEST(VerdictRow, MeasuresNothingWithoutAMotion) {
  Claim claim = claim_of("T = T", ClaimKind::measured);
  claim.lines[0].judgement.emplace().verdict = Verdict::holds;
  const VerdictRow row = verdict_row(claim, nullptr, nullptr, Language::en);
  EXPECT_EQ(row.word, "not confirmed");
  EXPECT_EQ(row.certainty, Certainty::open);
}

TEST(VerdictRow, ShowsWhatIsClaimedWhereTheFormulaIsNotThat) {
  Claim claim = claim_of("2*T = dot(omega, L)\nN = 0 * L", ClaimKind::law);
  EXPECT_THAT(verdict_row(claim, nullptr, nullptr, Language::en).claimed,
              ElementsAre(R"(2\,T = \vec\omega\cdot \vec L)", R"(\vec N = 0\,\vec L)"));
  claim.origin = Claim::Origin::formula;
  EXPECT_THAT(verdict_row(claim, nullptr, nullptr, Language::en).claimed, IsEmpty());
}

TEST(VerdictRow, WhatCancelsTooFarIsNotCalledMeasured) {
  Scene scene = spinning();
  scene.w0_B = Vec3(0.01, 0, 3000);
  scene.torque = {SpaceTorque{Vec3(0, 0, 1e-3)}};
  const SceneModel model = make_model(scene);
  const VerdictRow row = row_of("ddt(T) = 0", ClaimKind::measured, &model);
  EXPECT_EQ(row.certainty, Certainty::open);
  EXPECT_EQ(row.word, "not confirmed");
  EXPECT_EQ(row.note, "the terms cancel too far to tell");
}

TEST(LiveRows, ShowBothSides) {
  EXPECT_THAT(rows_of("T = dot(omega, L)/2", ClaimKind::law, spinning(), 0.0), ElementsAre("5.18 = 5.18"));
}

TEST(LiveRows, VectorsNameTheirFrame) {
  Scene scene = spinning();
  scene.views = {View::body};
  EXPECT_THAT(rows_of("omega = omega", ClaimKind::law, scene, 0.0),
              ElementsAre("in $S^*$ (0.50, 0.25, 2.00) = (0.50, 0.25, 2.00)"));
  EXPECT_THAT(rows_of("omega = omega", ClaimKind::law, spinning(), 0.0).at(0), HasSubstr("in $S$ ("));
}

TEST(LiveRows, WhatDiffersIsNotCalledEqual) {
  EXPECT_THAT(rows_of("T = 2*T", ClaimKind::law, spinning(), 0.0), ElementsAre("5.2 ≠ 10.4"));
  EXPECT_THAT(rows_of("T = 0", ClaimKind::is_false, spinning(), 0.0), ElementsAre("5.18 ≠ 0"));
}

TEST(LiveRows, WhatIsSoWithinAToleranceHasItsTwoNumbers) {
  Claim claim = claim_of("T = 1.005*T", ClaimKind::measured);
  claim.lines[0].within = 0.009;
  EXPECT_THAT(rows_of(claim, spinning(), 0.0), ElementsAre("5.18 ≈ 5.21"));
  claim.lines[0].judgement.emplace().verdict = Verdict::holds;
  const Scene scene = spinning();
  EXPECT_THAT(verdict_row(claim, &scene, nullptr, Language::en).note, HasSubstr("to within 0.9 %"));
  claim.lines[0].within.reset();
  EXPECT_THAT(verdict_row(claim, &scene, nullptr, Language::en).note, Not(HasSubstr("within")));
}

// 2026-11-24: "4.85 = 4.85" stood where the sides were 4.848 and 4.861, as nothing could be told apart there.
TEST(LiveRows, WhatTheMotionCannotTellApartHasItsTwoNumbers) {
  Scene scene = spinning();
  scene.w0_B = Vec3(0.5, 2.0, 4.0);
  scene.motion = {.method = Method::dormand_prince_8, .tolerance = 7e-6};
  EXPECT_THAT(rows_of("I1*dw1 = 1.005*(I2 - I3)*w2*w3", ClaimKind::measured, scene, 0.0),
              ElementsAre("−6.00 ≈ −6.03"));
  EXPECT_THAT(rows_of("I1*dw1 = 1.001*(I2 - I3)*w2*w3", ClaimKind::measured, scene, 0.0),
              ElementsAre("−6.00 = −6.00"));
}

TEST(LiveRows, SetAFactorOfTenApart) {
  Scene scene = spinning();
  scene.w0_B *= 1e3;
  EXPECT_THAT(rows_of("T = T", ClaimKind::law, scene, 0.0),
              ElementsAre("5.18${\\cdot}10^{6}$ = 5.18${\\cdot}10^{6}$"));
}

// 0 = 0 tells nothing, and is there at all times.
TEST(LiveRows, WhatIsSaidToBeZeroHasNone) {
  EXPECT_THAT(rows_of("ddt(L) = 0", ClaimKind::free, spinning(), 0.0), IsEmpty());
  EXPECT_THAT(widest_live_rows(claim_of("ddt(L) = 0", ClaimKind::free), Language::en), IsEmpty());
}

TEST(LiveRows, WhatComesToZeroOnTheMotionShowsNothing) {
  EXPECT_THAT(rows_of("ddt(L) = N", ClaimKind::law, spinning(), 0.0), ElementsAre(""));
  EXPECT_THAT(rows_of("N1 = N1\nw1 = w1\nN2 = N2", ClaimKind::law, spinning(), 0.0),
              ElementsAre("0 = 0", "0.50 = 0.50", "0 = 0"))
      << "else a row might be taken for another equation's";
}

TEST(LiveRows, EachEquationHasOneAndAChainIsOne) {
  EXPECT_THAT(rows_of("T = dot(omega, L)/2\nw1 = 0.5\nw3 = 2", ClaimKind::law, spinning(), 0.0),
              ElementsAre("5.18 = 5.18", "0.50 = 0.50", "2.00 = 2.00"));
  Claim chain = claim_of("T = dot(omega, L)/2\ndot(omega, L)/2 = dot(L, omega)/2", ClaimKind::law);
  chain.lines[1].goes_on = true;
  EXPECT_THAT(rows_of(chain, spinning(), 0.0), ElementsAre("5.18 = 5.18 = 5.18"));
  EXPECT_THAT(widest_live_rows(chain, Language::en), SizeIs(1));
  chain.lines[1].is_side_by_side = false;
  EXPECT_THAT(rows_of(chain, spinning(), 0.0), ElementsAre("5.18 = 5.18"));
}

TEST(LiveRows, OfManyEquationsThereAreNone) {
  EXPECT_THAT(rows_of("w1 = w1\nw2 = w2\nw3 = w3\nT = T", ClaimKind::law, spinning(), 0.0), IsEmpty());
}

TEST(LiveRows, AreAsManyAsThereIsRoomFor) {
  for (const char* text : {"T = T", "w1 = w1\nomega = omega", "ddt(L) = 0", "w1 = w1\nw1 = 0"}) {
    const Claim claim = claim_of(text, ClaimKind::free);
    EXPECT_EQ(rows_of(claim, spinning(), 0.3).size(), widest_live_rows(claim, Language::en).size()) << text;
  }
}

// Two vectors that differ, under what is proved, would seem to refute it.
TEST(LiveRows, ShowNoNumbersOfAStepThatDecidesNothing) {
  Scene scene = spinning();
  scene.motion.method = Method::splitting;
  scene.motion.step_s = 0.4;
  EXPECT_THAT(rows_of("star(L) = cross(L, omega)", ClaimKind::free, scene, 1.0),
              ElementsAre("the step is too long to tell"));
  EXPECT_THAT(rows_of("star(L) = 0", ClaimKind::is_false, scene, 1.0), IsEmpty())
      << "its numbers may differ by the step alone, and may agree by it";
}

/// left ≈ right near axis 2, to first order, of the kind free.
Claim near_axis_two(const std::string& text, ClaimKind kind = ClaimKind::free) {
  const SourceText source(text);
  Report report(source, "text");
  Claim claim;
  claim.kind = kind;
  claim.given.small = {{Quantity::w1, Quantity::w3}, 1};
  claim.lines = read_claim_lines(source, 1, source.line_count(), kind, report);
  EXPECT_FALSE(report.has_errors()) << text;
  for (ClaimLine& line : claim.lines) {
    line.judgement = judge(line, kind, Prover(), claim.given);
    line.tex = tex_of(line, kind);
  }
  return claim;
}
const char* const kLinear = "ddt(ddt(w1)) ~= (I2 - I3)*(I1 - I2)/(I1*I3)*w2^2*w1";

TEST(VerdictRow, SaysToWhichOrder) {
  const Claim claim = near_axis_two(kLinear);
  const VerdictRow row = verdict_row(claim, nullptr, nullptr, Language::en);
  EXPECT_EQ(row.word, "true when no torque acts");
  EXPECT_EQ(row.note, "to first order in $\\omega_1$, $\\omega_3$");
  EXPECT_EQ(row.certainty, Certainty::proved);
  ASSERT_THAT(row.claimed, SizeIs(1));
  EXPECT_THAT(row.claimed.front(), HasSubstr("\\approx"));
  const Claim wrong = near_axis_two("T ~= I2*w2^2");
  EXPECT_EQ(verdict_row(wrong, nullptr, nullptr, Language::en).word, "does not hold");
  const Claim called_false = near_axis_two("T ~= I2*w2^2", ClaimKind::is_false);
  const VerdictRow false_row = verdict_row(called_false, nullptr, nullptr, Language::en);
  EXPECT_EQ(false_row.note, "to first order in $\\omega_1$, $\\omega_3$");
  EXPECT_THAT(false_row.example, ::testing::StartsWith("for example at $(I_1, I_2, I_3) = "));
}

TEST(VerdictRow, TellsInequalitiesThatAreGiven) {
  Claim claim = claim_of("T >= 0", ClaimKind::identity);
  Bound bound;
  bound.tex = "I_3 > I_1";
  claim.given.bounds.push_back(bound);
  EXPECT_EQ(verdict_row(claim, nullptr, nullptr, Language::en).note, "given $I_3 > I_1$");
}

TEST(VerdictRow, NumbersOfAnApproximationAreNotMadeEqual) {
  const Claim claim = near_axis_two(kLinear);
  Scene scene;
  scene.body.moments = PrincipalMoments(1.0, 1.75, 2.5);
  scene.w0_B = Vec3(0.2, 3.0, 0.1);
  scene.views = {View::body};
  ASSERT_TRUE(can_be_shown(claim, scene));
  const auto near = rows_of(claim, scene, 0);
  ASSERT_THAT(near, SizeIs(1));
  EXPECT_THAT(near.front(), HasSubstr(" ≈ "));
  // ω̈₁ is 0.405 ω₁ … − …: to its digits it is not the linear one.
  EXPECT_NE(near.front().substr(0, near.front().find(" ≈ ")),
            near.front().substr(near.front().find(" ≈ ") + std::string(" ≈ ").size()));
  // Once ω₁ has grown nothing is said to be small, and there are no numbers.
  EXPECT_THAT(rows_of(claim, scene, 2.0), IsEmpty());
  scene.w0_B = Vec3(3.0, 0.2, 0.1);
  EXPECT_FALSE(can_be_shown(claim, scene));
}

TEST(VerdictRow, SaysWhereTheMotionBesideItIsAnother) {
  const auto note_under = [](const char* text, ClaimKind kind, Torque torque) {
    Scene scene = spinning();
    scene.torque = std::move(torque);
    return verdict_row(claim_of(text, kind), &scene, nullptr, Language::en).note;
  };
  const Torque body{BodyTorque{Vec3(0, 0, 1)}}, sink{EnergySink{0.1}};
  EXPECT_EQ(note_under("ddt(L) = 0", ClaimKind::free, {}), "");
  EXPECT_EQ(note_under("ddt(L) = 0", ClaimKind::free, body), "here one acts");
  EXPECT_EQ(note_under("ddt(L) = N", ClaimKind::motion, body), "") << "true with any torque";
  EXPECT_EQ(note_under("2*T = dot(omega, L)", ClaimKind::identity, sink), "") << "true without any law";
  EXPECT_THAT(note_under("ddt(L) = N", ClaimKind::motion, sink), HasSubstr("not of this body"));
  EXPECT_THAT(note_under("ddt(L) = 0", ClaimKind::free, sink), HasSubstr("not of this body"));
}

}  // namespace
}  // namespace polhode
