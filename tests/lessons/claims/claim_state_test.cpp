// SPDX-License-Identifier: MIT
#include "lessons/claims/claim_state.h"

#include "tests/lessons/claims/claim_examples.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

using testing::equality;
using testing::random_numbers;
using Field = FieldElement;

TEST(ClaimState, TheAttitudeIsARotationWhateverTheLengthOfTheQuaternion) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    StateNumbers<Field> numbers = random_numbers(seed);
    const auto R = attitude_matrix(turning(numbers.q, numbers.w, numbers.dw));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        Jet<Field> product;
        for (std::size_t n = 0; n < 3; ++n) product = product + R[i][n] * R[k][n];
        EXPECT_EQ(product.value, Field(i == k ? 1 : 0));
        EXPECT_EQ(product.rate, Field(0)) << "it stays one";
        EXPECT_EQ(product.second, Field(0));
      }
    const auto minor = [&](std::size_t a, std::size_t b) { return R[1][a] * R[2][b] - R[1][b] * R[2][a]; };
    const auto determinant = R[0][0] * minor(1, 2) + R[0][1] * minor(2, 0) + R[0][2] * minor(0, 1);
    EXPECT_EQ(determinant.value, Field(1)) << "no reflection";

    for (Field& component : numbers.q) component = component * Field(-7);
    const auto same = attitude_matrix(turning(numbers.q, numbers.w, numbers.dw));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(R[i][k].value, same[i][k].value);
        EXPECT_EQ(R[i][k].rate, same[i][k].rate);
        EXPECT_EQ(R[i][k].second, same[i][k].second);
      }
  }
}

// Ṙ = R [ω]×, the components of ω on the body axes.
TEST(ClaimState, TheAttitudeTurnsWithOmega) {
  const StateNumbers<Field> n = random_numbers(9);
  const auto R = attitude_matrix(turning(n.q, n.w, n.dw));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      EXPECT_EQ(R[i][k].rate, R[i][l].value * n.w[m] - R[i][m].value * n.w[l]);
    }
}

TEST(ClaimState, EulersRateBalancesTheTorque) {
  const StateNumbers<Field> n = random_numbers(4);
  const auto dw = euler_rate(n.I, n.w, n.N_B);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    EXPECT_EQ(n.I[i] * dw[i] + n.w[j] * (n.I[k] * n.w[k]) - n.w[k] * (n.I[j] * n.w[j]), n.N_B[i]);
  }
}

TEST(ClaimState, AnAssumptionOverrulesTheNumbers) {
  const StateNumbers<Field> n = random_numbers(2);
  const auto any = state_of(n, LawsAssumed::identity), motion = state_of(n, LawsAssumed::motion),
             free = state_of(n, LawsAssumed::free);
  const auto balanced = euler_rate(n.I, n.w, n.N_B);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(any.w_B[i].rate, n.dw[i]);
    EXPECT_EQ(any.v_S[i].rate, n.dv_S[i]);
    EXPECT_EQ(any.A_S[i].rate, n.dA_S[i]);
    EXPECT_EQ(motion.w_B[i].rate, balanced[i]);
    EXPECT_EQ(n.m * motion.v_S[i].rate, n.F_S[i]);
    EXPECT_EQ(motion.N_B[i].value, n.N_B[i]);
    EXPECT_EQ(motion.N_B[i].rate, n.dN_B[i]) << "any torque may change anyhow";
    EXPECT_EQ(any.w_B[i].second, n.ddw[i]);
    EXPECT_EQ(any.v_S[i].second, n.ddv_S[i]);
    EXPECT_EQ(n.m * motion.v_S[i].second, n.dF_S[i]);
    EXPECT_EQ(motion.A_S[i].second, n.ddA_S[i]);
    EXPECT_EQ(motion.A_S[i].rate, n.dA_S[i]) << "A is any vector";
    EXPECT_EQ(free.N_B[i].value, Field(0));
    EXPECT_EQ(free.N_B[i].rate, Field(0));
    EXPECT_NE(free.w_B[i].rate, motion.w_B[i].rate);
  }
}

// I ω̈ + ω̇×Iω + ω×Iω̇ = dN/dt, component by component on the body axes.
TEST(ClaimState, EulersEquationsHoldAllTheTime) {
  const StateNumbers<Field> n = random_numbers(4);
  const auto state = state_of(n, LawsAssumed::motion);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto L = [&](std::size_t at) { return n.I[at] * state.w_B[at].value; };
    const auto dL = [&](std::size_t at) { return n.I[at] * state.w_B[at].rate; };
    EXPECT_EQ(n.I[i] * state.w_B[i].second + state.w_B[j].rate * L(k) - state.w_B[k].rate * L(j) +
                  state.w_B[j].value * dL(k) - state.w_B[k].value * dL(j),
              n.dN_B[i]);
  }
}

// A torque that is given changes as what it is given by does: N1 = -k ω1, F = h e_z, N = h e_z×e3.
TEST(ClaimState, WhatIsGivenHoldsAllTheTime) {
  const auto set = [](Quantity quantity, const char* value) {
    return Setting{quantity, equality(value, "0").left, value, {}, {}};
  };
  const StateNumbers<Field> n = random_numbers(6);
  Given damped, heavy;
  damped.settings = {set(Quantity::N1, "-k*w1"), set(Quantity::F, "h*e3")};
  heavy.settings = {set(Quantity::I2, "I1"), set(Quantity::N, "h*cross(ez, e3)")};
  for (const LawsAssumed laws : {LawsAssumed::identity, LawsAssumed::motion}) {
    const auto state = state_of(n, laws, damped);
    ASSERT_TRUE(state);
    EXPECT_EQ(state->N_B[0].rate, -(n.k * state->w_B[0].rate));
    EXPECT_EQ(state->N_B[1].rate, n.dN_B[1]) << "nothing is said of it";
    for (const auto& [left, right] : {std::pair("ddt(F)", "h*ddt(e3)"), std::pair("ddt(N1)", "-k*dw1")})
      EXPECT_EQ(agree(equality(left, right), *state), std::optional(true)) << left;
    const auto top = state_of(n, laws, heavy);
    ASSERT_TRUE(top);
    EXPECT_EQ(agree(equality("ddt(N)", "h*cross(ez, cross(omega, e3))"), *top), std::optional(true));
  }
}

TEST(ClaimState, SidesAgreeDifferOrAreNotDefined) {
  const auto state = state_of(random_numbers(1), LawsAssumed::identity);
  EXPECT_EQ(agree(equality("w1 + w2", "w2 + w1"), state), std::optional(true));
  EXPECT_EQ(agree(equality("w1", "w2"), state), std::optional(false));
  EXPECT_EQ(agree(equality("e3", "cross(e2, e1)"), state), std::optional(false));
  for (const char* nowhere : {"1/0", "1/(w1 - w1)", "(w1 - w1)^(-2)", "0*(1/0)", "ddt(1/(m - m))"})
    EXPECT_EQ(agree(equality(nowhere, "1"), state), std::nullopt) << nowhere;
  EXPECT_EQ(agree(equality("(w1 - w1)^0", "1"), state), std::optional(true));
}

TEST(ClaimState, AResidualIsRelativeToTheTermsOfTheLargerSide) {
  const auto vector = [](SizedNumber a, SizedNumber b) {
    return ComponentJets<SizedNumber, 0>{{{a, 0}, {b, 0}, {SizedNumber(0), 0}}};
  };
  EXPECT_EQ(relative_residual(vector(0, 0), vector(0, 0)), 0.0);
  EXPECT_EQ(relative_residual(vector(3, 0), vector(3, 0)), 0.0);
  EXPECT_DOUBLE_EQ(relative_residual(vector(3, 4), vector(0, 0)), 1.0);
  EXPECT_DOUBLE_EQ(relative_residual(vector(1, 0), vector({1.5, 100.0}, 0)), 0.005);
  EXPECT_DOUBLE_EQ(relative_residual(vector(2, 0), vector(-2, 0)), 2.0);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::isfinite(relative_residual(vector(infinity, 0), vector(1, 0))));
}

TEST(ClaimState, SidesInDoublesAreThereWhereTheyAreFinite) {
  StateNumbers<SizedNumber> numbers;
  numbers.I = {SizedNumber(2), SizedNumber(3), SizedNumber(4)};
  numbers.w = {SizedNumber(1), SizedNumber(2), SizedNumber(0)};
  const auto state = state_of(numbers, LawsAssumed::identity);
  const auto sides = sides_of(equality("L", "2*omega"), state);
  ASSERT_TRUE(sides);
  EXPECT_EQ(sides->left[1].value.value, 6.0);
  EXPECT_EQ(sides->right[1].value.value, 4.0);
  // Each component of L has the size of the largest of ω, 2, times |Iω|/|ω|.
  EXPECT_DOUBLE_EQ(sides->residual, 2.0 / (std::sqrt(3.0) * 2.0 * std::sqrt(40.0 / 5.0)));
  EXPECT_FALSE(sides_of(equality("1/w3", "1"), state));
  EXPECT_FALSE(sides_of(equality("((1e18)^16)^16", "1"), state));
}

}  // namespace
}  // namespace polhode
