// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/vocabulary.h"

#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/proof/proof.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TextReport;

/// mgl; u = cos of the tilt, E = T + mgl u.
Vocabulary words() {
  Vocabulary vocabulary;
  vocabulary.add_constant("mgl", 2.5, R"(mg\ell)");
  const auto define = [&](const std::string& name, const std::string& means, const std::string& tex) {
    TextReport at(means);
    vocabulary.define(name, read_expression(at.text, {1, 1}, at.report, &vocabulary).value(), tex);
  };
  define("u", "dot(ez, e3)", "u");
  define("E", "T + mgl*u", "");
  define("theta", "acos(u)", R"(\theta)");
  return vocabulary;
}

std::optional<Expression> read(const std::string& text, const Vocabulary& vocabulary) {
  TextReport at(text);
  auto expression = read_expression(at.text, {1, 1}, at.report, &vocabulary);
  EXPECT_EQ(expression.has_value(), at.lines().empty());
  return expression;
}

std::vector<std::string> faults(const std::string& text, const Vocabulary& vocabulary) {
  TextReport at(text);
  EXPECT_FALSE(read_expression(at.text, {1, 1}, at.report, &vocabulary));
  return at.lines();
}

bool are_same(const std::string& left, const std::string& right) {
  const Vocabulary vocabulary = words();
  return Prover().settle({*read(left, vocabulary), *read(right, vocabulary)}, LawsAssumed::identity) ==
         Verdict::holds;
}

TEST(Vocabulary, AWordIsWhatItStandsFor) {
  EXPECT_TRUE(are_same("E", "T + mgl*dot(ez, e3)"));
  EXPECT_TRUE(are_same("2*u^2*E", "2*(T*u^2 + mgl*u^3)")) << "as if in brackets";
  EXPECT_TRUE(are_same("cos(theta)", "dot(e3, ez)"));
  EXPECT_TRUE(are_same("ddt(E) - ddt(T)", "mgl*dot(ez, cross(omega, e3))"));
  EXPECT_FALSE(are_same("E", "T - mgl*u"));
}

TEST(Vocabulary, AConstantIsAnyNumberForProofs) {
  EXPECT_FALSE(are_same("mgl", "2.5")) << "what is proved holds for other values too";
  EXPECT_TRUE(are_same("ddt(mgl)", "0"));
  const Vocabulary vocabulary = words();
  const auto counter =
      Prover().refute({*read("mgl*T", vocabulary), *read("T", vocabulary)}, LawsAssumed::identity);
  ASSERT_TRUE(counter);
  EXPECT_THAT(counter->state, HasSubstr("mgl = 2"));
}

TEST(Vocabulary, FaultsPointToTheWord) {
  const Vocabulary vocabulary = words();
  EXPECT_THAT(faults("T + dot(u, ez)", vocabulary),
              ElementsAre("1:9: error: \"dot\" takes vectors, this is a scalar"));
  EXPECT_THAT(faults("mgll", vocabulary), ElementsAre(HasSubstr("did you mean \"mgl\"?")));
  EXPECT_THAT(faults("u(2)", vocabulary), ElementsAre(HasSubstr("\"u\" is no function")));
}

TEST(Vocabulary, WhatIsDefinedLaterIsSaidToBe) {
  Vocabulary vocabulary;
  vocabulary.announce({"E"});
  EXPECT_THAT(faults("2*E", vocabulary),
              ElementsAre("1:3: error: \"E\" is defined further down (a definition uses those above it)"));
}

// u₁ = u₀·u₀, u₂ = u₁·u₁ …: written out 2ⁿ factors.
TEST(Vocabulary, DefinitionsInDefinitionsEndSomewhere) {
  Vocabulary vocabulary;
  std::string last = "w1";
  std::vector<std::string> said;
  for (int n = 0; n < 40 && said.empty(); ++n) {
    TextReport at(last + " + " + last);
    auto means = read_expression(at.text, {1, 1}, at.report, &vocabulary);
    said = at.lines();
    last = "u" + std::to_string(n);
    if (means) vocabulary.define(last, std::move(*means), "");
  }
  EXPECT_THAT(said, ElementsAre(HasSubstr("written out, this has more than 4096 parts")));
}

TEST(Vocabulary, NamesAreNotThoseOfTheLanguage) {
  for (const char* name : {"u", "mgl", "E_kin", "a1"}) EXPECT_THAT(why_no_word(name), IsEmpty()) << name;
  for (const char* name : {"", "1a", "_a", "a-b", "I1", "omega", "ez", "dot", "sqrt", "J", "pi", "h"})
    EXPECT_FALSE(why_no_word(name).empty()) << name;
}

TEST(Vocabulary, IsPrintedAsTheLessonSays) {
  const Vocabulary vocabulary = words();
  const auto printed = [&](const std::string& text) { return tex_of(*read(text, vocabulary), &vocabulary); };
  EXPECT_EQ(printed("T + mgl*u"), R"(T + mg\ell\,u)");
  EXPECT_EQ(printed("mgl^2*u^2"), R"((mg\ell)^{2}\,u^{2})");
  EXPECT_EQ(printed("ddt(E)"), R"(\frac{d(\text{E})}{dt})");
  EXPECT_EQ(printed("ddt(u)"), R"(\frac{du}{dt})");
  EXPECT_EQ(printed("cos(theta)*sin(2*theta)"), R"(\cos \theta\,\sin(2\,\theta))");
  EXPECT_EQ(printed("(u)*dot(ez, omega)"), R"(u\,(\hat e_z\cdot \vec\omega))");
}

}  // namespace
}  // namespace polhode
