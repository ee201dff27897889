// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/evaluation.h"

#include "lessons/claims/claim_state.h"
#include "lessons/claims/proof/proof.h"
#include "tests/lessons/claims/claim_examples.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace polhode {
namespace {

using testing::equality;
using testing::example_expressions;
using testing::example_quotients;
using testing::random_numbers;
using Field = FieldElement;

template <class N>
ComponentJets<N> jets_in(const ClaimState<N>& state, const std::string& text) {
  Evaluation<N> evaluate(state);
  ComponentJets<N> value;
  EXPECT_TRUE(evaluate(equality(text, "0").left, value)) << text;
  return value;
}

bool is_vector(const std::string& text) { return equality(text, "0").left.type() == ExpressionType::vector; }

/// Hamilton's product.
std::array<Field, 4> product(const std::array<Field, 4>& a, const std::array<Field, 4>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

std::array<Field, 3> turned(const std::array<ComponentJets<Field>, 3>& G, const std::array<Field, 3>& x) {
  std::array<Field, 3> y;
  for (std::size_t i = 0; i < 3; ++i)
    y[i] = G[i][0].value * x[0] + G[i][1].value * x[1] + G[i][2].value * x[2];
  return y;
}

class EvaluationUnder : public ::testing::TestWithParam<LawsAssumed> {};

// Body, axes and vectors of space turned by g together: scalars do not change, vectors turn with them.
TEST_P(EvaluationUnder, ATurnOfEverythingTurnsVectorsAndNoScalar) {
  const StateNumbers<Field> numbers = random_numbers(11);
  const std::array<Field, 4> g = {Field(3), Field(-1), Field(4), Field(-2)};
  const auto G = attitude_matrix(turning(g, {Field(0), Field(0), Field(0)}, {Field(0), Field(0), Field(0)}));
  StateNumbers<Field> other = numbers;
  other.q = product(g, numbers.q);
  for (auto* vector : {&other.v_S, &other.dv_S, &other.ddv_S, &other.A_S, &other.dA_S, &other.ddA_S,
                       &other.F_S, &other.dF_S})
    *vector = turned(G, *vector);
  const auto before = state_of(numbers, GetParam()), after = state_of(other, GetParam());
  auto texts = example_expressions();
  texts.insert(texts.end(), example_quotients().begin(), example_quotients().end());
  for (const std::string& text : texts) {
    const auto a = jets_in(before, text), b = jets_in(after, text);
    std::array<Field, 3> want = {a[0].value, a[1].value, a[2].value};
    if (is_vector(text)) want = turned(G, want);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(b[i].value, want[i]) << text;
  }
}

// Quaternions of quarter and third turns give whole numbers, and so does all without a division but T, whose
// ½ is gone in 2T: the doubles are exact, and the field must have the same numbers, rates too.
TEST_P(EvaluationUnder, TheFieldAndTheDoublesGiveTheSameWholeNumbers) {
  using Numbers = std::array<int, 4>;
  for (const Numbers& q :
       {Numbers{1, 0, 0, 0}, Numbers{1, 0, 0, 1}, Numbers{1, 1, 1, 1}, Numbers{0, 1, -1, 0}}) {
    const auto fill = [&q](auto& n) {
      using N = std::remove_reference_t<decltype(n.m)>;
      int next = 1;
      const auto some = [&next](auto& all) {
        for (auto& one : all) one = N((next = next * 5 % 17) - 8);
      };
      for (std::size_t i = 0; i < 4; ++i) n.q[i] = N(q[i]);
      some(n.J);
      for (auto* vector : {&n.w, &n.dw, &n.v_S, &n.dv_S, &n.A_S, &n.dA_S, &n.N_B, &n.F_S, &n.ddw, &n.ddv_S,
                           &n.ddA_S, &n.dN_B, &n.dF_S})
        some(*vector);
      n.I = {N(1), N(-1), N(1)};  // no body, but what divides by them stays whole
      n.m = N(-1);
    };
    StateNumbers<Field> exact;
    StateNumbers<SizedNumber> real;
    fill(exact);
    fill(real);
    const auto exact_state = state_of(exact, GetParam());
    const auto real_state = state_of(real, GetParam());
    for (const std::string& text : example_expressions()) {
      const std::string whole = "4*(" + text + ")";
      const auto a = jets_in(exact_state, whole);
      const auto b = jets_in(real_state, whole);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(b[i].value.value, std::nearbyint(b[i].value.value)) << whole;
        EXPECT_EQ(a[i].value, Field(std::llround(b[i].value.value))) << whole;
        EXPECT_EQ(a[i].rate, Field(std::llround(b[i].rate.value))) << whole << ", rate";
        EXPECT_EQ(a[i].second, Field(std::llround(b[i].second.value))) << whole << ", second rate";
      }
    }
  }
}

TEST_P(EvaluationUnder, OperationsAreLinearAndRatesKeepTheProductRules) {
  const auto state = state_of(random_numbers(5), GetParam());
  for (const auto& [left, right] : std::vector<std::pair<const char*, const char*>>{
           {"inertia(m*A - v)", "m*inertia(A) - inertia(v)"},
           {"apply(J, m*A - v)", "m*apply(J, A) - apply(J, v)"},
           {"cross(m*A - v, L)", "m*cross(A, L) - cross(v, L)"},
           {"cross(L, m*A - v)", "m*cross(L, A) - cross(L, v)"},
           {"dot(m*A - v, L)", "m*dot(A, L) - dot(v, L)"},
           {"comp(m*A - v, 2)", "m*comp(A, 2) - comp(v, 2)"},
           {"ddt(3*A - v)", "3*ddt(A) - ddt(v)"},
           {"star(3*A - v)", "3*star(A) - star(v)"},
           {"ddt(w1*A)", "ddt(w1)*A + w1*ddt(A)"},
           {"star(T*A)", "ddt(T)*A + T*star(A)"},
           {"ddt(w1*w2)", "dw1*w2 + w1*dw2"},
           {"ddt(cross(A, v))", "cross(ddt(A), v) + cross(A, ddt(v))"},
           {"star(cross(A, L))", "cross(star(A), L) + cross(A, star(L))"},
           {"ddt(dot(A, v))", "dot(ddt(A), v) + dot(A, ddt(v))"},
           {"ddt(dot(A, v))", "dot(star(A), v) + dot(A, star(v))"},
           {"ddt(norm2(L))", "2*dot(L, ddt(L))"},
           {"ddt(w1/w2)", "(dw1*w2 - w1*dw2)/w2^2"},
           {"ddt(w1^5)", "5*w1^4*dw1"},
           {"ddt(w1^(-3))", "-3*w1^(-4)*dw1"},
           {"ddt(A/T)", "ddt(A)/T - ddt(T)/T^2*A"},
           {"ddt(w1^0)", "0"},
           {"ddt(m*I1*trace(J)*0.3)", "0"},
           {"ddt(A)", "star(A) + cross(omega, A)"},
           {"star(inertia(A))", "inertia(star(A))"},
           {"star(apply(J, A))", "apply(J, star(A))"},
           {"star(e1)", "0"},
           {"ddt(ddt(A))",
            "star(star(A)) + 2*cross(omega, star(A)) + cross(star(omega), A) + cross(omega, cross(omega, "
            "A))"},
           {"ddt(ddt(w1*w2))", "ddt(dw1)*w2 + 2*dw1*dw2 + w1*ddt(dw2)"},
           {"ddt(ddt(w1))", "ddt(dw1)"},
           {"ddt(ddt(1/T))", "2*ddt(T)^2/T^3 - ddt(ddt(T))/T^2"},
           {"ddt(ddt(dot(A, v)))", "dot(ddt(ddt(A)), v) + 2*dot(ddt(A), ddt(v)) + dot(A, ddt(ddt(v)))"},
           {"ddt(N)", "star(N) + cross(omega, N)"},
           {"ddt(star(A))", "star(ddt(A)) + cross(omega, star(A)) - star(cross(omega, A))"}})
    EXPECT_EQ(agree(equality(left, right), state), std::optional(true)) << left << " = " << right;
}

INSTANTIATE_TEST_SUITE_P(All, EvaluationUnder,
                         ::testing::Values(LawsAssumed::identity, LawsAssumed::motion, LawsAssumed::free));

/// 1 → 2 → 3 → 1 in names, indices of comp and the letters of J.
std::string renamed_in_a_circle(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end]))) ++end;
    std::string word = text.substr(i, std::max<std::size_t>(end - i, 1));
    const bool is_name = word.size() > 1 && std::isalpha(static_cast<unsigned char>(word.front()));
    const bool is_index = i >= 2 && text[i - 2] == ',' && end < text.size() && text[end] == ')';
    char& last = word.back();
    if ((is_name || is_index) && last >= '1' && last <= '3')
      last = static_cast<char>('1' + (last - '1' + 1) % 3);
    if (is_name && word.size() == 3 && word.front() == 'J') {
      for (char* letter : {&word[1], &word[2]}) *letter = static_cast<char>('x' + (*letter - 'x' + 1) % 3);
      if (word[1] > word[2]) std::swap(word[1], word[2]);
    }
    result += word;
    i += word.size();
  }
  return result;
}

TEST(Evaluation, VerdictsStayWhenTheAxesAreRenamedInACircle) {
  ASSERT_EQ(renamed_in_a_circle("I1*dw3^2 - comp(e2, 3) + Jxz*Jzz"), "I2*dw1^2 - comp(e3, 1) + Jxy*Jxx");
  const Prover prover;
  for (const auto& [left, right] : std::vector<std::pair<std::string, std::string>>{
           {"I1*dw1 + w2*w3*(I3 - I2)", "N1"},
           {"I1*dw1 + w2*w3*(I2 - I3)", "N1"},
           {"I1*dw1 + w2*w3*(I3 - I2)", "0"},
           {"I1*dw1 + w1*w3*(I3 - I2)", "N1"},
           {"cross(e1, e2)", "e3"},
           {"cross(e2, e1)", "e3"},
           {"ddt(e1)", "w3*e2 - w2*e3"},
           {"ddt(e1)", "w2*e3 - w3*e2"},
           {"comp(cross(omega, apply(J, omega)), 1)",
            "w2*w3*(Jzz - Jyy) + Jyz*(w2^2 - w3^2) + w1*(Jxz*w2 - Jxy*w3)"},
           {"comp(cross(omega, apply(J, omega)), 1)",
            "w2*w3*(Jzz - Jyy) + Jyz*(w2^2 - w3^2) + w1*(Jxy*w2 - Jxz*w3)"},
           {"cross(omega, inertia(omega))", "w2*w3*(I3 - I2)*e1 + w3*w1*(I1 - I3)*e2 + w1*w2*(I2 - I1)*e3"},
           {"inertia(e1)", "I1*e1"},
           {"apply(J, e1)", "Jxx*e1 + Jxy*e2 + Jxz*e3"},
           {"comp(A, 1)*e1 + comp(A, 2)*e2", "A - comp(A, 3)*e3"},
           {"ddt(w1^2*I1)", "2*w1*(N1 - w2*w3*(I3 - I2))"},
           {"I2*w2*dw2", "w1*w2*w3*(I3 - I1)"}}) {
    std::string l = left, r = right;
    for (int turn = 0; turn < 2; ++turn) {
      l = renamed_in_a_circle(l);
      r = renamed_in_a_circle(r);
      for (const LawsAssumed laws : {LawsAssumed::identity, LawsAssumed::motion, LawsAssumed::free})
        EXPECT_EQ(prover.settle(equality(left, right), laws), prover.settle(equality(l, r), laws))
            << left << " = " << right << " as " << l << " = " << r;
    }
  }
}

TEST(Evaluation, NumbersAreExactInTheFieldAndRoundedOnceInDoubles) {
  const auto number = [](const char* text) { return equality(text, "0").left.nodes.front().number; };
  EXPECT_EQ(decimal<Field>(number("0.125")) * Field(8), Field(1));
  EXPECT_EQ(decimal<Field>(number("1e18")), Field(1'000'000'000'000'000'000));
  EXPECT_EQ(decimal<Field>(number("2.5e3")), Field(2500));
  EXPECT_EQ(decimal<SizedNumber>(number("0.1")).value, 0.1);
  EXPECT_EQ(decimal<SizedNumber>(number("3.3e-9")).value, 3.3e-9);
}

TEST(Evaluation, EveryWayToWriteANumberIsTheSameNumberInBoth) {
  const auto exact = state_of(random_numbers(1), LawsAssumed::identity);
  StateNumbers<SizedNumber> numbers;
  numbers.I = {SizedNumber(1), SizedNumber(2), SizedNumber(3)};
  const auto real = state_of(numbers, LawsAssumed::identity);
  for (const auto& [number, same] : std::vector<std::pair<const char*, const char*>>{{".5", "1/2"},
                                                                                     {"2.", "2"},
                                                                                     {"007.50e+2", "750"},
                                                                                     {"1E3", "1000"},
                                                                                     {"0.000", "0"},
                                                                                     {"5e-0", "5"},
                                                                                     {"0.25e-1", "1/40"}}) {
    EXPECT_EQ(agree(equality(number, same), exact), std::optional(true)) << number;
    EXPECT_EQ(sides_of(equality(number, same), real).value().residual, 0.0) << number;
  }
}

TEST(Evaluation, AtRestInSpaceItIsWhatOneWouldWrite) {
  StateNumbers<SizedNumber> n;
  n.I = {SizedNumber(2), SizedNumber(3), SizedNumber(4)};
  n.w = {SizedNumber(1), SizedNumber(2), SizedNumber(3)};
  n.J = {SizedNumber(1), SizedNumber(2), SizedNumber(3), SizedNumber(4), SizedNumber(5), SizedNumber(6)};
  n.A_S = {SizedNumber(1), SizedNumber(0), SizedNumber(-1)};
  const auto state = state_of(n, LawsAssumed::free);
  const auto values = [&state](const char* text) {
    const auto value = jets_in(state, text);
    return std::array{value[0].value.value, value[1].value.value, value[2].value.value};
  };
  EXPECT_EQ(values("L"), (std::array{2.0, 6.0, 12.0}));
  EXPECT_EQ(values("T"), (std::array{25.0, 0.0, 0.0}));
  EXPECT_EQ(values("cross(omega, L)"), (std::array{6.0, -6.0, 2.0}));
  EXPECT_EQ(values("star(omega)"), (std::array{-3.0, 2.0, -0.5}));
  EXPECT_EQ(values("apply(J, A)"), (std::array{1.0 - 3.0, 2.0 - 5.0, 3.0 - 6.0}));
  EXPECT_EQ(values("ddt(e1)"), (std::array{0.0, 3.0, -2.0}));
  EXPECT_EQ(values("comp(A, 3)"), (std::array{-1.0, 0.0, 0.0}));
}

// sqrt, sin, cos, acos, atan2, exp, log and their rates, beside central differences of the same functions.
TEST(Evaluation, FunctionsOfNumbersHaveTheRatesOfTheirCurves) {
  ClaimState<SizedNumber> state{};
  for (std::size_t i = 0; i < 3; ++i) state.R[i][i] = {1.0, 0.0};
  const double x = 0.3, dx = 0.7, ddx = -0.5, y = -0.4, dy = 0.2, ddy = 1.1;
  state.w_B = {{{x, dx, ddx}, {y, dy, ddy}, {0.0, 0.0}}};
  struct Case {
    const char* text;
    double (*of)(double, double);
  };
  const Case cases[] = {
      {"sqrt(w1)", [](double a, double) { return std::sqrt(a); }},
      {"sin(w1)", [](double a, double) { return std::sin(a); }},
      {"cos(w1 + w2)", [](double a, double b) { return std::cos(a + b); }},
      {"acos(w1)", [](double a, double) { return std::acos(a); }},
      {"cos(acos(w1))", [](double a, double) { return a; }},
      {"atan2(w1, w2)", [](double a, double b) { return std::atan2(a, b); }},
      {"exp(w1 + w2)", [](double a, double b) { return std::exp(a + b); }},
      {"log(w1)", [](double a, double) { return std::log(a); }},
      {"2*pi*w1", [](double a, double) { return 2 * std::acos(-1.0) * a; }},
  };
  const double h = 1e-5;  // errors: h²/6 of third derivatives below 100, and rounding over h
  for (const Case& c : cases) {
    const auto value = jets_in(state, c.text)[0];
    EXPECT_NEAR(value.value.value, c.of(x, y), 4e-16 * 4) << c.text;
    const double rate = (c.of(x + h * dx, y + h * dy) - c.of(x - h * dx, y - h * dy)) / (2 * h);
    EXPECT_NEAR(value.rate.value, rate, 100 * h * h / 6 + 8 * 2.3e-16 / h) << c.text;
    EXPECT_GE(value.value.size, std::abs(value.value.value)) << c.text;
    const double g = 1e-4;  // fourth derivatives below 5000
    const auto at = [&](double t) {
      return c.of(x + t * dx + t * t * ddx / 2, y + t * dy + t * t * ddy / 2);
    };
    EXPECT_NEAR(value.second.value, (at(g) - 2 * at(0) + at(-g)) / (g * g),
                5000 * g * g / 12 + 16 * 2.3e-16 / (g * g))
        << c.text;
    EXPECT_GE(value.second.size, std::abs(value.second.value)) << c.text;
  }
}

TEST(Evaluation, FunctionsOfNumbersEndWhereTheyAreNotDefined) {
  ClaimState<SizedNumber> state{};
  state.w_B = {{{2.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}}};
  Evaluation<SizedNumber> evaluate(state);
  ComponentJets<SizedNumber> value;
  for (const char* text : {"sqrt(w2)", "acos(w1)", "log(w2)", "log(w3)"})
    EXPECT_FALSE(evaluate(equality(text, "0").left, value)) << text;
  for (const char* text : {"sqrt(w3)", "acos(w1/2)", "atan2(w3, w3)"})
    EXPECT_TRUE(evaluate(equality(text, "0").left, value)) << text;
}

// The axes of space do not move, and e_z as seen from the body turns backwards.
TEST(Evaluation, AxesOfSpaceStandStill) {
  const auto state = state_of(random_numbers(5), LawsAssumed::motion);
  for (const char* axis : {"ex", "ey", "ez"}) {
    const std::string e(axis);
    EXPECT_TRUE(*agree(equality("ddt(" + e + ")", "0"), state));
    EXPECT_TRUE(*agree(equality("star(" + e + ")", "-cross(omega, " + e + ")"), state));
    EXPECT_TRUE(*agree(equality("norm2(" + e + ")", "1"), state));
  }
  EXPECT_TRUE(*agree(equality("cross(ex, ey)", "ez"), state));
  EXPECT_FALSE(*agree(equality("ez", "e3"), state));
}

}  // namespace
}  // namespace polhode
