// SPDX-License-Identifier: MIT
#include "tests/fuzz/math_inputs.h"

#include <gtest/gtest.h>

namespace polhode::fuzz {
namespace {

/// Of each thousand some hundreds are set, the others refused.
TEST(MathFuzz, MutatedFormulasAreSetOrRefused) {
  const auto fonts = Fonts::open();
  ASSERT_TRUE(fonts.ok()) << fonts.error();
  Mutator formulas = mutated_formulas(2026);
  for (int i = 0; i < 4000; ++i) {
    const std::string tex = formulas.next();
    EXPECT_EQ(finding_in(tex, *fonts), "") << tex;
  }
}

TEST(MathFuzz, HostileFormulasAreRefusedAtOnce) {
  const auto fonts = Fonts::open();
  ASSERT_TRUE(fonts.ok()) << fonts.error();
  const std::string mebibyte(1 << 20, '{');
  for (const std::string& tex : {mebibyte, std::string(10000, '{'), std::string(8192, '^'),
                                 std::string(8192, '}'), std::string(8192, '\xff')}) {
    const auto math = parse_math(tex);
    ASSERT_FALSE(math.ok());
    EXPECT_LE(math.error().size(), 16U);
    EXPECT_EQ(finding_in(tex, *fonts), "");
  }
}

}  // namespace
}  // namespace polhode::fuzz
