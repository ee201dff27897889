// SPDX-License-Identifier: MIT
// Claims to an order in what is small.
#include "lessons/claims/proof/expansion.h"

#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/proof/proof.h"
#include "tests/lessons/peak_memory.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

namespace polhode {
namespace {

using testing::equality;
using ::testing::HasSubstr;

Given small(const std::vector<std::string>& names, int order) {
  Given given;
  for (const std::string& name : names) given.small.quantities.push_back(find_quantity(name)->quantity);
  given.small.order = order;
  return given;
}

const Prover& prover() {
  static const Prover one;
  return one;
}

Judgement judged(const std::string& left, const std::string& right, ClaimKind kind, const Given& given) {
  ClaimLine line{.equality = equality(left, right), .conclusion = {}, .within = {}, .place = {}};
  line.relation = Relation::approximate;
  return judge(line, kind, prover(), given);
}

struct Case {
  const char *left, *right;
  ClaimKind kind;
  std::vector<std::string> small;
  int holds_to;  ///< the highest order, up to 4, to which it is proved; 0: to none
};

// Euler's equations near an axis: Landau & Lifshitz, Mechanics, §37; the others are written out by hand.
TEST(Expansion, ProvesToTheOrderToWhichItHoldsAndNoFurther) {
  using K = ClaimKind;
  const Case cases[] = {
      {"ddt(ddt(w1))", "(I2 - I3)*(I1 - I2)/(I1*I3)*w2^2*w1", K::free, {"w1", "w3"}, 2},
      {"ddt(ddt(w3))", "(I2 - I3)*(I1 - I2)/(I1*I3)*w2^2*w3", K::free, {"w1", "w3"}, 2},
      {"ddt(ddt(w1))", "(I2 - I3)*(I1 - I2)/(I1*I3)*w2^2*w1", K::free, {"w3"}, 1},
      {"ddt(ddt(w2))", "-(I2 - I1)*(I3 - I1)/(I2*I3)*w1^2*w2", K::free, {"w2", "w3"}, 2},
      {"ddt(ddt(w1))", "-(I2 - I3)*(I1 - I2)/(I1*I3)*w2^2*w1", K::free, {"w1", "w3"}, 0},
      {"ddt(w2)", "0", K::free, {"w1", "w3"}, 1},
      {"ddt(w1)", "(I2 - I3)/I1*w2*w3", K::free, {"w1", "w3"}, 4},
      {"ddt(w1)", "(I2 - I3)/I1*w2*w3", K::motion, {"w1", "w3"}, 0},
      {"I1*ddt(w1)", "(I2 - I3)*w2*w3 + N1", K::motion, {"w1", "w3", "N1"}, 4},
      {"2*T", "I2*w2^2", K::identity, {"w1", "w3"}, 1},
      {"L", "I2*w2*e2 + I1*w1*e1 + I3*w3*e3", K::identity, {"w1", "w3"}, 4},
      {"inertia(omega)", "I2*omega", K::identity, {"w1", "w3"}, 0},
      {"1/(1 + h)", "1 - h", K::identity, {"h"}, 1},
      {"1/(1 + h)", "1 - h + h^2 - h^3", K::identity, {"h"}, 3},
      {"1/(h + h^2)", "1/h - 1 + h", K::identity, {"h"}, 1},
      {"h/(h + h^2)", "1 - h + h^2", K::identity, {"h"}, 2},
      {"(2*T - I2*w2^2)/w1", "I1*w1 + I3*w3^2/w1", K::identity, {"w1", "w3"}, 4},
      {"norm2(L)/(2*T)", "I2", K::identity, {"w1", "w3"}, 1},
      {"norm2(L)/(2*T)",
       "I2 + (I1*(I1 - I2)*w1^2 + I3*(I3 - I2)*w3^2)/(I2*w2^2)",
       K::identity,
       {"w1", "w3"},
       3},
  };
  for (const Case& c : cases)
    for (int order = 1; order <= kMaxSmallOrder; ++order) {
      const Judgement judgement = judged(c.left, c.right, c.kind, small(c.small, order));
      EXPECT_EQ(judgement.verdict == Verdict::holds, order <= c.holds_to)
          << c.left << " ≈ " << c.right << " to order " << order << ": " << judgement.message;
      if (order > c.holds_to) {
        EXPECT_EQ(judgement.verdict, Verdict::fails) << judgement.message;
      }
    }
}

TEST(Expansion, IsRefutedByAStateAndTheFirstTermsThatDiffer) {
  const Judgement wrong =
      judged("ddt(ddt(w1))", "-(I2 - I3)*(I1 - I2)/(I1*I3)*w2^2*w1", ClaimKind::free, small({"w1", "w3"}, 1));
  EXPECT_EQ(wrong.verdict, Verdict::fails);
  ASSERT_TRUE(wrong.counterexample);
  // (3 − 4)(2 − 3)/(2·4) = 1/8 of a body with the moments 2, 3, 4, with ω = (ε, 1, 0).
  EXPECT_EQ(wrong.counterexample->state, "I = (2, 3, 4), ω = (ε, 1, 0), N = 0");
  EXPECT_EQ(wrong.counterexample->left, "0.125ε");
  EXPECT_EQ(wrong.counterexample->right, "−0.125ε");
  EXPECT_THAT(wrong.message,
              HasSubstr("this does not hold to first order: the sides differ in the terms of ε^1"));
  const Judgement later = judged("1/(1 + h)", "1 - h + 2*h^2", ClaimKind::identity, small({"h"}, 3));
  EXPECT_THAT(later.message, HasSubstr("ε^2"));
  EXPECT_THAT(later.counterexample->right, HasSubstr("ε²"));
  EXPECT_EQ(judged("T", "I2*w2^2", ClaimKind::is_false, small({"w1", "w3"}, 1)).verdict, Verdict::holds);
  EXPECT_EQ(judged("2*T", "I2*w2^2", ClaimKind::is_false, small({"w1", "w3"}, 1)).verdict, Verdict::fails);
}

TEST(Expansion, HintsAtTheKindThatWasMeant) {
  const Given near = small({"w1", "w3"}, 1);
  EXPECT_THAT(judged("ddt(w2)", "0", ClaimKind::motion, near).hint, HasSubstr("its kind is free"));
  EXPECT_THAT(judged("I1*ddt(w1)", "(I2 - I3)*w2*w3 + N1", ClaimKind::identity, near).hint,
              HasSubstr("its kind is motion"));
}

TEST(Expansion, OfNothingSaysNothing) {
  const Judgement both = judged("w1*w3", "2*w1*w3", ClaimKind::identity, small({"w1", "w3"}, 1));
  EXPECT_EQ(both.verdict, Verdict::undecided);
  EXPECT_EQ(both.message, "both sides are zero to that order: it says nothing");
  EXPECT_EQ(judged("w1*w3", "2*w1*w3", ClaimKind::identity, small({"w1", "w3"}, 2)).verdict, Verdict::fails);
  EXPECT_EQ(judged("w1*w3", "0", ClaimKind::identity, small({"w1", "w3"}, 1)).verdict, Verdict::holds)
      << "that says that it is zero to that order";
  EXPECT_EQ(judged("1/(w1 - w1)", "1", ClaimKind::identity, small({"w1"}, 1)).verdict, Verdict::undecided);
  // 1/h^12 − 1/(h^12 + h^13) is h^-11 …: of ε^1 nothing is left that is known.
  const Judgement lost = judged("1/h^12 - 1/(h^12 + h^13)", "1/h^11", ClaimKind::identity, small({"h"}, 4));
  EXPECT_NE(lost.verdict, Verdict::holds);
}

// The other terms of ε that a prime divides would vanish; here all coefficients are.
TEST(Expansion, LargeCoefficientsAreSeen) {
  const std::string prime = "(2305843009*1e9 + 213693951)";  // 2^61 − 1
  EXPECT_NE(judged("1 + " + prime + "*h", "1", ClaimKind::identity, small({"h"}, 1)).verdict, Verdict::holds);
  EXPECT_NE(judged("h/(" + prime + " + h)", "1", ClaimKind::identity, small({"h"}, 1)).verdict,
            Verdict::holds);
}

TEST(Expansion, GoesWithWhatIsSet) {
  Given top = small({"w1", "w2"}, 1);
  top.settings.push_back({Quantity::I2, equality("I1", "0").left, "I2 = I1", {}, {}});
  EXPECT_EQ(judged("norm2(L)", "(I3*w3)^2", ClaimKind::identity, top).verdict, Verdict::holds);
  EXPECT_EQ(judged("ddt(w3)", "0", ClaimKind::free, top).verdict, Verdict::holds);
  EXPECT_EQ(judged("ddt(ddt(w1))", "-((I1 - I3)/I1*w3)^2*w1", ClaimKind::free, top).verdict, Verdict::holds);
}

TEST(Expansion, EndsSoonWhateverIsAsked) {
  const Given near = small({"w1", "w3", "h", "k"}, 4);
  const auto repeated = [](const std::string& unit, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += unit;
    return text;
  };
  const std::string nested = repeated("ddt(dot(cross(L, ", 1) + "A), omega))";
  const std::vector<std::string> hostile{
      "ddt(ddt(" + repeated("w1*w2 + h/(w3 + k) + ", 28) + "T))",
      repeated("1/(w1 - ", 60) + "w3" + repeated(")", 60),
      repeated("(", 60) + "w1 + h" + repeated("^2)", 3) + repeated(")", 57),
      "ddt(ddt(1/(w1 + h*w2)^16))",
      repeated("dot(cross(omega, L), A)*", 48) + "w1",
      repeated("w1 + ", 148) + "w1",
      nested,
      "1/(T - I2*w2^2/2)^16",
  };
  double longest = 0, longest_search = 0;
  long most_kilobytes = 0;
  for (const std::string& text : hostile) {
    SCOPED_TRACE(text.substr(0, 40));
    testing::TextReport at(text);
    const auto side = read_expression(at.text, {1, 1}, at.report);
    ASSERT_TRUE(side) << ::testing::PrintToString(at.lines());
    ASSERT_EQ(side->type(), ExpressionType::scalar);
    EXPECT_LE(2 * side->nodes.size(), kMostExpandedNodes) << "this is not expanded";
    const Equality sides{*side, equality("w2 + w1", "0").left};
    if (testing::kSanitized) {
      prover().settle_in_series(sides, LawsAssumed::motion, near);
      continue;
    }
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 3; ++run) {
      const std::clock_t begin = std::clock();
      // Without the search for a state, which is bounded by itself.
      prover().settle_in_series({*side, *side}, LawsAssumed::motion, near);
      least = std::min(least, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    EXPECT_LT(least, 10);
    longest = std::max(longest, least);
    const long kilobytes = testing::peak_kilobytes([&]() -> std::size_t {
      return prover().settle_in_series(sides, LawsAssumed::motion, near).message.size();
    });
    EXPECT_LT(kilobytes, 16 * 1024);
    most_kilobytes = std::max(most_kilobytes, kilobytes);
    const std::clock_t begin = std::clock();
    prover().settle_in_series(sides, LawsAssumed::motion, near);
    const double search = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(search, 100) << "with the search";
    longest_search = std::max(longest_search, search);
  }
  std::printf("sides to fourth order: settled in at most %.1f ms and %ld KiB, searched in at most %.0f ms\n",
              longest, most_kilobytes, longest_search);
}

}  // namespace
}  // namespace polhode
