// SPDX-License-Identifier: MIT
#include "physics/exact/polhode_constants.h"

#include "physics/body/euler.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

TEST(PolhodeConstants, AreThereUnlessSteadyAndKnowTheSeparatrix) {
  for (const test::ReferenceCase& c : test::reference_cases()) {
    const auto p = polhode_constants(c.I, c.start.w_B);
    ASSERT_EQ(p.has_value(), c.kind != "steady") << c.name;
    if (p) {
      EXPECT_EQ(p->separatrix(), c.kind == "separatrix") << c.name;
    }
  }
}

// The modulus from sn² + cn² = 1, k² + k'² = 1; the state itself satisfies (A, B, C)'s three equations.
TEST(PolhodeConstants, SatisfyTheIdentitiesOfTheEllipticFunctions) {
  for (const test::ReferenceCase& c : test::reference_cases()) {
    const auto p = polhode_constants(c.I, c.start.w_B);
    if (!p) continue;
    const Vec3& w_B = c.start.w_B;
    const Extended cn = w_B[p->a] / p->A, sn = w_B[p->b] / p->B, dn = w_B[p->c] / p->C;
    EXPECT_NEAR(double(p->k * p->k + p->kp * p->kp), 1, 16 * kEps) << c.name;
    EXPECT_NEAR(double(cn * cn + sn * sn), 1, 16 * kEps) << c.name;
    EXPECT_NEAR(double(dn * dn + p->k * p->k * sn * sn), 1, 16 * kEps) << c.name;
  }
}

// ω̇ at the vertex sn = 0 is d/dt of the elliptic functions there: ω̇_b = σ B λ dn = σ B λ, whatever axes and
// signs.
TEST(PolhodeConstants, MoveAsEulersEquationsSay) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const PrincipalMoments I = random.moments();
    const auto p = polhode_constants(I, random.vector(2));
    ASSERT_TRUE(p.has_value());
    Vec3 w_B;
    w_B[p->a] = double(p->A);
    w_B[p->b] = 0;
    w_B[p->c] = p->sign_c * double(p->C);
    const double rate_b = p->sign_b * angular_acceleration_B(I, w_B)[p->b];
    const double expected = p->sigma * double(p->B * p->lambda);
    // Relative to the products of the moments, whose difference I_c − I_a is rounded.
    EXPECT_NEAR(rate_b, expected, 32 * kEps * std::abs(expected));
  }
}

TEST(PolhodeConstants, ScaleByPowersOfTwoToTheBit) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2);
    const Vec3 big = I.vector() * 0x1p301;
    const auto p = polhode_constants(I, w_B);
    const auto s = polhode_constants({big[0], big[1], big[2]}, w_B * 0x1p-203);
    EXPECT_EQ(p->A * 0x1p-203, s->A);
    EXPECT_EQ(p->B * 0x1p-203, s->B);
    EXPECT_EQ(p->C * 0x1p-203, s->C);
    EXPECT_EQ(p->lambda * 0x1p-203, s->lambda);
    EXPECT_EQ(p->k, s->k);
    EXPECT_EQ(p->kp, s->kp);
  }
}

TEST(PolhodeConstants, SortAndParity) {
  EXPECT_EQ(sorted_axes(PrincipalMoments(2, 1, 1.5)), (std::array<int, 3>{1, 2, 0}));
  EXPECT_EQ(sorted_axes(PrincipalMoments(1, 1, 1)), (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(parity(0, 1), 1);
  EXPECT_EQ(parity(1, 2), 1);
  EXPECT_EQ(parity(2, 0), 1);
  EXPECT_EQ(parity(1, 0), -1);
  EXPECT_EQ(parity(2, 1), -1);
  EXPECT_EQ(parity(0, 2), -1);
}

}  // namespace
}  // namespace polhode
