// SPDX-License-Identifier: MIT
#include "physics/integrators/explicit_runge_kutta.h"

#include "physics/body/euler.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

const PrincipalMoments kI(1.0, 1.75, 2.5);
const RigidBodyState kStart{Quat::Identity(), {0.2, 1.0, 0.3}};

struct Errors {
  double w, q;
};

Errors difference(const RigidBodyState& x, const RigidBodyState& y) {
  return {test::w_error(x.w_B, y.w_B), test::q_error(x.q_SB, y.q_SB)};
}

TEST(ExplicitRungeKutta, HasItsOrderUnderEveryTorque) {
  const Torque torques[] = {{SpaceTorque{{0.1, 0, 0.2}}},
                            {BodyTorque{{0, 0.1, 0}}},
                            {HeavyTop{0.5, Vec3::UnitY()}},
                            {LinearDamping{0.05}},
                            {EnergySink{0.02}},
                            {SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}},
                             HeavyTop{0.5, Vec3::UnitY()}, LinearDamping{0.05}, EnergySink{0.02}}};
  for (const Method method : {Method::explicit_euler, Method::explicit_midpoint, Method::rk4}) {
    const int order = facts_of(method).order;
    const double t = 4, h = order == 1 ? 0x1p-14 : (order == 2 ? 0x1p-10 : 0x1p-5);
    for (const Torque& torque : torques) {
      const auto at = [&](double step) {
        return make_motion({kI, kStart, torque}, {method, step, std::nullopt})->at(t);
      };
      const RigidBodyState a = at(h), b = at(h / 2), c = at(h / 4);
      const Errors coarse = difference(a, b), fine = difference(b, c);
      EXPECT_NEAR(std::log2(coarse.w / fine.w), order, 0.1)
          << name_of(method) << " torque " << torque[0].index();
      EXPECT_NEAR(std::log2(coarse.q / fine.q), order, 0.1)
          << name_of(method) << " torque " << torque[0].index();
    }
  }
}

// By the order, the error at h/2 is 1/15 of the difference between h and h/2.
TEST(Rk4, AgreesWithTheSymmetricTop) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const double t = random.uniform(-4, 4), h = 1.0 / 256;
    const RigidBodyState coarse = rk4_motion({I, start, {}}, h)->at(t),
                         fine = rk4_motion({I, start, {}}, h / 2)->at(t);
    const RigidBodyState exact = SymmetricMotion(I, start).at(t);
    const double rounding = 2 * kEps * std::abs(t) / h;
    EXPECT_LE(difference(fine, exact).w, 2.0 / 15 * difference(coarse, fine).w + rounding);
    EXPECT_LE(difference(fine, exact).q, 2.0 / 15 * difference(coarse, fine).q + rounding);
  }
}

TEST(Rk4, AnswersUnitQuaternionsEvenWithAbsurdSteps) {
  const auto motion = rk4_motion({kI, {Quat::Identity(), {0, 0, 50}}, {}}, 1.0);  // |q| grows by 10⁴ per step
  for (const double t : {1.0, 10.0, 500.0, -2000.0, 0.3}) {
    EXPECT_NEAR(motion->at(t).q_SB.norm(), 1, 4 * kEps) << t;
    EXPECT_EQ(motion->at(t).w_B, Vec3(0, 0, 50));
  }
}

// 1e5 steps: T and |L| stay at rounding, they do not walk. Rounding of a step: 4ε; of the test's own T: 4ε.
TEST(Rk4Projected, KeepsEnergyAndMomentumForGood) {
  Random random(2);
  for (int i = 0; i < 5; ++i) {
    const PrincipalMoments I = random.moments();
    const RigidBodyState start = random.state();
    const double h = 0.1 / start.w_B.norm();
    const RigidBodyState y = rk4_projected_motion({I, start, {}}, h)->at(2e4 * h);
    EXPECT_NEAR(kinetic_energy(I, y.w_B) / kinetic_energy(I, start.w_B), 1, 16 * kEps);
    EXPECT_NEAR(angular_momentum_B(I, y.w_B).norm() / angular_momentum_B(I, start.w_B).norm(), 1, 16 * kEps);
  }
}

// About a stable axis a perturbation of η stays one of η: what T and L² could not tell below √ε, D_j does.
// About the unstable one the motion leaves the axis as the reference says.
TEST(Rk4Projected, IsGoodNearSteadyRotation) {
  for (const double eta : {1e-8, 1e-12, 1e-100}) {
    for (const int axis : {0, 2}) {
      Vec3 w_B = eta * Vec3(1, 1, 1);
      w_B[axis] = 1;
      const auto motion = rk4_projected_motion({kI, {Quat::Identity(), w_B}, {}}, 0.01);
      for (double t = 0; t < 100; t += 9.7) {
        const Vec3 w = motion->at(t).w_B;
        EXPECT_NEAR(w[axis], 1, 64 * kEps) << eta << ' ' << t;
        EXPECT_LE(std::abs(w[1]), 3 * eta) << eta << ' ' << t;
        EXPECT_LE(std::abs(w[2 - axis]), 3 * eta) << eta << ' ' << t;
        EXPECT_GE(std::hypot(w[1], w[2 - axis]), 0.1 * eta) << eta << ' ' << t;
      }
    }
  }
  for (const char* name : {"steady_mid_pert_1e-8", "steady_mid_pert_1e-12", "sep_1e-9"}) {
    const test::ReferenceCase& c = test::reference_case(name);
    const test::ReferenceState& truth = c.states[0];
    const double h = std::abs(truth.t_s) / 65536;
    const RigidBodyState y = rk4_projected_motion({c.I, c.start, {}}, h)->at(truth.t_s);
    EXPECT_LE(test::w_error(y.w_B, truth.state.w_B), 1e-6) << name;
  }
}

TEST(Rk4Projected, RefusesTorque) {
  EXPECT_THROW(rk4_projected_motion({kI, kStart, {LinearDamping{0.1}}}, 0.1), std::domain_error);
}

}  // namespace
}  // namespace polhode
