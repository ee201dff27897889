// SPDX-License-Identifier: MIT
#include "lessons/notation/typed/typed_formula.h"

#include "lessons/claims/proof/proof.h"
#include "lessons/notation/tex_equation.h"
#include "lessons/notation/typed/expression_typing.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;

const TypedNames kNoNames;

std::string tex(std::string_view typed) {
  const TypedFormula formula = typed_formula(typed, kNoNames);
  return formula.fault ? "? " + formula.fault->message : formula.tex;
}

TEST(TypedFormula, IsSetAsItIsTyped) {
  struct Case {
    const char *typed, *tex;
  };
  for (const Case& one :
       {Case{"dL/dt = N", R"(\frac{d\vec L}{dt} = \vec N)"},
        Case{"d*L/dt + w x L = N", R"(\frac{d^*\vec L}{dt} + \vec\omega\times \vec L = \vec N)"},
        Case{"I omega' = N", R"(\mathbf I\cdot \dot{\vec\omega} = \vec N)"},
        Case{"I2 w2' = N2", R"(I_{2}\,\dot{\omega}_{2} = N_{2})"},
        Case{"dw1 = w_1 ω₂", R"(\dot{\omega}_{1} = \omega_{1}\,\omega_{2})"},
        Case{"1/2 I1 w1^2", R"(\frac{1}{2}\,I_{1}\,\omega_{1}^{2})"},
        Case{"(I1 - I3)/I2*w1", R"(\frac{I_{1} - I_{3}}{I_{2}}\,\omega_{1})"},
        Case{"|L|² = L · L", R"(\left|\vec L\right|^{2} = \vec L\cdot \vec L)"},
        Case{"d|L|^2/dt", R"(\frac{d}{dt}\left(\left|\vec L\right|^{2}\right))"},
        Case{"= 2*3 T", R"(= 2\cdot 3\,T)"}, Case{"I1w1", R"(I_{1}\,\omega_{1})"},
        Case{"comp(w x L, 2)", R"(\left(\vec\omega\times \vec L\right)_{2})"}})
    EXPECT_EQ(tex(one.typed), one.tex) << one.typed;
}

TEST(TypedFormula, WhatIsNotReadIsSaidOnce) {
  struct Case {
    const char *typed, *fault;
    std::size_t at;
  };
  for (const Case& one :
       {Case{"L = ", "something is missing", 4}, Case{"(L + N = 0", "the bracket is not closed", 7},
        Case{"wxL = 0", "there is no \"wxL\"", 0}, Case{"a/b c", "there is no \"a\"", 0},
        Case{"L1/I1 w1", "does this stand below the line", 6},
        Case{"w1 + - w2", "two signs stand in a row", 5}, Case{"w1^w2", "a power is a whole number", 3},
        Case{"w1) = 0", "closed that was not opened", 2}, Case{"L # N", "not read: \"#\"", 2},
        Case{"cross(L) = 0", "takes two arguments", 7}}) {
    const TypedFormula formula = typed_formula(one.typed, kNoNames);
    ASSERT_TRUE(formula.fault) << one.typed;
    EXPECT_THAT(formula.fault->message, HasSubstr(one.fault)) << one.typed;
    EXPECT_EQ(formula.fault->at, one.at) << one.typed;
  }
}

// What is shown while a line grows is TeX, whatever stands there.
TEST(TypedFormula, EveryBeginningOfALineCanBeSet) {
  for (const std::string line :
       {"d*L/dt + w x (I omega) = N", "|L|^2 = (I1 w1)^2 + (I2 w2)^2", "ddt(cross(w, L)) = star(comp(L, 2))",
        "d(1/2 I1 w1^2)/dt = I1 w1 w1' - ((((", "1/(2/(3/(4 - |w|)))", "d/dt d/dt d*/dt L'' = T'''",
        "))((||^^''//dt", "I_{2} w_{2}' = N_{2}"})
    for (std::size_t n = 0; n <= line.size(); ++n) {
      const TypedFormula formula = typed_formula(line.substr(0, n), kNoNames);
      EXPECT_TRUE(parse_math(formula.tex)) << line.substr(0, n) << '\n' << formula.tex;
    }
}

TEST(TypedFormula, LinesAndBracketsHaveAnEnd) {
  EXPECT_THAT(tex(std::string(kMaxTypedBytes + 1, '1')), HasSubstr("at most"));
  EXPECT_THAT(tex(std::string(100, '(') + "1" + std::string(100, ')')), HasSubstr("nested too deep"));
}

TEST(TypedFormula, KnowsTheSymbolsOfTheLesson) {
  const TypedNames names = {{"kappa", "\\kappa"}, {"omega", "\\boldsymbol\\omega"}, {"s2", "\\sigma^2"}};
  EXPECT_EQ(typed_formula("kappa w", names).tex, R"(\kappa\,\boldsymbol\omega)");
  EXPECT_EQ(typed_formula("s2^2", names).tex, R"(\left(\sigma^2\right)^{2})");
}

TEST(TypedFormula, PlacesInTheTexAreThoseOfWhatWasTyped) {
  const TypedFormula formula = typed_formula("L + w x N", kNoNames);
  EXPECT_EQ(typed_offset(formula, formula.tex.find("\\vec N")), 8u);
  EXPECT_EQ(typed_offset(formula, formula.tex.find("\\vec\\omega")), 4u);
}

// What is quoted back is typed as learners type, and means the same.
TEST(TypingOf, ReadsBackAsTheSame) {
  for (const char* text :
       {"cross(omega, inertia(omega))", "I1*dw1 + (I3 - I2)*w2*w3", "-(w1 - w2)*(2*w3)", "norm2(L)/(2*I3)",
        "star(cross(omega, L))", "ddt(norm2(L))", "dot(L, cross(omega, N))", "comp(cross(omega, L), 2)",
        "(w1/I2)^2*(-1)", "w1*(w2*3)", "ddt(omega)", "inertia(star(omega))", "w1 - (w2 - w3)"}) {
    const SourceText source(text);
    Report report(source, "");
    const auto expression = read_expression(text, {1, 1}, report);
    ASSERT_TRUE(expression) << text;
    const std::string typed = typing_of(*expression, static_cast<int>(expression->nodes.size()) - 1);
    const TypedFormula formula = typed_formula(typed + " = " + typed, kNoNames);
    EXPECT_FALSE(formula.fault) << typed;
    const auto math = parse_math(formula.tex);
    ASSERT_TRUE(math) << formula.tex;
    const auto read = read_equation(*math, EquationNotation());
    ASSERT_TRUE(read) << typed << ": " << read.error().reason;
    const Equality same{read->sentences.front().links.front().equality.left, *expression};
    EXPECT_EQ(Prover().settle(same, LawsAssumed::identity), Verdict::holds) << text << " is typed " << typed;
  }
}

}  // namespace
}  // namespace polhode
