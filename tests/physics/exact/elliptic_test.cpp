// SPDX-License-Identifier: MIT
#include "physics/exact/elliptic.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;

// Truth: mpmath, 40 digits. The arguments are decimal and rounded to double, which moves R_F by ε, cel by the
// sensitivity to its four arguments; hence 8ε.
TEST(CarlsonRF, MatchesHighPrecision) {
  struct Case {
    double x, y, z, RF;
  };
  constexpr std::array kCases{
      Case{0, 1e-3, 1, 8.294051463615439964498908},  Case{1e-300, 1e-300, 1, 691.4686750787736504897556},
      Case{.3, .7, 1, 1.528264308564074290072888},   Case{.999, 1, 1, 1.000333466723834932480559},
      Case{1e-8, .5, 1, 2.156515627499643477649877}, Case{2, 3, 1, 0.508644618570030238213579}};
  for (const auto& [x, y, z, RF] : kCases) {
    EXPECT_NEAR(static_cast<double>(carlson_RF_of_squares(x, y, z)), RF, 8 * kEps * RF) << x << " " << y;
    EXPECT_NEAR(static_cast<double>(carlson_RF_of_squares(y, z, x)), RF, 8 * kEps * RF) << x << " " << y;
  }
}

TEST(BulirschCel, MatchesHighPrecision) {
  struct Case {
    double kp, p, a, b, cel;
  };
  constexpr std::array kCases{
      Case{.3, 4, 1, 2, 1.607386482541715376180966}, Case{.9, 2.25, 3, .5, 2.148533269443674393108942},
      Case{1, 1, 1, 0, 0.7853981633974483096156608}, Case{.05, 1e4, .5, 2, 0.008677836178926888217786281},
      Case{.001, 1.21, 1, 1, 7.017325614268071133624947}};
  for (const auto& [kp, p, a, b, cel] : kCases) {
    const double root_p = std::sqrt(p);
    EXPECT_NEAR(static_cast<double>(bulirsch_cel(kp, root_p, a, b / root_p)), cel, 8 * kEps * cel) << kp;
  }
}

// K = R_F(0, k'², 1) = cel(k', 1, 1, 1), DLMF 19.25.1 and 19.2.11, over all of k'.
TEST(CompleteK, AgreesWithBothOtherForms) {
  for (double kp = 1; kp > 1e-300; kp *= 0.37) {
    const auto K = static_cast<double>(complete_elliptic_K(kp));
    EXPECT_NEAR(K, static_cast<double>(carlson_RF_of_squares(0, kp, 1)), 2 * kEps * K) << kp;
    EXPECT_NEAR(K, static_cast<double>(bulirsch_cel(kp, 1, 1, 1)), 2 * kEps * K) << kp;
  }
  EXPECT_EQ(static_cast<double>(complete_elliptic_K(1)), std::numbers::pi / 2);
}

// std::comp_ellint_1 takes k and so is good only while k' is not small; near 0, K = ln(4/k') + O(k'² ln k').
TEST(CompleteK, MatchesTheLibraryAndTheLogarithm) {
  for (const double k : {0.0, 0.1, 0.5, 0.8}) {
    const double K = std::comp_ellint_1(k);
    EXPECT_NEAR(double(complete_elliptic_K(std::sqrt(1 - k * k))), K, 8 * kEps * K) << k;
  }
  for (const double kp : {1e-9, 1e-20, 1e-100, 1e-300, 5e-324}) {
    const double K = std::log(4 / kp);
    if (std::isfinite(K)) {
      EXPECT_NEAR(double(complete_elliptic_K(kp)), K, 8 * kEps * K) << kp;
    }
  }
}

}  // namespace
}  // namespace polhode
