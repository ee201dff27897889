// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TextReport;

std::vector<std::string> faults(const std::string& expression) {
  TextReport at(expression);
  const bool ok = read_expression(expression, {1, 1}, at.report).has_value();
  auto lines = at.lines();
  EXPECT_EQ(ok, lines.empty()) << expression;
  return lines;
}

TEST(Expression, TakesEveryNameAndForm) {
  for (const char* text : {"0",
                           "1.5e-3",
                           ".5",
                           "2.",
                           "-T",
                           "+-w1",
                           "w3*w1*(I1 - I3)",
                           "ddt(L)",
                           "star(L) + cross(omega, L)",
                           "dot(omega, inertia(omega))/2",
                           "norm2(p)",
                           "apply(J, v)",
                           "comp(L, 1)",
                           "trace(J)^2",
                           "((w1))",
                           "Jxy + Jxz + Jyz",
                           "e1 + e2 - e3",
                           "I1*dw1",
                           "m * v",
                           " A "}) {
    EXPECT_THAT(faults(text), IsEmpty()) << text;
  }
  for (const std::string& symbol : expression_symbols()) {
    const std::string text = symbol == "J" ? "trace(J)" : symbol;
    EXPECT_THAT(faults(text), IsEmpty()) << text;
  }
}

TEST(Expression, ReportsWhatIsWrongAndWhere) {
  EXPECT_THAT(faults(""), ElementsAre("1:1: error: an expression is missing here"));
  EXPECT_THAT(faults("w1 +"), ElementsAre("1:5: error: an expression is missing here"));
  EXPECT_THAT(faults("w1 w2"),
              ElementsAre("1:4: error: an operator is missing before this (write * between factors)"));
  EXPECT_THAT(faults("w1 + w4"), ElementsAre("1:6: error: unknown symbol \"w4\" (did you mean \"w1\"?)"));
  EXPECT_THAT(faults("w1 - (w2"), ElementsAre("1:6: error: this ( is never closed"));
  EXPECT_THAT(faults("w1)"), ElementsAre("1:3: error: this ) closes nothing"));
  EXPECT_THAT(faults("corss(L, N)"),
              ElementsAre("1:1: error: unknown function \"corss\" (did you mean \"cross\"?)"));
  EXPECT_THAT(faults("2*cross(L)"), ElementsAre("1:3: error: \"cross\" takes 2 arguments, found 1"));
  EXPECT_THAT(faults("ddt(L, N)"), ElementsAre("1:1: error: \"ddt\" takes 1 argument, found 2"));
  EXPECT_THAT(faults("dot(L, )"), ElementsAre("1:8: error: an expression is missing here"));
  EXPECT_THAT(faults("dot()"), ElementsAre("1:5: error: an expression is missing here"));
  EXPECT_THAT(faults("ddt + 1"), ElementsAre("1:1: error: \"ddt\" is a function (write ddt(…))"));
  EXPECT_THAT(faults("L(1)"), ElementsAre("1:1: error: \"L\" is no function (write * between factors)"));
  EXPECT_THAT(faults("1, 2"),
              ElementsAre("1:2: error: a comma stands between the arguments of a function only"));
  EXPECT_THAT(faults("ω×L"), ElementsAre("1:1: error: unknown character \"ω\""));
  EXPECT_THAT(faults("L × N"), ElementsAre("1:3: error: unknown character \"×\" (write cross(a, b))"));
  EXPECT_THAT(faults("."), ElementsAre("1:1: error: a number needs digits"));
  EXPECT_THAT(faults("2e"), SizeIs(1));
  EXPECT_THAT(faults("* L"), ElementsAre("1:1: error: an expression is missing here"));
}

TEST(Expression, TakesBracketsOfTheLimitAndNoDeeper) {
  const std::string open(kMaxExpressionNesting, '(');
  const std::string close(kMaxExpressionNesting, ')');
  EXPECT_THAT(faults(open + "L" + close), IsEmpty());
  EXPECT_THAT(faults("(" + open + "L" + close + ")"),
              ElementsAre("1:65: error: brackets are nested deeper than 64"));
}

}  // namespace
}  // namespace polhode
