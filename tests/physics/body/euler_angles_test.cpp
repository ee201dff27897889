// SPDX-License-Identifier: MIT
#include "physics/body/euler_angles.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;
constexpr double kPi = std::numbers::pi;

TEST(EulerAngles, AreThoseOfGoldstein) {
  const double phi = 0.7, theta = 1.1, psi = -2.3;
  const Mat3 R = attitude_of({phi, theta, psi}).toRotationMatrix();
  // Goldstein (4.46), whose matrix takes space components to body components: its transpose.
  const double cf = std::cos(phi), sf = std::sin(phi), ct = std::cos(theta), st = std::sin(theta),
               cp = std::cos(psi), sp = std::sin(psi);
  Mat3 A;
  A << cp * cf - ct * sf * sp, cp * sf + ct * cf * sp, sp * st,   //
      -sp * cf - ct * sf * cp, -sp * sf + ct * cf * cp, cp * st,  //
      st * sf, -st * cf, ct;
  EXPECT_LT((R - A.transpose()).norm(), 32 * kEps);
}

TEST(EulerAngles, ComeBack) {
  for (double theta : {1e-9, 0.3, kPi / 2, 3.0, kPi - 1e-9})
    for (double phi : {-3.0, -0.5, 0.0, 2.5})
      for (double psi : {-2.0, 0.1, 3.1}) {
        const EulerAngles back = euler_angles_of(attitude_of({phi, theta, psi}));
        EXPECT_NEAR(back.theta_rad, theta, 8 * kEps * 4);
        // Of an axis this close to the vertical an ε of the attitude is a turn of ε/θ about it.
        const double turn = 16 * kEps / std::sin(theta);
        EXPECT_NEAR(back.phi_rad, phi, turn + 16 * kEps);
        EXPECT_NEAR(back.psi_rad, psi, turn + 16 * kEps);
      }
}

TEST(EulerAngles, OfAVerticalAxisHaveNoTurnAboutItself) {
  const EulerAngles up = euler_angles_of(attitude_of({0.4, 0, 0.5}));
  EXPECT_EQ(up.theta_rad, 0);
  EXPECT_NEAR(up.phi_rad, 0.9, 8 * kEps);
  EXPECT_EQ(up.psi_rad, 0);
  const EulerAngles down = euler_angles_of(Quat(0, std::cos(0.2), std::sin(0.2), 0));
  EXPECT_EQ(down.theta_rad, kPi);
  EXPECT_NEAR(down.phi_rad, 0.4, 8 * kEps);
  EXPECT_EQ(down.psi_rad, 0);
}

// q̇ = ½ q ⊗ ω: the angular velocity of the rates is that of the attitude itself, by central differences.
TEST(EulerAngles, TurnAtTheAngularVelocityOfTheirRates) {
  const EulerAngles at{0.4, 1.2, -0.9};
  const double phi_rate = 0.7, theta_rate = -0.3, psi_rate = 1.9, h = 1e-4;
  const auto q = [&](double t) {
    return attitude_of({at.phi_rad + t * phi_rate, at.theta_rad + t * theta_rate, at.psi_rad + t * psi_rate});
  };
  const Quat later = q(h), before = q(-h);
  const Quat q_rate((later.coeffs() - before.coeffs()) / (2 * h));
  const Vec3 w_B = 2 * (q(0).conjugate() * q_rate).vec();
  const double w3 = phi_rate * std::cos(at.theta_rad) + psi_rate;
  // h² |ω|³/6 of the quotient, and rounding ε/h.
  EXPECT_LT((w_B - w_B_of(at, phi_rate, theta_rate, w3)).norm(), 10 * h * h + kEps / h);
}

}  // namespace
}  // namespace polhode
