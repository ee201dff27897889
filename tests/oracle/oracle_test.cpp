// SPDX-License-Identifier: MIT
// The oracle knows mechanics by itself.
#include "tests/oracle/oracle.h"

#include "tests/oracle/term.h"

#include <gtest/gtest.h>

namespace polhode::oracle {
namespace {

Decision decision(LawsAssumed assumption, const char* left, const char* right) {
  return Oracle(assumption).compare(equality_from(left, right).value());
}

TEST(Oracle, KnowsWhatHoldsWhen) {
  using A = LawsAssumed;
  constexpr auto kSame = Decision::same, kDifferent = Decision::different;
  EXPECT_EQ(decision(A::identity, "ddt(A)", "star(A) + cross(omega, A)"), kSame);
  EXPECT_EQ(decision(A::identity, "ddt(A)", "star(A) - cross(omega, A)"), kDifferent);
  EXPECT_EQ(decision(A::identity, "ddt(L)", "N"), kDifferent);
  EXPECT_EQ(decision(A::motion, "ddt(L)", "N"), kSame);
  EXPECT_EQ(decision(A::motion, "I1*dw1 + w2*w3*(I3 - I2)", "N1"), kSame);
  EXPECT_EQ(decision(A::motion, "I1*dw1 + w2*w3*(I2 - I3)", "N1"), kDifferent);
  EXPECT_EQ(decision(A::motion, "ddt(T)", "0"), kDifferent);
  EXPECT_EQ(decision(A::free, "ddt(T)", "0"), kSame);
  EXPECT_EQ(decision(A::free, "ddt(norm2(L))", "0"), kSame);
  EXPECT_EQ(decision(A::free, "star(L)", "0"), kDifferent);
  EXPECT_EQ(decision(A::motion, "ddt(p)", "F"), kSame);
  EXPECT_EQ(decision(A::motion, "ddt(ddt(L))", "ddt(N)"), kSame);
  EXPECT_EQ(decision(A::free, "ddt(ddt(e3))", "cross(ddt(omega), e3) + cross(omega, cross(omega, e3))"),
            kSame);
  EXPECT_EQ(decision(A::identity, "ddt(ddt(A))", "star(star(A))"), kDifferent);
  EXPECT_EQ(decision(A::identity, "star(ddt(A))", "ddt(ddt(A)) - cross(omega, ddt(A))"), kSame);
}

TEST(Oracle, DividesWhereItCan) {
  constexpr auto kAny = LawsAssumed::identity;
  EXPECT_EQ(decision(kAny, "T/T", "1"), Decision::same);
  EXPECT_EQ(decision(kAny, "1/(w1 + w2) + 1/(w1 - w2)", "2*w1/(w1^2 - w2^2)"), Decision::same);
  EXPECT_EQ(decision(kAny, "1/(w1 + w2)", "1/w1 + 1/w2"), Decision::different);
  EXPECT_EQ(decision(kAny, "1/(w1*(w2 + w3) - w1*w2 - w1*w3)", "1"), Decision::undefined);
  EXPECT_EQ(decision(kAny, "0*(w1 - w1)^(-1)", "0"), Decision::undefined);
}

}  // namespace
}  // namespace polhode::oracle
