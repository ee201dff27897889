// SPDX-License-Identifier: MIT
#include "lessons/claims/given.h"

#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/claims/proof/whole_number_states.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using testing::TextReport;

const Vocabulary& words() {
  static const Vocabulary kOne = [] {
    Vocabulary vocabulary;
    vocabulary.add_constant("mgl", 2.5, "mgl");
    return vocabulary;
  }();
  return kOne;
}

Expression expression(const std::string& text) {
  TextReport at(text);
  return read_expression(at.text, {1, 1}, at.report, &words()).value();
}

Setting setting(const std::string& name, const std::string& value) {
  return {find_quantity(name)->quantity, expression(value), name + " = " + value, {}, {}};
}

using Texts = std::vector<std::pair<std::string, std::string>>;

Given given(const Texts& settings) {
  Given all;
  for (const auto& [name, value] : settings) all.settings.push_back(setting(name, value));
  return all;
}

const Prover& prover() {
  static const Prover kOne;
  return kOne;
}

Verdict verdict(const std::string& left, const std::string& right, ClaimKind kind, const Given& given) {
  const ClaimLine line{
      .equality = {expression(left), expression(right)}, .conclusion = {}, .within = {}, .place = {}};
  return judge(line, kind, prover(), given).verdict;
}

const Given& symmetric() {
  static const Given kOne = given({{"I2", "I1"}});
  return kOne;
}
const Given& heavy() {
  static const Given kOne = given({{"N", "mgl*cross(ez, e3)"}});
  return kOne;
}
const Given& symmetric_and_heavy() {
  static const Given kOne = given({{"I2", "I1"}, {"N", "mgl*cross(ez, e3)"}});
  return kOne;
}

struct Case {
  const char *left, *right;
  ClaimKind kind;
  const Given& given;
  bool holds;
};

TEST(Given, ProvesWhatHoldsUnderItAndNothingElse) {
  using K = ClaimKind;
  const Case cases[] = {
      // The symmetric top: Landau & Lifshitz, Mechanics, §33 and §36.
      {"dw3", "0", K::free, symmetric(), true},
      {"dw3", "0", K::motion, symmetric(), false},
      {"dw1", "0", K::free, symmetric(), false},
      {"dw1", "(I1 - I3)/I1*w2*w3", K::free, symmetric(), true},
      {"ddt(w1^2 + w2^2)", "0", K::free, symmetric(), true},
      {"ddt(e3)", "cross(L/I1, e3)", K::free, symmetric(), true},
      {"ddt(e3)", "cross(L/I1, e3)", K::identity, symmetric(), true},
      {"ddt(e3)", "cross(L/I3, e3)", K::identity, symmetric(), false},
      {"omega", "L/I1 + (I1 - I3)/I1*w3*e3", K::identity, symmetric(), true},
      {"2*T", "I1*(w1^2 + w2^2) + I3*w3^2", K::identity, symmetric(), true},
      {"dot(cross(omega, L), e3)", "0", K::identity, symmetric(), true},
      // The heavy top: energy and both momenta are conserved (ibid., §35, problem 1).
      {"ddt(T + mgl*dot(ez, e3))", "0", K::motion, heavy(), true},
      {"ddt(T - mgl*dot(ez, e3))", "0", K::motion, heavy(), false},
      {"ddt(dot(L, ez))", "0", K::motion, heavy(), true},
      {"ddt(dot(L, ex))", "0", K::motion, heavy(), false},
      {"ddt(dot(L, e3))", "0", K::motion, heavy(), false},
      {"ddt(dot(L, e3))", "0", K::motion, symmetric_and_heavy(), true},
      {"dw3", "0", K::motion, symmetric_and_heavy(), true},
      {"dot(N, ez)", "0", K::identity, heavy(), true},
      {"star(L)", "0", K::is_false, heavy(), true},
      {"ddt(dot(L, ez))", "0", K::is_false, heavy(), false},
  };
  for (const Case& c : cases)
    EXPECT_EQ(verdict(c.left, c.right, c.kind, c.given) == Verdict::holds, c.holds)
        << c.left << " = " << c.right;
}

TEST(Given, ACounterexampleIsAStateAsIsGiven) {
  const auto counter = prover().refute({expression("dw1"), expression("0")}, LawsAssumed::free, symmetric());
  ASSERT_TRUE(counter);
  EXPECT_THAT(counter->state, HasSubstr("I = (2, 2, "));
  const auto heavy_one =
      prover().refute({expression("ddt(dot(L, ex))"), expression("0")}, LawsAssumed::motion, heavy());
  ASSERT_TRUE(heavy_one);
  EXPECT_THAT(heavy_one->state, HasSubstr("mgl = 2"));
  EXPECT_THAT(heavy_one->state, HasSubstr("attitude = (1, "));
  // The small whole numbers that are tried make no unit quaternion: printed, they do.
  EXPECT_THAT(heavy_one->state_tex,
              ::testing::ContainsRegex(R"(\$\\text\{attitude\}\\ q = \(1, .*\)/(\\sqrt\{)?[0-9]+)"));
}

// A sphere has no axis of its own: nothing that tells one from the others is proved of it, or everything is.
TEST(Given, SettingsSeeWhatThoseBeforeThemHaveSet) {
  const Given sphere = given({{"I1", "I3"}, {"I2", "(I1 + I3)/2"}});
  EXPECT_EQ(verdict("L", "I3*omega", ClaimKind::identity, sphere), Verdict::holds);
  EXPECT_EQ(verdict("L", "I3*omega", ClaimKind::identity, symmetric()), Verdict::fails);
}

TEST(Given, WhatIsSetHasToBeSomething) {
  const auto fault = [](const std::string& name, const std::string& value, const Texts& before = {}) {
    const auto why = why_not_set(setting(name, value), given(before).settings);
    return why ? why->message : "";
  };
  EXPECT_EQ(fault("I2", "I1"), "");
  EXPECT_EQ(fault("I2", "mgl*0.5"), "");
  EXPECT_EQ(fault("N", "-mgl*omega"), "");
  EXPECT_EQ(fault("N3", "0"), "");
  EXPECT_THAT(fault("T", "0"), HasSubstr("an assumption sets"));
  EXPECT_THAT(fault("dw1", "0"), HasSubstr("an assumption sets"));
  EXPECT_THAT(fault("I2", "w1"), HasSubstr("does not change"));
  EXPECT_THAT(fault("I2", "dot(e1, inertia(e1))"), HasSubstr("does not change"));
  EXPECT_THAT(fault("I2", "2*I2"), HasSubstr("of itself"));
  EXPECT_THAT(fault("w1", "T"), HasSubstr("of itself"));
  EXPECT_THAT(fault("N", "N1*e1"), HasSubstr("of itself"));
  EXPECT_THAT(fault("N", "star(omega)"), HasSubstr("no rates"));
  EXPECT_THAT(fault("N1", "dw1"), HasSubstr("no rates"));
  EXPECT_THAT(fault("N1", "norm(omega)"), HasSubstr("no roots"));
  EXPECT_THAT(fault("N1", "sin(w1)"), HasSubstr("no roots"));
  EXPECT_THAT(fault("N1", "w1^16*w2^16*w3^16*I1^16*I2^16"), HasSubstr("degree"));
  EXPECT_THAT(fault("I2", "I3", {{"I2", "I1"}}), HasSubstr("set already, by \"I2 = I1\""));
  EXPECT_THAT(fault("N1", "0", {{"N", "omega"}}), HasSubstr("set already"));
  EXPECT_THAT(fault("I1", "I2", {{"I2", "I1"}}), HasSubstr("used by \"I2 = I1\" before it"));
}

TEST(Given, ABodyCanBeSoOrNot) {
  EXPECT_TRUE(is_possible(symmetric()));
  EXPECT_TRUE(is_possible(heavy()));
  EXPECT_TRUE(is_possible(given({{"I3", "I1 + I2"}}))) << "a plate";
  EXPECT_TRUE(is_possible(given({{"I1", "0.0013"}, {"I2", "I1"}}))) << "of grams";
  EXPECT_TRUE(is_possible(given({{"I3", "8e18*1e18"}}))) << "the Earth";
  EXPECT_FALSE(is_possible(given({{"I2", "0"}})));
  EXPECT_FALSE(is_possible(given({{"I2", "-I1"}})));
  EXPECT_FALSE(is_possible(given({{"I2", "I1"}, {"I3", "3*I1"}})));
  EXPECT_FALSE(is_possible(given({{"N1", "1/(w1 - w1)"}})));
}

// Whatever is set, 0·a ≠ 1: an assumption never proves everything.
TEST(Given, NothingFalseFollows) {
  for (const Given& one : {symmetric(), heavy(), symmetric_and_heavy(), given({{"w1", "0"}, {"w2", "0"}}),
                           given({{"F", "mgl*ez"}}), given({{"N1", "I1*w1"}, {"N2", "0"}})})
    for (const ClaimKind kind : {ClaimKind::identity, ClaimKind::motion}) {
      EXPECT_EQ(verdict("T", "T + 1", kind, one), Verdict::fails);
      EXPECT_EQ(verdict("omega", "0", kind, one), Verdict::fails);
    }
}

// Coefficients that a prime divides would vanish: 2⁶¹ − 1 as a product that only what is given brings in.
TEST(Given, LargeCoefficientsAreSeenThroughWhatIsGiven) {
  // (2^61 - 1) = 2305843009213693951 has 19 digits: 2305843009 * 10^9 + 213693951.
  const Given large = given({{"I2", "I1*(2305843009*1e9 + 213693951)"}});
  EXPECT_NE(verdict("I2", "0", ClaimKind::identity, large), Verdict::holds);
}

}  // namespace
}  // namespace polhode
