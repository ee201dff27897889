// SPDX-License-Identifier: MIT
#include "physics/analysis/conditioning.h"

#include "physics/geometry/poinsot.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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

using LongQuat = Eigen::Quaternion<DoubleDouble>;
using LongVec3 = Eigen::Matrix<DoubleDouble, 3, 1>;

LongQuat long_rotation_by(const LongVec3& w, double t_s) {
  const DoubleDouble rate = w.norm();
  const auto [sine, cosine] = test::sin_cos(rate * t_s / 2);
  const LongVec3 v = sine / rate * w;
  return {cosine, v[0], v[1], v[2]};
}

/// The attitude of a body with two equal moments, I[0] = I[1], that starts at the identity: the formula of
/// symmetric_motion.h in numbers of twice the digits.
LongQuat long_attitude(const PrincipalMoments& I, const Vec3& w_B, double t_s) {
  const DoubleDouble ratio = DoubleDouble(I[2]) / I[0];
  const LongVec3 w = w_B.cast<DoubleDouble>();
  return long_rotation_by({w[0], w[1], w[2] * ratio}, t_s) *
         long_rotation_by({0, 0, -w[2] * (ratio - 1)}, t_s);
}

// Bodies without a polhode to speak of: no condition number covers what rounds there.
TEST(ClosedFormError, IsNeverBelowTheTruthOfSymmetricBodies) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1), axis(-1, 1);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool is_sphere = i % 4 == 0;
    const double I_a = 0.5 + unit(random), I_c = is_sphere ? I_a : I_a * 2 * unit(random);
    const PrincipalMoments I(I_a, I_a, I_c);
    const Vec3 w_B(axis(random), axis(random), axis(random));
    const double t_s = std::pow(10.0, 7 * unit(random));
    const Problem problem{I, {Quat::Identity(), w_B}, {}};
    const LongQuat found = make_motion(problem, {Method::exact})->at(t_s).q_SB.cast<DoubleDouble>();
    const LongQuat truth =
        is_sphere ? long_rotation_by(w_B.cast<DoubleDouble>(), t_s) : long_attitude(I, w_B, t_s);
    const auto angle_rad = static_cast<double>(2 * (truth.conjugate() * found.normalized()).vec().norm());
    const double bound = closed_form_error(I, w_B, t_s);
    EXPECT_LE(angle_rad, bound) << I.vector().transpose() << ", " << w_B.transpose() << ", " << t_s;
    largest = std::max(largest, angle_rad / bound);
  }
  EXPECT_GE(largest, 0.1) << "a bound that is never come near says nothing";
}

}  // namespace
}  // namespace polhode
