// SPDX-License-Identifier: MIT
#include "physics/body/euler.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

TEST(Euler, AccelerationIsThatOfTheVectorEquation) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2), N_B = random.vector(2);
    // (6): I·ω̇ + ω×(I·ω) = N
    const Vec3 left_B =
        angular_momentum_B(I, angular_acceleration_B(I, w_B, N_B)) + w_B.cross(angular_momentum_B(I, w_B));
    const double size = N_B.norm() + w_B.squaredNorm() * I.vector().maxCoeff();
    EXPECT_LE((left_B - N_B).norm(), 16 * kEps * size);
  }
}

TEST(Euler, TextbookNumbers) {
  const PrincipalMoments I(1, 2, 3);
  EXPECT_EQ(angular_acceleration_B(I, {1, 1, 1}), Vec3(-1, 1, -1.0 / 3));
  EXPECT_EQ(angular_momentum_B(I, {1, 2, 3}), Vec3(1, 4, 9));
  EXPECT_EQ(kinetic_energy(I, {1, 2, 3}), 0.5 * (1 + 8 + 27));
}

TEST(Euler, MomentumInSpaceIsTheRotatedBodyMomentum) {
  const PrincipalMoments I(1, 2, 3);
  const Quat quarter_turn_about_z(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
  const Vec3 L_S = angular_momentum_S(I, {quarter_turn_about_z, {1, 0, 0}});
  EXPECT_LE((L_S - Vec3(0, 1, 0)).norm(), 4 * kEps);
}

TEST(Euler, PowerOfTheTorqueIsTheRateOfEnergy) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2), N_B = random.vector(2);
    const double T_rate = angular_momentum_B(I, w_B).dot(angular_acceleration_B(I, w_B, N_B));
    const double size = N_B.norm() * w_B.norm() + I.vector().maxCoeff() * std::pow(w_B.norm(), 3);
    EXPECT_NEAR(T_rate, N_B.dot(w_B), 16 * kEps * size);
  }
}

}  // namespace
}  // namespace polhode
