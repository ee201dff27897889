// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/signs.h"

#include "lessons/claims/proof/proof.h"
#include "lessons/claims/proof/whole_number_states.h"
#include "lessons/reader/claim_lines.h"
#include "tests/lessons/peak_memory.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <random>

namespace polhode {
namespace {

using testing::equality;
using ::testing::HasSubstr;
using testing::TextReport;

Given given_by(const std::vector<std::pair<Quantity, const char*>>& settings) {
  Given given;
  for (const auto& [quantity, value] : settings)
    given.settings.push_back({quantity, equality(value, "0").left, value, {}, {}});
  return given;
}

Judgement judged(const std::string& text, ClaimKind kind, const Given& given = {}) {
  static const Prover prover;
  TextReport at(text);
  const auto lines = read_claim_lines(at.source, 1, 1, kind, at.report);
  EXPECT_EQ(lines.size(), 1U) << text << ": " << ::testing::PrintToString(at.lines());
  return lines.empty() ? Judgement() : judge(lines.front(), kind, prover, given);
}
Verdict verdict(const std::string& text, ClaimKind kind, const Given& given = {}) {
  return judged(text, kind, given).verdict;
}

TEST(Signs, AreProvedOfSumsOfProductsOfKnownSign) {
  for (const char* text : {"T >= 0",
                           "0 <= T",
                           "I1 > 0",
                           "m*norm2(v) >= 0",
                           "I1 + I2 >= I3",
                           "I3 - I1 <= I2",
                           "2*I1 < 3*I1",
                           "norm2(L) >= 0",
                           "trace(J) > 0",
                           "Jxx <= Jyy + Jzz",
                           "(w1 - w2)^2 >= 0",
                           "w1^2 + w2^2 >= 2*w1*w2",
                           "4*w1^2 + w2^2 >= 4*w1*w2",
                           "w1^2 + w2^2 + w3^2 >= w1*w2 + w2*w3 + w3*w1",
                           "norm2(L)*norm2(omega) >= 4*T^2",
                           "dot(ez, e3) <= 1",
                           "-1 <= dot(ez, e3)",
                           "norm2(omega) + 1 > 0",
                           "1/(1 + w1^2) <= 1",
                           "norm2(L)/(2*T) <= I1 + I2 + I3",
                           "-I1 < I2",
                           "I1*I2 > 0",
                           "w1^(-2) >= 0"})
    EXPECT_EQ(verdict(text, ClaimKind::identity), Verdict::holds) << text;
}

TEST(Signs, AreProvedOfMotionsAndOfWhatIsGiven) {
  const Given flat = given_by({{Quantity::I3, "I1 + I2"}});
  const Given symmetric = given_by({{Quantity::I2, "I1"}});
  const Given damped = given_by({{Quantity::N, "-m*omega"}});
  EXPECT_EQ(verdict("ddt(T) <= 0", ClaimKind::motion, damped), Verdict::holds);
  EXPECT_EQ(verdict("ddt(T) <= 0", ClaimKind::motion), Verdict::fails);
  EXPECT_EQ(verdict("norm2(L)/(2*T) <= I3", ClaimKind::identity, flat), Verdict::holds);
  EXPECT_EQ(verdict("norm2(L)/(2*T) <= I3", ClaimKind::identity), Verdict::fails);
  EXPECT_EQ(verdict("I3 <= 2*I1", ClaimKind::identity, symmetric), Verdict::holds);
  EXPECT_EQ(verdict("I3 < 2*I1", ClaimKind::identity, symmetric), Verdict::fails) << "a disc";
  EXPECT_EQ(verdict("w3*ddt(dw3) <= 0", ClaimKind::free, symmetric), Verdict::holds) << "it is 0";
}

TEST(Signs, AreRefutedByAPossibleState) {
  const Judgement gap = judged("I3 < I1 + I2", ClaimKind::identity);
  EXPECT_EQ(gap.verdict, Verdict::fails);
  ASSERT_TRUE(gap.counterexample);
  EXPECT_EQ(gap.counterexample->left, gap.counterexample->right) << "flat bodies are possible";
  for (const char* text : {"T > 0", "w1 >= 0", "I1 <= I2", "N1 < 1", "dot(ez, e3) < 1", "w1^2 > 0", "I1 > I1",
                           "w1*w2 <= 0", "h >= 0", "dw1^2 < 0", "1/w1 > 0"}) {
    const Judgement judgement = judged(text, ClaimKind::identity);
    EXPECT_EQ(judgement.verdict, Verdict::fails) << text;
    EXPECT_TRUE(judgement.counterexample) << text;
    if (std::string_view(text).front() != 'N') {  // what is false fails without torque too
      EXPECT_EQ(verdict(text, ClaimKind::is_false), Verdict::holds) << text;
    }
  }
  EXPECT_EQ(verdict("T >= 0", ClaimKind::is_false), Verdict::fails);
}

// w1⁴w2² + w1²w2⁴ + w3⁶ ≥ 3 w1²w2²w3² holds (means of three), but it is no sum of squares (Motzkin).
TEST(Signs, AreNeitherProvedNorRefutedWhereNoSquaresAreFound) {
  const Judgement open = judged("w1^4*w2^2 + w1^2*w2^4 + w3^6 >= 3*w1^2*w2^2*w3^2", ClaimKind::identity);
  EXPECT_EQ(open.verdict, Verdict::not_refuted);
  EXPECT_GE(open.states, 500);
  EXPECT_THAT(open.message, HasSubstr(std::to_string(open.states) + " states"));
  EXPECT_EQ(verdict("1/(w1 - w1) >= 0", ClaimKind::identity), Verdict::undecided);
}

Given bounded_by(const std::vector<std::string>& bounds, Given given = {}) {
  for (const std::string& text : bounds) {
    TextReport at(text);
    const auto lines = read_claim_lines(at.source, 1, 1, ClaimKind::identity, at.report);
    given.bounds.push_back({lines.at(0).equality, lines.at(0).relation, text, {}, {}});
    EXPECT_FALSE(why_not_bound(given.bounds.back()));
  }
  EXPECT_TRUE(bounds_are_possible(given));
  return given;
}

TEST(Signs, AreProvedOfBodiesThatInequalitiesLeave) {
  using Texts = std::vector<std::string>;
  const Given plane = given_by({{Quantity::I2, "I1"}});
  struct Case {
    Texts bounds;
    Given settings;
    const char* claim;
    Verdict verdict;
  };
  const Case cases[] = {
      {{"I3 > I1"}, {}, "I3 - I1 > 0", Verdict::holds},
      {{"I3 >= I1"}, {}, "I3 - I1 > 0", Verdict::fails},
      {{"I3 >= I1"}, {}, "I3 - I1 >= 0", Verdict::holds},
      {{"I3 > I1"}, {}, "I3 > I2", Verdict::fails},
      {{"I1 < I2", "I2 < I3"}, {}, "I3 > I1", Verdict::holds},
      {{"I1 > I2", "I2 > I3"}, {}, "I1*I2 > I3^2", Verdict::holds},
      {{"I1 > I2", "I2 > I3"}, {}, "I1 < I2", Verdict::fails},
      {{"I1 < I2", "I2 < I3"}, {}, "norm2(L) >= 2*T*I1", Verdict::holds},
      {{"I1 < I2", "I2 < I3"}, {}, "norm2(L) <= 2*T*I3", Verdict::holds},
      {{"I1 < I2", "I2 < I3"}, {}, "norm2(L) <= 2*T*I2", Verdict::fails},
      {{"I1 < I2", "I2 < I3"}, {}, "(I2 - I1)*(I3 - I2)/(I1*I3) > 0", Verdict::holds},
      {{"I3 > I1"}, plane, "I3 > I2", Verdict::holds},
      {{"I3 > I1"}, plane, "norm2(L) >= 2*T*I1", Verdict::holds},
      {{"I3 < I1"}, plane, "norm2(L) <= 2*T*I1", Verdict::holds},
      {{"h > 0"}, given_by({{Quantity::N, "-h*omega"}}), "dot(N, omega) <= 0", Verdict::holds},
      {{"h < 0"}, given_by({{Quantity::N, "h*omega"}}), "ddt(T) <= 0", Verdict::holds},
      {{"h > 0"}, given_by({{Quantity::N, "h*omega"}}), "ddt(T) <= 0", Verdict::fails},
      {{"w3 > 0"}, {}, "I3*w3 > 0", Verdict::holds},
      {{"w3 >= 0"}, {}, "I3*w3 > 0", Verdict::fails},
      {{"I3 < 0.01*I1"}, {}, "I3 < I1", Verdict::holds},
  };
  for (const Case& c : cases) {
    const Given given = bounded_by(c.bounds, c.settings);
    const Judgement judgement = judged(c.claim, ClaimKind::motion, given);
    EXPECT_EQ(judgement.verdict, c.verdict) << c.claim << ": " << judgement.message;
    EXPECT_EQ(judgement.counterexample.has_value(), c.verdict == Verdict::fails) << c.claim;
  }
}

TEST(Signs, CounterexamplesLieWithinTheInequalities) {
  const auto state_of_failure = [](const char* claim, const Given& given) {
    const Judgement judgement = judged(claim, ClaimKind::motion, given);
    return judgement.counterexample ? judgement.counterexample->state : "none: " + judgement.message;
  };
  const auto moments = [](const std::string& state) {
    std::array<double, 3> I{};
    EXPECT_EQ(std::sscanf(state.c_str(), "I = (%lf, %lf, %lf)", &I[0], &I[1], &I[2]), 3) << state;
    return I;
  };
  const auto down = moments(state_of_failure("dw1 = 0", bounded_by({"I1 > I2", "I2 > I3"})));
  EXPECT_TRUE(down[0] > down[1] && down[1] > down[2]);
  const auto thin = moments(state_of_failure("dw1 = 0", bounded_by({"I3 < 0.01*I1"})));
  EXPECT_LT(thin[2], 0.01 * thin[0]);
  EXPECT_THAT(state_of_failure("I1 = I3", bounded_by({"I3 > I1"}, given_by({{Quantity::I2, "I1"}}))),
              HasSubstr("I = ("));
}

TEST(Signs, ContradictionsLeaveNoRoom) {
  const auto is_possible_with = [](const std::vector<std::string>& bounds, Given given = {}) {
    for (const std::string& text : bounds) {
      TextReport at(text);
      const auto lines = read_claim_lines(at.source, 1, 1, ClaimKind::identity, at.report);
      given.bounds.push_back({lines.at(0).equality, lines.at(0).relation, text, {}, {}});
    }
    return bounds_are_possible(given);
  };
  EXPECT_FALSE(is_possible_with({"I1 > I2", "I2 > I1"}));
  EXPECT_FALSE(is_possible_with({"I1 >= I2", "I2 >= I1"})) << "an equality is set as one";
  EXPECT_FALSE(is_possible_with({"I1 > I2", "I2 > I3", "I3 > I1"}));
  EXPECT_FALSE(is_possible_with({"I3 > I1 + I2"}));
  EXPECT_FALSE(is_possible_with({"I1 > I2"}, given_by({{Quantity::I2, "I1"}})));
  EXPECT_FALSE(is_possible_with({"h > 0", "h < 0"}));
  EXPECT_FALSE(is_possible_with({"2 < 1"}));
  EXPECT_TRUE(is_possible_with({"I1 > I2", "I2 > I3"}));
  EXPECT_TRUE(is_possible_with({"I3 < 0.001*I1"}));
  EXPECT_TRUE(is_possible_with({"I3 > 1.9*I1"}, given_by({{Quantity::I2, "I1"}})));
  EXPECT_TRUE(is_possible_with({"h > 0", "w3 < 0"}));
  EXPECT_TRUE(is_possible_with({"I1 < 1e-5", "w3 > 1000"})) << "a small gyroscope";
}

TEST(Signs, RoomIsLookedForNoLongerThanAMoment) {
  std::string sum = "w1";
  for (int i = 0; i < 1000; ++i) sum += "+w" + std::to_string(i % 3 + 1);
  Given given;
  for (int i = 0; i < 8; ++i)
    given.bounds.push_back({equality(sum, "1e9*norm2(omega) + 1e9"), Relation::greater, "", {}, {}});
  const std::clock_t begin = std::clock();
  EXPECT_FALSE(bounds_are_possible(given));
  const double took_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (!testing::kSanitized) {
    EXPECT_LT(took_ms, 100);
  }
}

// What is called proved holds at random possible bodies and states, whatever was thrown together.
TEST(Signs, OfNothingFalseAreProved) {
  std::mt19937_64 random(5);
  const auto pick = [&random](const std::vector<std::string>& all) { return all[random() % all.size()]; };
  const std::vector<std::string> atoms{"I1", "I2", "I3", "w1", "w2", "w3", "T", "m", "N1", "2", "1"};
  const auto product = [&] { return pick(atoms) + "*" + pick(atoms) + (random() % 2 == 0 ? "" : "^2"); };
  const auto draw = [&random] { return static_cast<double>(random() >> 11) / 9007199254740992.0; };
  int proved = 0;
  for (int n = 0; n < 2500; ++n) {
    const std::string left = product() + pick({"+", "-"}) + product(), right = n % 3 == 0 ? product() : "0*T";
    const Equality sides = equality(left, right);
    const bool strict = n % 2 == 0;
    if (!is_never_less(sides, strict, LawsAssumed::motion, {})) continue;
    ++proved;
    for (int state = 0; state < 200; ++state) {
      StateNumbers<SizedNumber> numbers;
      const double a = draw(), b = draw(), c = state % 4 == 0 ? 0 : draw();
      numbers.I = {b + c, a + c, a + b};
      for (auto* vector : {&numbers.w, &numbers.N_B})
        for (SizedNumber& x : *vector) x = 4 * draw() - 2;
      numbers.m = 2 * draw() + 1e-3;
      const auto values = sides_of(sides, state_of(numbers, LawsAssumed::motion)).value();
      const double difference = values.left[0].value.value - values.right[0].value.value;
      EXPECT_GE(difference, -1e-14 * (values.left[0].value.size + values.right[0].value.size))
          << left << " >= " << right;
    }
  }
  EXPECT_GE(proved, 60);
}

// The same of bodies that are ordered: all that is proved of them holds at random ones.
TEST(Signs, OfNothingFalseAreProvedWithinInequalities) {
  std::mt19937_64 random(6);
  const auto pick = [&random](const std::vector<std::string>& all) { return all[random() % all.size()]; };
  const std::vector<std::string> atoms{"I1", "I2", "I3", "(I2 - I1)", "(I3 - I2)", "w1", "w3", "h", "2", "1"};
  const auto product = [&] { return pick(atoms) + "*" + pick(atoms) + "*" + pick(atoms); };
  const auto draw = [&random] { return static_cast<double>(random() >> 11) / 9007199254740992.0; };
  const std::vector<std::vector<std::string>> all_bounds{{"I1 < I2", "I2 < I3"},
                                                         {"I3 >= I1", "h > 0"},
                                                         {"2*I1 <= I2 + I3", "w3 < 0"},
                                                         {"I3 > 1.5*I2", "I1 > I2"}};
  int proved = 0;
  for (int n = 0; n < 2400; ++n) {
    const Given given = bounded_by(all_bounds[static_cast<std::size_t>(n) % all_bounds.size()]);
    const std::string left = product() + pick({"+", "-"}) + product(), right = n % 3 == 0 ? product() : "0*T";
    const Equality sides = equality(left, right);
    const bool strict = n % 2 == 0;
    if (!is_never_less(sides, strict, LawsAssumed::motion, given)) continue;
    ++proved;
    for (int state = 0; state < 400; ++state) {
      StateNumbers<SizedNumber> numbers;
      const double a = draw(), b = draw(), c = state % 4 == 0 ? 0 : draw();
      numbers.I = {b + c, a + c, a + b};
      for (SizedNumber& x : numbers.w) x = 4 * draw() - 2;
      numbers.h = 4 * draw() - 2;
      const auto at = state_of(numbers, LawsAssumed::motion);
      if (!holds_in(given, at, 0)) continue;
      const auto values = sides_of(sides, at).value();
      const double difference = values.left[0].value.value - values.right[0].value.value;
      const double rounding = 1e-14 * (values.left[0].value.size + values.right[0].value.size);
      EXPECT_GE(difference, -rounding) << left << " >= " << right << " given " << given.bounds[0].text;
    }
  }
  EXPECT_GE(proved, 60);
}

TEST(Signs, EndSoonWhateverIsAsked) {
  std::string sum = "w1";
  for (int i = 0; i < 40; ++i)
    sum +=
        "+w" + std::to_string(i % 3 + 1) + "*I" + std::to_string(i % 2 + 1) + "+h^" + std::to_string(i % 9);
  for (const std::string& text :
       std::vector<std::string>{"(" + sum + ")^16", "ddt(ddt((" + sum + ")^4))", "((w1 + w2 + w3 + h)^16)^16",
                                "1/(" + sum + ")^3 + 1/(1 + T)^5 + ddt(ddt(1/T))"}) {
    const Equality sides = equality(text, "0");
    const std::clock_t begin = std::clock();
    is_never_less(sides, false, LawsAssumed::motion, given_by({{Quantity::N, "h*cross(ez, e3)"}}));
    const double took_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (!testing::kSanitized) {
      EXPECT_LT(took_ms, 20) << text.substr(0, 30);
    }
  }
}

}  // namespace
}  // namespace polhode
