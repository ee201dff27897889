// SPDX-License-Identifier: MIT
// Truth: binary128, where the compiler has it, whose own errors are below 2⁻¹¹² of the result.
#include "physics/exact/double_double.h"

#include "physics/exact/extended.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace polhode {
namespace {

using test::Random;

constexpr double kU = 0x1p-53;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

// What the class promises of each of its numbers.
void expect_normalised(const DoubleDouble& x) {
  ASSERT_GE(std::abs(x.hi()), 1);
  ASSERT_LT(std::abs(x.hi()), 2);
  ASSERT_EQ(x.hi() + x.lo(), x.hi());
}

// Mantissas that make trouble, and lo from none to as large as it may be; 112 bits in all, which binary128
// holds.
DoubleDouble hostile(Random& random, int most_exponent) {
  constexpr std::array kLeading{1.0, 1 + 0x1p-52, 2 - 0x1p-52, 1.5, 1 + 0x1p-26, 4 / 3.0};
  const int kind = random.uniform_int(0, 11);
  const double hi = kind < 6 ? kLeading[static_cast<std::size_t>(kind)] : random.uniform(1, 2);
  const double half_step = hi == 1 ? 0x1p-54 : 0x1p-53;
  double lo = 0;
  switch (random.uniform_int(0, 4)) {
    case 0:
      break;
    case 1:
      lo = half_step * (1 - 0x1p-53);
      break;
    case 2:
      lo = -half_step * (1 - 0x1p-53);
      break;
    case 3:
      lo = 0x1p-112;
      break;
    default:
      lo = random.uniform(0.02, 0.99) * (random.uniform_int(0, 1) == 0 ? half_step : -half_step);
  }
  const DoubleDouble x = DoubleDouble::of_parts(hi, lo, random.uniform_int(-most_exponent, most_exponent));
  return random.uniform_int(0, 1) == 0 ? x : -x;
}

#ifdef __SIZEOF_FLOAT128__

__extension__ using Quad = __float128;

Quad times_two_to(int e, Quad x) {
  for (; e > 0; e -= std::min(e, 1000)) x *= std::scalbn(1.0, std::min(e, 1000));
  for (; e < 0; e += std::min(-e, 1000)) x *= std::scalbn(1.0, -std::min(-e, 1000));
  return x;
}

Quad quad(const DoubleDouble& x) { return times_two_to(x.exponent(), Quad(x.hi()) + Quad(x.lo())); }

// |x − truth| in units of u² |truth|.
double error_in_u2(const DoubleDouble& x, Quad truth) {
  if (truth == 0) return x == 0 ? 0 : kInfinity;
  const Quad error = (quad(x) - truth) / truth;
  return static_cast<double>(error < 0 ? -error : error) / (kU * kU);
}

constexpr double kOfQuad = 0x1p-112 / (kU * kU);  // the truth's own error, in the same units
constexpr int kTries = 200'000;

TEST(DoubleDouble, SumsToThreeUnits) {
  Random random(1);
  for (int i = 0; i < kTries; ++i) {
    const DoubleDouble x = hostile(random, 1074);
    DoubleDouble y = hostile(random, 0);
    const int gap = random.uniform_int(-230, 230);
    if (i % 4 != 0) y = scalbn(y, x.exponent() + (i % 4 == 1 ? 0 : gap));
    if (i % 8 == 1) y = -DoubleDouble::of_parts(x.hi(), 0, x.exponent());       // all of hi cancels
    if (i % 8 == 5) y = -scalbn(DoubleDouble(x.hi() + 0x1p-50), x.exponent());  // nearly all
    const DoubleDouble sum = x + y;
    ASSERT_LE(error_in_u2(sum, quad(x) + quad(y)), 3 + 13 * kU + kOfQuad) << i;
    ASSERT_LE(error_in_u2(x - y, quad(x) - quad(y)), 3 + 13 * kU + kOfQuad) << i;
    ASSERT_EQ(sum, y + x);
    if (sum != 0) expect_normalised(sum);
  }
}

TEST(DoubleDouble, MultipliesDividesAndTakesRootsWithinTheirUnits) {
  Random random(2);
  for (int i = 0; i < kTries; ++i) {
    const DoubleDouble x = hostile(random, 1074), y = hostile(random, 1074);
    const Quad X = quad(x), Y = quad(y);
    ASSERT_LE(error_in_u2(x * y, X * Y), 5 + kOfQuad) << i;
    ASSERT_LE(error_in_u2(x / y, X / Y), 12 + kOfQuad) << i;
    // (√x + δ)² = x + 2δ√x: squared, the bound is twice that of the root.
    const DoubleDouble root = sqrt(abs(x));
    ASSERT_LE(error_in_u2(abs(x), quad(root) * quad(root)), 2 * 5 + kOfQuad) << i;
    expect_normalised(x * y);
    expect_normalised(x / y);
    expect_normalised(root);
  }
}

TEST(DoubleDouble, ComparesAsNumbersDo) {
  Random random(3);
  for (int i = 0; i < kTries; ++i) {
    const DoubleDouble x = hostile(random, i % 2 == 0 ? 2 : 1074);
    const DoubleDouble y =
        i % 3 == 0 ? x + scalbn(x, -random.uniform_int(90, 110)) : hostile(random, i % 2 == 0 ? 2 : 1074);
    const Quad X = quad(x), Y = quad(y);
    ASSERT_EQ(x < y, X < Y) << i;
    ASSERT_EQ(x <= y, X <= Y) << i;
    ASSERT_EQ(x > y, X > Y) << i;
    ASSERT_EQ(x == y, X == Y) << i;
    ASSERT_EQ(abs(x) == abs(y), X == Y || X == -Y) << i;
  }
}

#endif  // __SIZEOF_FLOAT128__

TEST(DoubleDouble, HoldsEveryDouble) {
  Random random(4);
  std::vector<double> doubles{1, -1, 1e308, kMax, -kMax, kTiny, -kTiny, 3 * kTiny, 0x1p-1022, 0x1.fp-1023};
  for (int i = 0; i < 10'000; ++i)
    doubles.push_back(std::scalbn(random.uniform(-2, 2), random.uniform_int(-1090, 1020)));
  for (const double x : doubles) {
    if (x == 0) continue;
    expect_normalised(x);
    EXPECT_EQ(static_cast<double>(DoubleDouble(x)), x);
    EXPECT_EQ(static_cast<double>(to_extended(x)), x);
    EXPECT_EQ(ilogb(DoubleDouble(x)), std::ilogb(x));
  }
}

TEST(DoubleDouble, RoundsToTheNearestDouble) {
  const DoubleDouble third = DoubleDouble(1) / 3;
  EXPECT_EQ(static_cast<double>(third), 1 / 3.0);
  EXPECT_EQ(static_cast<double>(scalbn(third, -1060)), std::scalbn(1 / 3.0, -1060));  // in the subnormals
  EXPECT_EQ(static_cast<double>(scalbn(third, 1026)), kInfinity);
  EXPECT_EQ(static_cast<double>(scalbn(-third, 3000)), -kInfinity);
  EXPECT_EQ(static_cast<double>(scalbn(third, -3000)), 0);
  EXPECT_EQ(static_cast<double>(DoubleDouble(kMax) * kMax / kMax), kMax);
}

TEST(DoubleDouble, IsExactWhereDoublesAreTwo) {
  Random random(5);
  for (int i = 0; i < 10'000; ++i) {
    const double x = random.uniform(1, 2), y = random.uniform(1, 2);
    const DoubleDouble sum = DoubleDouble(x) + y * 0x1p-53, product = DoubleDouble(x) * y;
    EXPECT_EQ(sum - x, y * 0x1p-53);
    EXPECT_EQ(product.hi() * std::scalbn(1.0, product.exponent()), x * y);
    EXPECT_EQ(static_cast<double>(product - x * y), std::fma(x, y, -(x * y)));
    EXPECT_EQ(static_cast<double>(product / y - x), 0);
  }
}

// Of x > 0 the first step that counts is about 2⁻¹⁰⁶ x.
TEST(DoubleDouble, TellsNeighboursApart) {
  const DoubleDouble x = DoubleDouble(1) + 0x1p-105;
  EXPECT_GT(x, 1);
  EXPECT_LT(1, x);
  EXPECT_NE(x, 1);
  EXPECT_EQ(x - 1, 0x1p-105);
  EXPECT_LT(DoubleDouble(1) - 0x1p-200, 1);
  EXPECT_GT(DoubleDouble(-1) + 0x1p-200, -1);
}

TEST(DoubleDouble, NeverLeavesTheRange) {
  DoubleDouble x = 1;
  for (int i = 0; i < 1000; ++i) x *= kMax;
  EXPECT_EQ(x.exponent(), 1'023'999);
  for (int i = 0; i < 1000; ++i) x /= kMax;
  EXPECT_LE(std::abs(static_cast<double>(x - 1)), 1000 * (12 + 5) * kU * kU);
  const DoubleDouble tiny = DoubleDouble(kTiny) * kTiny * kTiny * kTiny;
  EXPECT_GT(tiny, 0);
  EXPECT_EQ(sqrt(sqrt(tiny)), kTiny);
}

// The same digits at all scales; a root, at those of even exponents.
TEST(DoubleDouble, ScalesByPowersOfTwoToTheBit) {
  Random random(6);
  for (int i = 0; i < 10'000; ++i) {
    const DoubleDouble x = hostile(random, 20), y = hostile(random, 20);
    const int m = random.uniform_int(-5000, 5000), n = random.uniform_int(-5000, 5000);
    const auto expect_same = [](const DoubleDouble& a, const DoubleDouble& b) {
      EXPECT_EQ(a.hi(), b.hi());
      EXPECT_EQ(a.lo(), b.lo());
      EXPECT_EQ(a.exponent(), b.exponent());
    };
    expect_same(scalbn(x, m) * scalbn(y, n), scalbn(x * y, m + n));
    expect_same(scalbn(x, m) / scalbn(y, n), scalbn(x / y, m - n));
    expect_same(scalbn(x, m) + scalbn(y, m), scalbn(x + y, m));
    expect_same(sqrt(scalbn(abs(x), 2 * m)), scalbn(sqrt(abs(x)), m));
  }
}

TEST(DoubleDouble, HasOneZero) {
  const DoubleDouble zero, minus_zero(-0.0), x = DoubleDouble(1) / 3;
  EXPECT_EQ(x + zero, x);
  EXPECT_EQ(zero - x, -x);
  EXPECT_EQ(x - x, 0);
  EXPECT_EQ(zero + minus_zero, zero);
  EXPECT_EQ(zero * x, 0);
  EXPECT_EQ(zero / x, 0);
  EXPECT_EQ(sqrt(zero), 0);
  EXPECT_EQ(asinh(zero), 0);
  EXPECT_EQ(scalbn(zero, 5000) + x, x);
  EXPECT_LT(zero, scalbn(x, -5000));
  EXPECT_EQ(-zero, zero);
  EXPECT_EQ(minus_zero, zero);
  EXPECT_FALSE(minus_zero < zero || zero < minus_zero);
}

TEST(DoubleDouble, HasNoInfinityAndCarriesNaNOn) {
  const DoubleDouble one = 1;
  const auto is_nan = [](const DoubleDouble& x) { return std::isnan(static_cast<double>(x)); };
  for (const DoubleDouble& bad : {DoubleDouble(kInfinity), DoubleDouble(-kInfinity), DoubleDouble(NAN),
                                  one / 0, DoubleDouble(0) / 0, sqrt(-one), asinh(DoubleDouble(NAN))}) {
    for (const DoubleDouble& x : {one, scalbn(one, 5000), DoubleDouble(0), bad})
      for (const DoubleDouble& result :
           {x + bad, bad + x, x - bad, bad - x, x * bad, bad * x, x / bad, bad / x})
        EXPECT_TRUE(is_nan(result));
    for (const DoubleDouble& result : {-bad, abs(bad), sqrt(bad), scalbn(bad, -5000)})
      EXPECT_TRUE(is_nan(result));
    EXPECT_FALSE(bad == bad || bad < one || bad > one || bad <= one || bad >= one || one < bad || one > bad);
    EXPECT_TRUE(bad != one);
  }
}

// Truth: mpmath, 120 digits, rounded to two doubles.
TEST(DoubleDouble, HasTheAreaHyperbolicSine) {
  struct Case {
    DoubleDouble x;
    double hi, lo;
  };
  const std::array kCases{
      Case{0x1p-600, 0x1p-600, 0},
      Case{0.09375, 0x1.7f70910ab14f8p-4, -0x1.c01e2771b2340p-58},
      Case{0.125 + 0x1p-20, 0x1.feae096f81e21p-4, 0x1.bda82d2d2c563p-58},
      Case{1, 0x1.c34366179d427p-1, -0x1.9f270661722dbp-56},
      Case{-3.5, -0x1.f73974f2d01d6p+0, -0x1.e69849e1ec90bp-55},
      Case{12345, 0x1.43a7256abd3dfp+3, -0x1.35a34a49ad069p-54},
      Case{scalbn(DoubleDouble(1), 2000), 0x1.5abf335603bdbp+10, -0x1.3f075e6627192p-45},
  };
  for (const auto& [x, hi, lo] : kCases) {
    const DoubleDouble truth = DoubleDouble(hi) + lo;
    EXPECT_LE(std::abs(static_cast<double>((asinh(x) - truth) / truth)), 100 * kU * kU) << hi;
  }
}

// Brent and Salamin: π = 4 AGM(1, 1/√2)²/(1 − Σ 2^{n+1} (a_n² − g_n²)), n ≥ 1. Errors: of some tens of
// operations.
TEST(DoubleDouble, KnowsPi) {
  DoubleDouble a = 1, g = sqrt(DoubleDouble(0.5)), rest = 1;
  for (int n = 1; n < 8; ++n) {
    const DoubleDouble mean = (a + g) / 2;
    g = sqrt(a * g);
    a = mean;
    rest -= scalbn(a * a - g * g, n + 1);
  }
  const DoubleDouble pi = 4 * a * a / rest;
  EXPECT_LE(std::abs(static_cast<double>(pi / std::numbers::pi_v<DoubleDouble> - 1)), 200 * kU * kU);
}

TEST(DoubleDouble, IsANumberOfVectors) {
  using Vector = Eigen::Matrix<DoubleDouble, 3, 1>;
  const Vector v =
      Vec3(3, -4, 12).cast<DoubleDouble>().unaryExpr([](const DoubleDouble& x) { return scalbn(x, 5000); });
  EXPECT_EQ(v.norm(), scalbn(DoubleDouble(13), 5000));
  EXPECT_EQ(v.cwiseAbs().maxCoeff(), scalbn(DoubleDouble(12), 5000));
  EXPECT_EQ((2 * v / scalbn(DoubleDouble(1), 5000)).cast<double>().eval(), Vec3(6, -8, 24));
  EXPECT_EQ(v.cross(Vector::Unit(0))[2], scalbn(DoubleDouble(4), 5000));
}

}  // namespace
}  // namespace polhode
