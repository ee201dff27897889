// SPDX-License-Identifier: MIT
#include "physics/exact/elementary.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;
constexpr double kUlp = 2 * kEps;

// Truth: double-double.
TEST(SincosQuarterTurns, IsWithinItsError) {
  test::Random random(1);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double y = random.uniform(-9, 9);
    const auto [sine, cosine] = test::sin_cos(y * (std::numbers::pi_v<DoubleDouble> / 2));
    const SinCos result = sincos_quarter_turns(y);
    worst = std::max(worst, std::abs(static_cast<double>((result.sin - sine) / sine)));
    worst = std::max(worst, std::abs(static_cast<double>((result.cos - cosine) / cosine)));
  }
  EXPECT_LE(worst, 1.5 * kUlp);
}

TEST(SincosQuarterTurns, IsExactAtTheQuartersHoweverFar) {
  for (const double y : {0.0, 4.0, 1e12 * 4, -8.0, 0x1p50}) {
    EXPECT_EQ(sincos_quarter_turns(y).sin, 0) << y;
    EXPECT_EQ(sincos_quarter_turns(y).cos, 1) << y;
    EXPECT_EQ(sincos_quarter_turns(y + 1).sin, 1) << y;
    EXPECT_EQ(sincos_quarter_turns(y + 2).cos, -1) << y;
    EXPECT_EQ(sincos_quarter_turns(y - 1).sin, -1) << y;
  }
}

TEST(Decay, IsWithinItsError) {
  test::Random random(2);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::exp(random.uniform(-40, std::log(kLastDecay)));
    const Decay d = decay(x);
    const DoubleDouble e = test::exp(-DoubleDouble(x));
    EXPECT_NEAR(static_cast<double>(d.exp / e), 1, 2 * kUlp) << x;
    EXPECT_NEAR(static_cast<double>(d.inverse * e), 1, 2 * kUlp) << x;
    EXPECT_NEAR(static_cast<double>(d.one_minus_exp / -test::expm1(-DoubleDouble(x))), 1, 2 * kUlp) << x;
  }
}

TEST(Decay, IsExactAtZeroAndInRangeAtItsEnd) {
  EXPECT_EQ(decay(0).exp, 1);
  EXPECT_EQ(decay(0).one_minus_exp, 0);
  EXPECT_GT(decay(kLastDecay).exp, std::numeric_limits<double>::min());
  EXPECT_LT(decay(kLastDecay).inverse, std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace polhode
