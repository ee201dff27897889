// SPDX-License-Identifier: MIT
#include "lessons/claims/claim.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(NumbersAsTex, WritesWhatCounterexamplesAreMadeOf) {
  EXPECT_EQ(numbers_as_tex("(1, −2, 0.5)"), "(1, -2, 0.5)");
  EXPECT_EQ(numbers_as_tex("√2"), "\\sqrt{2}");
  EXPECT_EQ(numbers_as_tex("−2ε, ε², 3ε³"), "-2\\varepsilon{}, \\varepsilon^2, 3\\varepsilon^3");
  EXPECT_EQ(numbers_as_tex("−1.5e+06"), "-1.5\\cdot10^{6}");
  EXPECT_EQ(numbers_as_tex("2e-07"), "2\\cdot10^{-7}");
  EXPECT_EQ(numbers_as_tex(""), "");
}

}  // namespace
}  // namespace polhode
