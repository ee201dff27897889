// SPDX-License-Identifier: MIT
#include "physics/analysis/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

TEST(Difference, IsExactForPolynomialsOfSixthDegree) {
  const auto f = [](double t) -> Vec3 { return {std::pow(t, 6), 3.0 * std::pow(t, 5) - t, 7.0}; };
  constexpr double t = 0.75, h = 0.125;  // dyadic: no rounding in the places
  const Vec3 df(6.0 * std::pow(t, 5), 15.0 * std::pow(t, 4) - 1.0, 0.0);
  const double size = f(t + 3 * h).norm();
  EXPECT_LT((derivative_at(f, t, h) - df).norm(), 16 * kEpsilon * size / h);
}

TEST(Difference, OfATurningArrowErrsByTheStatedOrder) {
  const auto f = [](double t) -> Vec3 { return {std::cos(t), std::sin(t), 0.0}; };
  for (double h : {0.4, 0.2, 0.1}) {
    const double error = (derivative_at(f, 0.3, h) - Vec3(-std::sin(0.3), std::cos(0.3), 0.0)).norm();
    EXPECT_NEAR(error / (std::pow(h, 6) / 140.0), 1.0, h * h) << h;  // the next term is of order h²
  }
}

TEST(Difference, OfSecondOrderErrsByTheStatedOrder) {
  const auto f = [](double t) -> Vec3 { return {std::cos(t), std::sin(t), 0.0}; };
  for (double h : {0.4, 0.2, 0.1}) {
    const auto [first, second] = derivatives_at(f, f(0.3), 0.3, h);
    EXPECT_LT((first - derivative_at(f, 0.3, h)).norm(), 8 * kEpsilon / h);
    const double error = (second + f(0.3)).norm();
    EXPECT_NEAR(error / (std::pow(h, 6) / 560.0), 1.0, h * h) << h;
  }
}

}  // namespace
}  // namespace polhode
