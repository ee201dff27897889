// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression_builder.h"

#include "lessons/claims/claim_state.h"
#include "tests/lessons/claims/claim_examples.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;

using Field = FieldElement;
using Row = std::vector<Field>;

std::vector<std::string> faults(const std::string& expression) {
  TextReport at(expression);
  const bool ok = read_expression(expression, {1, 1}, at.report).has_value();
  auto lines = at.lines();
  EXPECT_EQ(ok, lines.empty()) << expression;
  return lines;
}

Expression expression(const std::string& text) { return testing::equality(text, "0").left; }

TEST(ExpressionBuilder, GivesEachNodeItsType) {
  using T = ExpressionType;
  const std::vector<std::pair<const char*, T>> kTypes = {{"0", T::zero},
                                                         {"0.0*0", T::zero},
                                                         {"0*T", T::scalar},
                                                         {"0*L", T::vector},
                                                         {"0 + L", T::vector},
                                                         {"0 - T", T::scalar},
                                                         {"-0", T::zero},
                                                         {"L/2", T::vector},
                                                         {"dot(L, N)", T::scalar},
                                                         {"cross(L, N)", T::vector},
                                                         {"norm2(0)", T::scalar},
                                                         {"ddt(T)", T::scalar},
                                                         {"ddt(L)", T::vector},
                                                         {"star(0)", T::vector},
                                                         {"comp(L, 1)", T::scalar},
                                                         {"trace(J)", T::scalar},
                                                         {"apply(J, A)", T::vector},
                                                         {"inertia(A)", T::vector},
                                                         {"w1^0", T::scalar},
                                                         {"0/T", T::zero}};
  for (const auto& [text, type] : kTypes) EXPECT_EQ(expression(text).type(), type) << text;
}

TEST(ExpressionBuilder, RefusesWhatHasNoMeaningWhereItStands) {
  EXPECT_THAT(faults("T + L"), ElementsAre("1:3: error: a scalar and a vector cannot be added"));
  EXPECT_THAT(faults("L*N"), ElementsAre("1:2: error: which product of two vectors? (write dot(a, b) or "
                                         "cross(a, b))"));
  EXPECT_THAT(faults("T/L"),
              ElementsAre("1:2: error: nothing can be divided by a vector (divide by norm2(v), "
                          "or by a component)"));
  EXPECT_THAT(faults("L^2"), ElementsAre("1:2: error: a vector has no powers (write norm2(v) for v·v)"));
  EXPECT_THAT(faults("cross(L, w1)"), ElementsAre("1:10: error: \"cross\" takes vectors, this is a scalar"));
  EXPECT_THAT(faults("inertia(2)"), ElementsAre("1:9: error: \"inertia\" takes vectors, this is a scalar"));
  EXPECT_THAT(faults("star(T)"), ElementsAre("1:6: error: \"star\" takes vectors, this is a scalar"));
  EXPECT_THAT(faults("comp(T, 1)"), ElementsAre("1:6: error: \"comp\" takes vectors, this is a scalar"));
  for (const char* without_rate : {"ddt(N)", "star(F)", "star(ddt(L))", "ddt(ddt(A))", "cross(L, ddt(N))",
                                   "2*ddt(N) + A", "inertia(ddt(ddt(L)))", "ddt(dw1)*A"})
    for (const char* rate : {"ddt", "star"})
      EXPECT_THAT(faults(std::string(rate) + "(" + without_rate + ")"),
                  ElementsAre("1:" + std::to_string(std::string(rate).size() + 2) +
                              ": error: the rate of change of this is not known (derivatives are at most "
                              "second ones, of ω̇, N and F first ones)"));
  for (const char* scalar : {"dw1", "N2", "dot(N, L)", "ddt(T)", "comp(F, 1)", "T/N1", "dw1^2"}) {
    EXPECT_THAT(faults("ddt(" + std::string(scalar) + ")"), IsEmpty()) << scalar;
    EXPECT_FALSE(faults("ddt(ddt(" + std::string(scalar) + "))").empty()) << scalar;
  }
}

TEST(ExpressionBuilder, PutsAVectorSecondInAProduct) {
  for (const char* text : {"L*T", "T*L"}) {
    const Expression product = expression(text);
    const ExpressionNode& node = product.nodes.back();
    EXPECT_EQ(product.nodes[static_cast<std::size_t>(node.b)].quantity, Quantity::L) << text;
  }
}

TEST(ExpressionBuilder, BoundsExponentsAndDegrees) {
  EXPECT_THAT(faults("T^16"), IsEmpty());
  EXPECT_THAT(faults("T^-16"), IsEmpty());
  EXPECT_THAT(faults("T^17"), ElementsAre("1:3: error: an exponent is a whole number, at most 16"));
  EXPECT_THAT(faults("(w1^16)^16"), IsEmpty());
  EXPECT_THAT(faults("((w1^16)^16)^16"), IsEmpty()) << "of degree 4096";
  EXPECT_THAT(
      faults("((w1^16)^16)^16*w1"),
      ElementsAre("1:16: error: the degree of this exceeds 4096 (too many factors or divisions are nested "
                  "here)"));
  EXPECT_FALSE(faults("((w1^-16)^16)^16*(1/w1)").empty()) << "denominators count";
}

/// A state on a line through the space of all that can vary.
ClaimState<Field> state_on_line(Field s, LawsAssumed laws) {
  StateNumbers<Field> a = testing::random_numbers(1);
  const StateNumbers<Field> b = testing::random_numbers(2);
  const auto move = [s](auto& from, const auto& direction) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = from[i] + s * direction[i];
  };
  move(a.q, b.q);
  move(a.I, b.I);
  move(a.J, b.J);
  move(a.w, b.w);
  move(a.dw, b.dw);
  move(a.v_S, b.v_S);
  move(a.dv_S, b.dv_S);
  move(a.A_S, b.A_S);
  move(a.dA_S, b.dA_S);
  move(a.N_B, b.N_B);
  move(a.F_S, b.F_S);
  move(a.ddw, b.ddw);
  move(a.ddv_S, b.ddv_S);
  move(a.ddA_S, b.ddA_S);
  move(a.dN_B, b.dN_B);
  move(a.dF_S, b.dF_S);
  a.m = a.m + s * b.m;
  a.h = a.h + s * b.h;
  a.k = a.k + s * b.k;
  return state_of(a, laws);
}

std::size_t rank_of(std::vector<Row> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; column < rows.front().size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column].is_zero()) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    const Field reciprocal = inverse(rows[rank][column]);
    for (std::size_t r = rank + 1; r < rows.size(); ++r) {
      const Field factor = rows[r][column] * reciprocal;
      if (factor.is_zero()) continue;
      for (std::size_t c = column; c < rows[r].size(); ++c) rows[r][c] = rows[r][c] - factor * rows[rank][c];
    }
    if (++rank == rows.size()) break;
  }
  return rank;
}

/// Whether f = P/Q on that line with deg P ≤ n and deg Q ≤ d: whether there are P and Q, not both 0, such
/// that P − f Q = 0 at more points than they have coefficients.
bool has_degree(const std::string& text, std::size_t component, const Degree& degree, LawsAssumed laws) {
  const auto n = static_cast<std::size_t>(degree.numerator), d = static_cast<std::size_t>(degree.denominator);
  const std::size_t unknowns = n + d + 2;
  const Expression read = expression(text);
  std::vector<Row> rows;
  for (std::size_t point = 0; point < unknowns + 4; ++point) {
    const Field s(static_cast<std::int64_t>(1000 + 77 * point));
    const auto state = state_on_line(s, laws);
    ComponentJets<Field> value;
    if (!Evaluation<Field>(state)(read, value)) return false;
    Row row(unknowns);
    Field power(1);
    for (std::size_t i = 0; i <= std::max(n, d); ++i, power = power * s) {
      if (i <= n) row[i] = power;
      if (i <= d) row[n + 1 + i] = -(value[component].value * power);
    }
    rows.push_back(std::move(row));
  }
  return rank_of(std::move(rows)) < unknowns;
}

// The error bound of proof.h stands on these.
TEST(ExpressionBuilder, NoDegreeIsLargerThanItsBound) {
  auto texts = testing::example_expressions();
  texts.insert(texts.end(), testing::example_quotients().begin(), testing::example_quotients().end());
  for (const QuantityFacts& facts : kQuantities) texts.emplace_back(facts.name);
  for (const char* rate : {"ddt(norm2(v)*w1*w2*w3)", "ddt(w1/m)", "star(dot(v, A)*omega)",
                           "ddt(w1*w2*w3*comp(v, 1))", "ddt(1/(w1*w2*w3*comp(p, 1)))"})
    texts.emplace_back(rate);
  for (const std::string& text : texts) {
    const Expression read = expression(text);
    const std::size_t components = read.type() == ExpressionType::vector ? 3 : 1;
    for (const LawsAssumed laws : {LawsAssumed::identity, LawsAssumed::motion, LawsAssumed::free})
      for (std::size_t i = 0; i < components; ++i)
        EXPECT_TRUE(has_degree(text, i, read.nodes.back().degree, laws))
            << text << " has not " << read.nodes.back().degree.numerator << " over "
            << read.nodes.back().degree.denominator;
  }
}

TEST(ExpressionBuilder, TheTestOfDegreesCanFail) {
  EXPECT_TRUE(has_degree("w1^3/w2^2", 0, {3, 2}, LawsAssumed::identity));
  EXPECT_FALSE(has_degree("w1^3/w2^2", 0, {2, 2}, LawsAssumed::identity));
  EXPECT_FALSE(has_degree("w1^3/w2^2", 0, {3, 1}, LawsAssumed::identity));
}

}  // namespace
}  // namespace polhode
