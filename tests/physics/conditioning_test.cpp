// SPDX-License-Identifier: MIT
#include "physics/conditioning.h"

#include "physics/poinsot.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;

// 2π Σ |∂ln P/∂ln x| by central differences of the period.
double differences(const PrincipalMoments& I, const Vec3& w_B, double h) {
  const auto log_period = [&](int input, double factor) {
    Vec3 moments = I.vector(), w = w_B;
    (input < 3 ? moments[input] : w[input - 3]) *= factor;
    return std::log(*polhode_period({moments[0], moments[1], moments[2]}, w));
  };
  double sum = 0;
  for (int input = 0; input < 6; ++input)
    sum += std::abs(log_period(input, 1 + h) - log_period(input, 1 - h)) / (2 * h);
  return 2 * std::numbers::pi * sum;
}

TEST(Conditioning, IsTheSensitivityOfThePeriod) {
  test::Random random(3);
  for (int i = 0; i < 300; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2);
    const double number = conditioning(I, w_B)->phase_per_period;
    const double h = 1e-6 / std::max(1.0, number / 100);
    // Truncation: third derivatives are of the order of the cube of the first; rounding: ε/h for each input.
    const double tolerance = std::pow(number * h, 2) * number + 2 * std::numbers::pi * 6 * 32 * kEps / h;
    EXPECT_NEAR(differences(I, w_B, h), number, tolerance) << i;
  }
}

// Near it d ln P = −dD/(2DK), so number · δ · K tends to a constant, with corrections of order δ ln δ.
TEST(Conditioning, GrowsAsOneOverTheDistanceToTheSeparatrix) {
  const PrincipalMoments I(1, 2, 2.5);
  const double on_it = 0.2 * std::sqrt(2.5 * 0.5);  // I3(I3 − I2)ω3² = I1(I2 − I1)ω1²
  const auto scaled = [&](double delta) {
    const Vec3 w_B(on_it * (1 + delta), 1.5, 0.2);
    return conditioning(I, w_B)->phase_per_period * delta * *polhode_period(I, w_B);
  };
  EXPECT_NEAR(scaled(1e-9) / scaled(1e-6), 1, 1e-4);
}

TEST(Conditioning, CountsTurnsWithoutAPolhode) {
  EXPECT_DOUBLE_EQ(conditioning(PrincipalMoments(1, 2, 2.5), {0, 0, 3})->phase_per_period,
                   2 * std::numbers::pi);
  // ν = ω_c (I_c − I_a)/I_a: 1 for ω_c, I_c/(I_c − I_a) for each of I_c and I_a
  EXPECT_DOUBLE_EQ(conditioning(PrincipalMoments(2, 2, 3), {1, 0, 1})->phase_per_period,
                   2 * std::numbers::pi * (1 + 2 * 3));
  EXPECT_FALSE(conditioning(PrincipalMoments(1, 2, 2.5), Vec3::Zero()));
}

TEST(Conditioning, HasNoPeriodToSpeakOfOnTheSeparatrix) {
  // I3(I3 − I2)ω3² = 12 ω3² and I1(I2 − I1)ω1² = 3 ω1² are equal for ω1 = 2 ω3.
  EXPECT_FALSE(conditioning(PrincipalMoments(3, 4, 6), {2, 0.3, 1}));
  EXPECT_TRUE(conditioning(PrincipalMoments(3, 4, 6), {std::nextafter(2.0, 3.0), 0.3, 1}));
}

TEST(Conditioning, TellsHowFarAheadPredictionReaches) {
  const auto c = *conditioning(PrincipalMoments(2, 2, 3), {1, 0, 1});
  EXPECT_DOUBLE_EQ(c.horizon_periods(1e-3) * c.phase_per_period * kEps, 1e-3);
}

}  // namespace
}  // namespace polhode
