// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/proof.h"

#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/reader/claim_lines.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TextReport;

const Prover& prover() {
  static const Prover one;
  return one;
}

ClaimLine line_of(const std::string& text, ClaimKind kind) {
  TextReport at(text);
  auto lines = read_claim_lines(at.source, 1, 1, kind, at.report);
  EXPECT_EQ(lines.size(), 1U) << text << ": " << ::testing::PrintToString(at.lines());
  return lines.empty() ? ClaimLine() : std::move(lines.front());
}

Judgement judged(const std::string& text, ClaimKind kind) {
  return judge(line_of(text, kind), kind, prover());
}

bool holds(const std::string& text, ClaimKind kind) { return judged(text, kind).verdict == Verdict::holds; }

TEST(Proof, SettlesTheLectureUnderEachAssumption) {
  using K = ClaimKind;
  EXPECT_TRUE(holds("ddt(L) = star(L) + cross(omega, L)", K::identity));
  EXPECT_TRUE(holds("inertia(star(omega)) + cross(omega, inertia(omega)) = N", K::motion));
  EXPECT_FALSE(holds("inertia(star(omega)) + cross(omega, inertia(omega)) = N", K::identity));
  EXPECT_TRUE(holds("ddt(T) = 0", K::free));
  EXPECT_FALSE(holds("ddt(T) = 0", K::motion));
  EXPECT_TRUE(holds("ddt(dot(L, L)) = 0", K::free));
  EXPECT_TRUE(holds("dot(L, star(L)) = 0", K::free));
  EXPECT_FALSE(holds("star(L) = 0", K::free));
  EXPECT_TRUE(holds("star(L) = 0", K::is_false));
  EXPECT_TRUE(holds("ddt(T) = dot(N, omega)", K::motion));
  EXPECT_TRUE(holds("ddt(p) = F", K::law));
  EXPECT_TRUE(holds("p = m*v", K::definition));
  EXPECT_TRUE(holds("dot(L, ddt(L)) = 0 => ddt(L) = 0", K::non_sequitur));
  EXPECT_FALSE(holds("ddt(L) = 0 => dot(L, ddt(L)) = 0", K::non_sequitur)) << "it follows";
}

TEST(Proof, SettlesSecondDerivatives) {
  using K = ClaimKind;
  EXPECT_TRUE(holds("ddt(ddt(L)) = ddt(N)", K::motion));
  EXPECT_FALSE(holds("ddt(ddt(L)) = 0", K::motion)) << "any torque may change";
  EXPECT_TRUE(holds("ddt(ddt(L)) = 0", K::free));
  EXPECT_TRUE(holds("I1*ddt(dw1) = (I2 - I3)*(dw2*w3 + w2*dw3)", K::free));
  EXPECT_TRUE(holds("I1*ddt(dw1) = (I2 - I3)*(dw2*w3 + w2*dw3) + ddt(N1)", K::motion));
  EXPECT_FALSE(holds("I1*ddt(dw1) = (I2 - I3)*(dw2*w3 + w2*dw3) + N1", K::motion));
  EXPECT_TRUE(holds("ddt(ddt(e1)) = cross(ddt(omega), e1) + cross(omega, cross(omega, e1))", K::identity));
  EXPECT_TRUE(holds("ddt(ddt(T)) = dot(ddt(N), omega) + dot(N, ddt(omega))", K::motion));
  EXPECT_TRUE(holds("m*ddt(ddt(v)) = ddt(F)", K::law));
  EXPECT_TRUE(holds("ddt(dw3) = 0", K::is_false));
}

TEST(Proof, SettlesSecondDerivativesOfTops) {
  const auto under = [](std::vector<std::pair<Quantity, const char*>> settings, const char* text,
                        ClaimKind kind) {
    Given given;
    for (const auto& [quantity, value] : settings)
      given.settings.push_back({quantity, testing::equality(value, "0").left, value, {}, {}});
    return judge(line_of(text, kind), kind, prover(), given).verdict;
  };
  const std::pair<Quantity, const char*> symmetric{Quantity::I2, "I1"}, heavy{Quantity::N, "h*cross(ez, e3)"};
  const char* turning = "ddt(dw1) = -((I1 - I3)/I1*w3)^2*w1";
  EXPECT_EQ(under({symmetric}, turning, ClaimKind::free), Verdict::holds);
  EXPECT_EQ(under({}, turning, ClaimKind::free), Verdict::fails);
  // I1 ü of the cosine u of the tilt: from e3×(d/dt of I1 e3×ė3 + I3 ω3 e3), times ez.
  const char* tilt =
      "I1*ddt(ddt(dot(ez, e3))) = I3*w3*dot(ez, omega - w3*e3) - h*(1 - dot(ez, e3)^2)"
      " - I1*dot(ez, e3)*norm2(cross(omega, e3))";
  EXPECT_EQ(under({symmetric, heavy}, tilt, ClaimKind::motion), Verdict::holds);
  EXPECT_EQ(under({heavy}, tilt, ClaimKind::motion), Verdict::fails);
  EXPECT_EQ(under({symmetric, heavy}, "ddt(ddt(L)) = h*cross(ez, cross(omega, e3))", ClaimKind::motion),
            Verdict::holds);
  EXPECT_EQ(under({symmetric, heavy}, "ddt(dw3) = 0", ClaimKind::motion), Verdict::holds);
  EXPECT_EQ(under({symmetric, heavy}, "ddt(dw1) = 0", ClaimKind::motion), Verdict::fails);
}

TEST(Proof, SettlesWhatFollows) {
  using K = ClaimKind;
  EXPECT_TRUE(holds("ddt(L) = 0 => ddt(dot(L, L)) = 0", K::motion));
  EXPECT_TRUE(holds("ddt(L) = 0 => ddt(T) = 0", K::motion));
  EXPECT_TRUE(holds("I2 = I1 => dw3 = N3/I3", K::motion));
  EXPECT_TRUE(holds("2*I3 = I1 + I2 => 2*T = I1*(w1^2 + w3^2/2) + I2*(w2^2 + w3^2/2)", K::identity));
  EXPECT_TRUE(holds("dot(omega, e3) = 0 => L = I1*w1*e1 + I2*w2*e2", K::identity));
  EXPECT_TRUE(holds("L = 0 => omega = 0", K::identity));
  EXPECT_TRUE(holds("ddt(omega) = 0 => N = cross(omega, L)", K::motion));
  const Judgement converse = judged("ddt(T) = ddt(T) + N1 => ddt(L) = 0", K::motion);
  EXPECT_EQ(converse.verdict, Verdict::fails);
  EXPECT_TRUE(converse.counterexample);
  // Solved for w1 alone, the states with w2 = 0 would be lost, and with them what is false.
  for (const char* lossy :
       {"w1*w2 = 0 => w1 = 0", "ddt(T) = 0 => ddt(L) = 0", "T = 0 => omega = 0", "w1*(I2 - I3) = 0 => w1 = 0",
        "dot(ez, e3) = 0 => T = 0", "w1^2 = w2^2 => w1 = w2", "h*w1 = 0 => w1 = 0",
        "1/(w1 + w2) = 1 => w1 = 1 - w2", "cross(omega, L) = 0 => omega = 0", "w1 = w2 + N1*0 => dw1 = dw2",
        "N1 = 0 => ddt(N1) = 0", "I1 = -I2 => T = 0"})
    EXPECT_EQ(judged(lossy, K::motion).verdict, Verdict::undecided) << lossy;
}

TEST(Proof, TellsTheTransportTheoremFromItsSlips) {
  for (const char* slip : {"ddt(A) = star(A) - cross(omega, A)", "ddt(A) = star(A) + cross(A, omega)",
                           "ddt(A) = star(A)", "star(A) = ddt(A) + cross(omega, A)"})
    EXPECT_FALSE(holds(slip, ClaimKind::identity)) << slip;
}

TEST(Proof, ACounterexampleIsAPossibleStateInWords) {
  const Judgement swapped = judged("I1*dw1 + w2*w3*(I2 - I3) = N1", ClaimKind::motion);
  EXPECT_EQ(swapped.verdict, Verdict::fails);
  EXPECT_THAT(swapped.message, HasSubstr("I = (2, 3, 4), ω = (0, 1, 1)"));
  ASSERT_TRUE(swapped.counterexample);

  const auto gyroscope = judged("dot(L, ddt(L)) = 0 => ddt(L) = 0", ClaimKind::non_sequitur).counterexample;
  ASSERT_TRUE(gyroscope);
  EXPECT_EQ(gyroscope->state, "I = (2, 3, 4), ω = (1, 0, 0), N = (0, 1, 0)");
  EXPECT_EQ(gyroscope->left, "(0, 1, 0)");
  EXPECT_EQ(gyroscope->right, "0");
}

TEST(Proof, FindsWhatDoesNotFollow) {
  for (const char* inference :
       {"F = 0 => v = 0", "ddt(p) = 0 => p = 0", "v = 0 => F = 0", "ddt(A) = 0 => star(A) = 0",
        "I1 = I2 => I2 = I3", "I1 = I3 => w1 = w3", "I1 = I2 => ddt(omega) = 0", "I3 = I1 + I2 => I1 = I2",
        "m = 1 => F = 0", "ddt(norm2(L)) = 0 => ddt(L) = 0"})
    EXPECT_TRUE(holds(inference, ClaimKind::non_sequitur)) << inference;
  EXPECT_FALSE(holds("v = 0 => p = 0", ClaimKind::non_sequitur));
}

TEST(Proof, SaysWhereThereIsNoTorque) {
  EXPECT_THAT(judged("star(L) = 0", ClaimKind::free).message, HasSubstr("ω = (1, 1, 0), N = 0"));
}

TEST(Proof, SaysWhichKindWouldHold) {
  EXPECT_THAT(judged("ddt(T) = 0", ClaimKind::motion).hint, HasSubstr("free"));
  EXPECT_THAT(judged("ddt(L) = N", ClaimKind::identity).hint, HasSubstr("motion"));
}

TEST(Proof, RefusesATrueLineCalledFalse) {
  EXPECT_FALSE(holds("ddt(T) = 0", ClaimKind::is_false));
  EXPECT_FALSE(holds("cross(omega, omega) = 0", ClaimKind::is_false));
}

TEST(Proof, WhatIsNowhereDefinedIsUndecided) {
  EXPECT_EQ(judged("1/(w1 - w1) = 1/(w2 - w2)", ClaimKind::identity).verdict, Verdict::undecided);
  EXPECT_EQ(judged("1/0 = 1", ClaimKind::is_false).verdict, Verdict::undecided);
  EXPECT_TRUE(holds("w1/w1 = 1", ClaimKind::identity)) << "defined almost everywhere";
}

// 2^61 − 1 is 0 in the field, and no zero.
TEST(Proof, IsNotDeceivedByMultiplesOfThePrime) {
  const std::string prime = "(((2^15)^4)*2 - 1)";
  EXPECT_NE(judged(prime + "*T = 0", ClaimKind::identity).verdict, Verdict::holds);
}

// Made to vanish, modulo the prime, at all the points that every claim is tried at; it holds nowhere else.
TEST(Proof, IsNotDeceivedByWhatIsMadeForItsPoints) {
  EXPECT_FALSE(
      holds("135706915171*w1 + 538351745942*w2 + 1440676655040*w3 + 658129648931*I1 - 293642739508*I2 - "
            "163220875269*I3 - 80313254239*w1*w1 - 497582140289*w2*w2 - 335353948545*w3*w3 + "
            "247978507744*I1*I1 - 64549459038*I2*I2 - 357284661206*I3*I3 = 0",
            ClaimKind::identity));
}

TEST(Proof, TakesDecimalNumbersExactly) {
  EXPECT_TRUE(holds("0.1*T + 0.2*T = 0.3*T", ClaimKind::identity));
  EXPECT_TRUE(holds("1e-3*T = T/1000", ClaimKind::identity));
  EXPECT_FALSE(holds("0.333333333*T = T/3", ClaimKind::identity));
}

TEST(Proof, ComparesLengthsByTheirSquares) {
  using K = ClaimKind;
  EXPECT_TRUE(holds("norm(ddt(omega)) = norm(star(omega))", K::identity));
  EXPECT_TRUE(holds("norm(omega) = norm(-omega)", K::identity));
  EXPECT_TRUE(holds("norm(ddt(L)) = norm(N)", K::motion));
  EXPECT_TRUE(holds("norm(L)/I1 = norm(L/I1)", K::identity));
  EXPECT_TRUE(holds("norm(L/I1) = 2*norm(L)/(I1 + I1)", K::identity));
  EXPECT_TRUE(holds("I1*norm(omega)*m = m*norm(I1*omega)", K::identity));
  EXPECT_TRUE(holds("norm(ddt(L))/I3^2 = norm(N)/I3/I3", K::motion));
  EXPECT_FALSE(holds("norm(L)/I1 = norm(omega)", K::identity));
  EXPECT_FALSE(holds("norm(L)/I1 = norm(L)/I2", K::identity));
  EXPECT_FALSE(holds("norm(ddt(L)) = norm(N)", K::identity));
  EXPECT_TRUE(holds("norm(star(L)) = norm(N)", K::is_false));
  EXPECT_TRUE(holds("norm(cross(omega, L)) = norm(N) => cross(omega, L) = N", K::non_sequitur));
}

// No reader lets such a line through to be proved; the prover itself must not square one side alone.
TEST(Proof, DoesNotTakeALengthForItsSquare) {
  const ClaimLine line = line_of("norm(omega) = norm2(omega)", ClaimKind::measured);
  EXPECT_NE(prover().settle(line.equality, LawsAssumed::identity), Verdict::holds);
}

TEST(Proof, ACounterexampleOfLengthsHasTheirValues) {
  const Judgement wrong = judged("norm(omega + L) = norm(omega - L)", ClaimKind::identity);
  EXPECT_EQ(wrong.verdict, Verdict::fails);
  ASSERT_TRUE(wrong.counterexample);
  EXPECT_EQ(wrong.counterexample->state, "I = (2, 3, 4), ω = (1, 0, 0)");
  EXPECT_EQ(wrong.counterexample->left, "3");
  EXPECT_EQ(wrong.counterexample->right, "1");
}

TEST(Proof, ALengthIsANumberWhereItsDigitsEnd) {
  const auto lengths = [](const char* line) {
    const Judgement wrong = judged(line, ClaimKind::identity);
    return wrong.counterexample ? wrong.counterexample->left + " and " + wrong.counterexample->right : "";
  };
  EXPECT_EQ(lengths("norm(0.5*omega) = norm(2*omega)"), "0.5 and 2");
  EXPECT_EQ(lengths("norm(omega/3) = norm(1000*omega)"), "√0.111111 and 1000");
  EXPECT_EQ(lengths("norm(omega + e2) = norm(0*omega)"), "√2 and 0");
  EXPECT_EQ(lengths("norm(1.5*omega) = norm(1234*omega)"), "1.5 and √1.52276e+06") << "six digits of it";
}

TEST(Proof, NoKindIsSuggestedOfLengthsThatVanishWithTheTorque) {
  EXPECT_THAT(judged("norm2(N) = norm2(2*N)", ClaimKind::motion).hint, IsEmpty());
  EXPECT_THAT(judged("norm(N) = norm(2*N)", ClaimKind::motion).hint, IsEmpty());
  EXPECT_THAT(judged("norm(ddt(L)) = norm(2*N)", ClaimKind::motion).hint, IsEmpty());
  EXPECT_EQ(judged("norm(ddt(L)) = norm(N)", ClaimKind::identity).hint,
            "it follows from the equations of motion: its kind is motion");
}

// The words for a motion come behind a lesson's constants, and together they are more than a state has
// places for.
TEST(Proof, TellsConstantsApartHoweverManyThereAre) {
  Vocabulary words;
  for (int i = 0; i < 40; ++i) words.add_constant("word" + std::to_string(i), 1, "w");
  const auto read = [&](const std::string& text) {
    TextReport at(text);
    return read_expression(text, {1, 1}, at.report, &words).value();
  };
  const auto settled = [&](const std::string& left, const std::string& right) {
    return prover().settle({read(left), read(right)}, LawsAssumed::identity);
  };
  EXPECT_EQ(settled("word39 + word2", "word2 + word39"), Verdict::holds);
  for (const char* other : {"word2", "word15", "word16", "word38"})
    EXPECT_EQ(settled("word39", other), Verdict::fails) << other;
  std::string sum = "word20";
  for (int i = 21; i < 40; ++i) sum += " + word" + std::to_string(i);
  EXPECT_EQ(settled(sum, sum), Verdict::undecided) << "more than there is room for";
}

}  // namespace
}  // namespace polhode
