// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression_tex.h"

#include "lessons/claims/proof/proof.h"
#include "lessons/notation/tex_equation.h"
#include "lessons/reader/reader.h"
#include "tests/lessons/claims/claim_examples.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

Expression expression_from(const std::string& text) {
  const SourceText source(text);
  Report report(source, "test");
  auto expression = read_expression(text, {1, 1}, report);
  if (!expression) throw std::invalid_argument(text);
  return *expression;
}

std::string printed(const std::string& text) { return tex_of(expression_from(text)); }

TEST(TexOfAnExpression, IsWhatALecturerWrites) {
  EXPECT_EQ(printed("2*T"), R"(2\,T)");
  EXPECT_EQ(printed("dot(omega, inertia(omega))"), R"(\vec\omega\cdot \mathbf I\cdot \vec\omega)");
  EXPECT_EQ(printed("(I1 - I2)*w1*w2"), R"((I_1 - I_2)\,\omega_1\,\omega_2)");
  EXPECT_EQ(printed("I1*dw1 - 2*3"), R"(I_1\,\dot\omega_1 - 2\cdot 3)");
  EXPECT_EQ(printed("ddt(L) - cross(omega, inertia(omega))"),
            R"(\frac{d\vec L}{dt} - \vec\omega\times (\mathbf I\cdot \vec\omega))");
  EXPECT_EQ(printed("star(L + A)/2"), R"(\frac{\frac{d^*(\vec L + \vec A)}{dt}}{2})");
  EXPECT_EQ(printed("comp(A, 1)*norm2(L)^2"), R"(A_1\,(|\vec L|^2)^{2})");
  EXPECT_EQ(printed("1e-9*norm(N)"), R"(1\cdot 10^{-9}\,|\vec N|)");
  EXPECT_EQ(printed("-(T - m)"), "-(T - m)");
  EXPECT_EQ(printed("T - (m - T)"), "T - (m - T)");
  EXPECT_EQ(printed("T + (-m)"), "T + (-m)");
  EXPECT_EQ(printed("2*(3/4)*T"), R"(2\cdot \frac{3}{4}\,T)");
  EXPECT_EQ(printed("cross(omega, 2*cross(L, A))"), R"(\vec\omega\times (2\,\vec L\times \vec A))");
}

TEST(TexOfALine, SaysWhatDoesNotFollow) {
  const auto equality = [](const char* left, const char* right) {
    return Equality{expression_from(left), expression_from(right)};
  };
  ClaimLine line;
  line.equality = equality("T", "m");
  EXPECT_EQ(tex_of(line, ClaimKind::identity), "T = m");
  line.conclusion = equality("N", "0");
  EXPECT_EQ(tex_of(line, ClaimKind::motion), R"(T = m\;\Rightarrow\;\vec N = 0)");
  EXPECT_EQ(tex_of(line, ClaimKind::non_sequitur), R"(T = m\;\not\Rightarrow\;\vec N = 0)");
}

/// Read as a printed equation of a lesson, side by side with itself.
void expect_same_function(const Expression& expression, EquationNotation notation = {}) {
  SCOPED_TRACE(expression.text);
  const std::string side = tex_of(expression, &notation.vocabulary), tex = side + " = " + side;
  SCOPED_TRACE(tex);
  const auto math = parse_math(tex);
  ASSERT_TRUE(math.ok());
  for (const std::string name : {"h", "k"}) notation.symbols.push_back({name, *parse_math(name), name});
  notation.symbols.push_back({"J", *parse_math(R"(\mathbf J)"), "J"});
  const auto read = read_equation(*math, notation);
  ASSERT_TRUE(read.ok()) << read.error().reason;
  ASSERT_EQ(read->sentences.size(), 1U);
  const Expression& back = read->sentences[0].links.at(0).equality.left;
  ASSERT_EQ(back.type(), expression.type());
  const Equality same{back, expression};
  EXPECT_EQ(Prover().settle(same, LawsAssumed::identity), Verdict::holds);
}

void expect_same_function(const std::string& text) { expect_same_function(expression_from(text)); }

TEST(TexOfAnExpression, IsReadAsTheSameFunction) {
  for (const auto* examples : {&testing::example_expressions(), &testing::example_quotients()})
    for (const std::string& text : *examples)
      if (text.find("Jxx") == std::string::npos) expect_same_function(text);
}

TEST(TexOfAnExpression, KeepsTogetherWhatIsScaled) {
  for (const char* text :
       {"cross(omega, 2*cross(L, N))", "cross(2*cross(omega, L), N)", "cross(omega, T*cross(L, N))",
        "inertia(T*cross(omega, L))", "inertia(-1*cross(L, omega))", "2*(3/4)*T", "3*(1/2)*T", "trace(J)*T",
        "dot(omega, 2*cross(L, N))", "T*dot(omega, L)*m", "-(2*cross(omega, L))",
        "cross(omega, -cross(L, N))"})
    expect_same_function(text);
}

TEST(TexOfAnExpression, OfEveryClaimOfTheLessonsIsReadAsTheSameFunction) {
  int count = 0;
  for (const std::string id :
       {"euler-equations", "symmetric-top", "intermediate-axis", "heavy-top", "numerical-lab"}) {
    const auto reading = read_lesson(testing::read_file(test::source_dir() / "lessons" / (id + ".md")), id);
    ASSERT_TRUE(reading.lesson);
    for (const Stage& stage : reading.lesson->stages)
      for (const Step& step : stage.steps)
        for (const Claim* claim : blocks_of<Claim>(step)) {
          if (claim->kind == ClaimKind::measured) continue;  // it may have roots and angles: no proof has
          for (const ClaimLine& line : claim->lines)
            for (const Expression* side : {&line.equality.left, &line.equality.right}) {
              const bool has_components = side->text.find("Jx") != std::string::npos ||
                                          side->text.find("Jy") != std::string::npos ||
                                          side->text.find("Jz") != std::string::npos;
              if (side->text == "0" || side->uses(Operation::norm) || has_components) continue;
              expect_same_function(*side, reading.lesson->notation);
              ++count;
            }
        }
  }
  EXPECT_GT(count, 200);
}

}  // namespace
}  // namespace polhode
