// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/sized_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace polhode {
namespace {

TEST(SizedNumber, KnowsHowLargeTheTermsWere) {
  const SizedNumber zero = SizedNumber(1) - SizedNumber(1);
  EXPECT_TRUE(zero.is_zero());
  EXPECT_EQ(zero.size, 2.0);
  EXPECT_EQ(SizedNumber(-3).size, 3.0);
  EXPECT_EQ((-SizedNumber(3)).size, 3.0);
  EXPECT_EQ((SizedNumber(-3) * SizedNumber(2)).value, -6.0);
  EXPECT_EQ((SizedNumber(-3) * SizedNumber(2)).size, 6.0);
  EXPECT_EQ((zero * SizedNumber(5)).size, 10.0) << "(1 - 1)·5 is 5 - 5";
  EXPECT_EQ(inverse(SizedNumber(-4)).value, -0.25);
  EXPECT_EQ(inverse(SizedNumber(-4)).size, 0.25);
}

TEST(SizedNumber, ADivisorThatCancelsMakesItsReciprocalUncertain) {
  const SizedNumber difference = SizedNumber(1000.5) - SizedNumber(1000);
  EXPECT_EQ(inverse(difference).value, 2.0);
  EXPECT_EQ(inverse(difference).size, 2000.5 / 0.25) << "d(1/a) = -da/a²";
}

// (a + b)² − a² − 2ab − b² is rounding, and the size says how much there can be of it: each of the 7
// operations rounds by at most ε/2 of what it gives.
TEST(SizedNumber, RoundingOfATrueZeroIsSmallAgainstItsSize) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> power(-6, 6);
  for (int n = 0; n < 1000; ++n) {
    const SizedNumber a(std::pow(10, power(random))), b(-std::pow(10, power(random)));
    const SizedNumber zero = (a + b) * (a + b) - a * a - SizedNumber(2) * a * b - b * b;
    EXPECT_GE(zero.size, std::abs(zero.value));
    EXPECT_LE(std::abs(zero.value), 7 * std::numeric_limits<double>::epsilon() / 2 * zero.size);
  }
}

}  // namespace
}  // namespace polhode
