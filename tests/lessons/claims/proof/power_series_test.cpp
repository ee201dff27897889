// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/power_series.h"

#include "lessons/claims/proof/prime_field.h"
#include "lessons/claims/proof/rational_function.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace polhode {
namespace {

using Series = PowerSeries<FieldElement>;

/// Polynomials in ε, every coefficient of them, and quotients of these by long division: what series are held
/// against.
using Polynomial = std::vector<FieldElement>;

Polynomial sum_of(const Polynomial& a, const Polynomial& b, bool negative) {
  Polynomial sum(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (i < a.size()) sum[i] = a[i];
    if (i < b.size()) sum[i] = negative ? sum[i] - b[i] : sum[i] + b[i];
  }
  return sum;
}

Polynomial product_of(const Polynomial& a, const Polynomial& b) {
  Polynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] = product[i + k] + a[i] * b[k];
  return product;
}

/// n/d with d ≠ 0: the coefficient of ε^(first + i).
struct Quotient {
  int first = 0;
  Polynomial terms;
};
Quotient quotient_of(Polynomial n, const Polynomial& d, std::size_t count) {
  std::size_t shift = 0;
  while (d[shift].is_zero()) ++shift;
  n.resize(count);
  Quotient quotient{-static_cast<int>(shift), {}};
  for (std::size_t i = 0; i < count; ++i) {
    const FieldElement term = n[i] * inverse(d[shift]);
    quotient.terms.push_back(term);
    for (std::size_t k = shift; k < d.size() && i + k - shift < count; ++k)
      n[i + k - shift] = n[i + k - shift] - term * d[k];
  }
  return quotient;
}

Series series_of(const Polynomial& polynomial) {
  Series series;
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    series = series + Series(polynomial[i], static_cast<int>(i));
  return series;
}

/// What is known of a series is what the quotient is.
void expect_same(const Series& series, const Quotient& exact) {
  ASSERT_LE(series.end(), exact.first + static_cast<int>(exact.terms.size()));
  for (int exponent = exact.first - 1; exponent < series.end(); ++exponent) {
    const int place = exponent - exact.first;
    const FieldElement wanted = place < 0 ? FieldElement() : exact.terms[static_cast<std::size_t>(place)];
    EXPECT_EQ(series.coefficient(exponent).value(), wanted.value()) << "of power " << exponent;
  }
}

class PowerSeriesOf : public ::testing::Test {
 protected:
  Polynomial polynomial(std::size_t size, std::size_t zeros_before = 0) {
    Polynomial all(size);
    for (std::size_t i = zeros_before; i < size; ++i)
      if (random_() % 3 != 0) all[i] = FieldElement(static_cast<std::int64_t>(random_() % kPrime));
    if (zeros_before < size) all[zeros_before] = FieldElement(1 + static_cast<std::int64_t>(random_() % 9));
    return all;
  }
  std::mt19937_64 random_{3};
};

TEST_F(PowerSeriesOf, PolynomialsAndTheirQuotientsAreThose) {
  constexpr std::size_t kCount = 40;
  for (int n = 0; n < 400; ++n) {
    const Polynomial a = polynomial(1 + random_() % 6), b = polynomial(4, random_() % 4),
                     c = polynomial(3, random_() % 2);
    const Series x = series_of(a), y = series_of(b), z = series_of(c);
    const Polynomial one{FieldElement(1)};
    expect_same(x * y + z, quotient_of(sum_of(product_of(a, b), c, false), one, kCount));
    expect_same(x - y * z, quotient_of(sum_of(a, product_of(b, c), true), one, kCount));
    expect_same(x * inverse(y), quotient_of(a, b, kCount));
    // 1/b + a/(b c + c): sums of quotients, over one divisor.
    const Polynomial divisor = sum_of(product_of(b, c), c, false);
    const Series w = y * z + z;
    if (w.is_zero()) continue;
    expect_same(inverse(y) + x * inverse(w),
                quotient_of(sum_of(divisor, product_of(a, b), false), product_of(b, divisor), kCount));
  }
}

// (a + ε^k b) − a: k terms are lost, and what is left is known as far as before.
TEST_F(PowerSeriesOf, WhatCancelsIsNotMadeUp) {
  for (int k = 1; k < Series::kTerms; ++k) {
    const Series a = series_of(polynomial(5)), b = Series(FieldElement(7), k);
    const Series rest = (a + b) - a;
    EXPECT_EQ(rest.first(), k);
    EXPECT_EQ(rest.end(), Series::kTerms);
    EXPECT_EQ(rest.coefficient(k).value(), 7U);
    EXPECT_EQ(inverse(rest).end(), Series::kTerms - 2 * k) << "of 1/(ε^k …) as many terms are known";
  }
  const Series a = series_of(polynomial(5));
  const Series nothing = a - a;
  EXPECT_TRUE(nothing.is_zero());
  EXPECT_EQ(nothing.end(), Series::kTerms) << "beyond, nothing is known of it";
  EXPECT_EQ((nothing * inverse(Series(FieldElement(1), 3))).end(), Series::kTerms - 3);
}

TEST_F(PowerSeriesOf, ZeroIsKnownToAllOrders) {
  const Series zero, x(FieldElement(5), 2);
  for (const Series& one :
       {zero, zero + zero, zero * x, -zero, zero - zero, Series(0), Series(FieldElement(0), 4)}) {
    EXPECT_TRUE(one.is_zero());
    EXPECT_EQ(one.end(), Series::kExact);
  }
  EXPECT_EQ((x + zero).first(), 2);
  EXPECT_EQ((zero - x).coefficient(2).value(), (-FieldElement(5)).value());
}

TEST_F(PowerSeriesOf, RatiosAreExact) {
  using Exact = PowerSeries<Ratio>;
  const Exact eps(Ratio(1), 1);
  const Exact geometric = inverse(Exact(3) - eps);  // 1/3 + ε/9 + ε²/27 …
  std::int64_t power = 3;
  for (int k = 0; k < Exact::kTerms; ++k, power *= 3)
    EXPECT_TRUE(geometric.coefficient(k) == Ratio(power).reciprocal()) << k;
}

}  // namespace
}  // namespace polhode
