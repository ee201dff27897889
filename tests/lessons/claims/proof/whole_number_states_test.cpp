// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/whole_number_states.h"

#include "lessons/claims/expressions/expression_names.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::equality;
using ::testing::HasSubstr;
using ::testing::Not;

std::optional<Counterexample> first(const char* left, const char* right, LawsAssumed laws) {
  return first_whole_number_state(equality(left, right), nullptr, laws);
}

std::string state(const char* left, const char* right, LawsAssumed laws) {
  const auto found = first(left, right, laws);
  EXPECT_TRUE(found) << left << " = " << right;
  return found ? found->state : "";
}

TEST(SmallStates, GivesTheFirstAndSaysBothSides) {
  const auto found = first("I1*w1", "I2*w1", LawsAssumed::identity);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->state, "I = (2, 3, 4), ω = (1, 0, 0)");
  EXPECT_EQ(found->left, "2");
  EXPECT_EQ(found->right, "3");
  const auto vectors = first("cross(omega, L)", "0", LawsAssumed::identity);
  ASSERT_TRUE(vectors);
  EXPECT_EQ(vectors->state, "I = (2, 3, 4), ω = (1, 1, 0)");
  EXPECT_EQ(vectors->left, "(0, 0, 1)");
  EXPECT_EQ(vectors->right, "0");
}

TEST(SmallStates, FindsNoneOfWhatHolds) {
  EXPECT_FALSE(first("ddt(A)", "star(A) + cross(omega, A)", LawsAssumed::identity));
  EXPECT_FALSE(first("ddt(L)", "N", LawsAssumed::motion));
  EXPECT_FALSE(first("ddt(T)", "0", LawsAssumed::free));
}

TEST(SmallStates, NamesWhatItDependsOnAndNothingElse) {
  EXPECT_EQ(state("I1", "I2", LawsAssumed::identity), "I = (2, 3, 4)");
  EXPECT_EQ(state("w1", "w2", LawsAssumed::identity), "ω = (1, 0, 0)");
  EXPECT_EQ(state("N1", "w1", LawsAssumed::identity), "ω = (1, 0, 0), N = (0, 0, 0)");
  EXPECT_EQ(state("e1", "e2", LawsAssumed::identity), "any state");
  EXPECT_EQ(state("1", "2", LawsAssumed::identity), "any state");
  EXPECT_EQ(state("dw1", "w1", LawsAssumed::identity), "ω = (1, 0, 0), ω̇ = (0, 0, 0)");
  EXPECT_EQ(state("m", "1", LawsAssumed::identity), "m = 2");
}

TEST(SmallStates, AMotionHasNoRatesOfItsOwn) {
  const std::string under_motion = state("dw1", "0", LawsAssumed::motion);
  EXPECT_THAT(under_motion, HasSubstr("N = "));
  EXPECT_THAT(under_motion, Not(HasSubstr("ω̇")));
  const std::string without_torque = state("dw1", "0", LawsAssumed::free);
  EXPECT_THAT(without_torque, HasSubstr(", N = 0"));
  EXPECT_THAT(without_torque, HasSubstr("I = (2, 3, 4), ω = (0, 1, 1)"));
  EXPECT_THAT(state("ddt(v)", "0", LawsAssumed::identity), HasSubstr("dv/dt = "));
  EXPECT_THAT(state("ddt(v)", "0", LawsAssumed::motion), HasSubstr("F = "));
}

TEST(SmallStates, OfAPremiseItHoldsAndTheConclusionFails) {
  const Equality premise = equality("w1", "0"), conclusion = equality("w2", "0");
  const auto found = first_whole_number_state(conclusion, &premise, LawsAssumed::motion);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->state, "ω = (0, 1, 0)");
  const Equality never = equality("1", "2");
  EXPECT_FALSE(first_whole_number_state(conclusion, &never, LawsAssumed::motion));
}

// VERIFY A4: these were taken to follow, perhaps, because the premise held in no state that was tried.
TEST(SmallStates, OfAPremiseThatSeldomHoldsOneIsFound) {
  const struct {
    const char *left, *right, *left_behind, *right_behind;
  } kInferences[] = {{"dot(A, v)", "dot(A, F)", "v", "F"}, {"w1^2", "4", "w1", "2"}, {"T", "7", "w1", "1"}};
  for (const auto& one : kInferences) {
    const Equality premise = equality(one.left, one.right),
                   conclusion = equality(one.left_behind, one.right_behind);
    EXPECT_TRUE(first_whole_number_state(conclusion, &premise, LawsAssumed::motion))
        << one.left << " = " << one.right;
  }
}

// A body in which Jzz − Jyy is 1 whatever one tries would hide a factor.
TEST(SmallStates, NoDifferenceOfMomentsIsTheSameInAll) {
  for (const char* difference : {"I1 - I2", "I2 - I3", "I3 - I1", "Jxx - Jyy", "Jyy - Jzz", "Jzz - Jxx"})
    for (const char* number : {"1", "-1", "2", "-2", "0"})
      EXPECT_TRUE(first(difference, number, LawsAssumed::identity)) << difference << " = " << number;
  for (const char* product : {"Jxy", "Jxz", "Jyz", "m", "w1", "N2", "dw3", "comp(A, 1)", "comp(F, 2)"})
    for (const char* number : {"0", "1", "2"})
      EXPECT_TRUE(first(product, number, LawsAssumed::identity)) << product << " = " << number;
}

TEST(SmallStates, TellsEveryTwoQuantitiesApart) {
  for (const QuantityFacts& a : kQuantities)
    for (const QuantityFacts& b : kQuantities) {
      if (a.type != b.type || a.quantity == b.quantity) continue;
      const std::string name(a.name), other(b.name);
      for (const char* factor : {"", "-", "2*", "0.5*"})
        EXPECT_TRUE(first(name.c_str(), (factor + other).c_str(), LawsAssumed::identity))
            << name << " = " << factor << other;
    }
}

// I = (2, 3, 4) and so on can be bodies, J too: no moment is larger than the other two.
TEST(SmallStates, BodiesArePossible) {
  for (const char* excess : {"I1 - I2 - I3", "I2 - I3 - I1", "I3 - I1 - I2"})
    for (const char* positive : {"1", "2", "3", "4", "5", "6"}) {
      const Equality premise = equality(excess, positive), anything = equality("w1", "w2");
      EXPECT_FALSE(first_whole_number_state(anything, &premise, LawsAssumed::identity)) << excess << positive;
    }
}

}  // namespace
}  // namespace polhode
