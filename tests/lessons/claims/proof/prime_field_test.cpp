// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/prime_field.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace polhode {
namespace {

constexpr auto kHighest = std::numeric_limits<std::int64_t>::max();
constexpr auto kLowest = std::numeric_limits<std::int64_t>::min();
constexpr auto kP = static_cast<std::int64_t>(kPrime);

/// Corners of the range, and some from its middle.
std::vector<std::int64_t> residues() {
  std::vector<std::int64_t> all = {0,      1,      2,          3,         kP - 1,
                                   kP - 2, kP / 2, kP / 2 + 1, 1LL << 60, (1LL << 31) - 1};
  std::mt19937_64 random(3);
  for (int n = 0; n < 30; ++n) all.push_back(static_cast<std::int64_t>(random() % kPrime));
  return all;
}

/// By doubling and adding: nothing wider than 64 bits.
std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t sum = 0;
  for (; b != 0; b >>= 1) {
    if (b & 1) sum = (sum + a) % kPrime;
    a = (a + a) % kPrime;
  }
  return sum;
}

TEST(PrimeField, TakesWholeNumbersModuloP) {
  EXPECT_EQ(FieldElement().value(), 0U);
  EXPECT_EQ(FieldElement(kP).value(), 0U);
  EXPECT_EQ(FieldElement(kP + 1).value(), 1U);
  EXPECT_EQ(FieldElement(-1).value(), kPrime - 1);
  EXPECT_EQ(FieldElement(-kP).value(), 0U);
  EXPECT_EQ(FieldElement(kHighest).value(), 3U) << "2^63 - 1 = 4 (2^61 - 1) + 3";
  EXPECT_EQ(FieldElement(kLowest).value(), kPrime - 4);
  for (const std::int64_t a : residues()) EXPECT_EQ(FieldElement(-a), -FieldElement(a)) << a;
}

TEST(PrimeField, CalculatesAsTheIntegersModuloP) {
  for (const std::int64_t a : residues())
    for (const std::int64_t b : residues()) {
      const auto x = static_cast<std::uint64_t>(a), y = static_cast<std::uint64_t>(b);
      EXPECT_EQ((FieldElement(a) + FieldElement(b)).value(), (x + y) % kPrime);
      EXPECT_EQ((FieldElement(a) - FieldElement(b)).value(), (x + kPrime - y) % kPrime);
      EXPECT_EQ((FieldElement(a) * FieldElement(b)).value(), product(x, y)) << a << " · " << b;
    }
}

TEST(PrimeField, EveryElementButZeroHasAnInverse) {
  for (const std::int64_t a : residues())
    EXPECT_TRUE(a == 0 || FieldElement(a) * inverse(FieldElement(a)) == FieldElement(1)) << a;
  static_assert(inverse(FieldElement(2)) * FieldElement(2) == FieldElement(1));
}

}  // namespace
}  // namespace polhode
