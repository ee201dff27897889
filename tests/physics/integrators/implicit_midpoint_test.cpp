// SPDX-License-Identifier: MIT
#include "physics/integrators/implicit_midpoint.h"

#include "physics/body/euler.h"
#include "physics/integrators/midpoint_equation.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

// Roots to rounding, from scratch and from any guess that is near; the right-hand side at the root is the
// root.
TEST(MidpointEquation, IsSolvedToRounding) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Triple g = 0.3 * triple(random.vector(1)), a = triple(random.vector(1));
    const MidpointEquation equation{g, i % 2 == 0 ? 0.0 : random.uniform(0, 0.04)};
    const MidpointRoot root = root_from_scratch(equation, a);
    const Triple again =
        (1 + equation.beta * dot(root.w, root.w)) * a + times(equation.g, pairs(root.w, root.w));
    EXPECT_LE(size(again - root.w), 16 * kEps * size(root.w)) << i;
    for (const double off : {0.0, 1e-9, 1e-3, 0.05, 0.5}) {
      const MidpointRoot near =
          root_near(equation, a, root.w + (off * size(root.w)) * triple(random.vector(0.5)));
      EXPECT_LE(size(near.w - root.w), 16 * kEps * size(root.w)) << i << ' ' << off;
    }
  }
}

TEST(MidpointEquation, AtRestIsAtRest) {
  const MidpointEquation equation{{0.1, 0.2, 0.3}, 0.01};
  const MidpointRoot root = root_near(equation, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(size(root.w), 0);
}

// L turns in space with the exponential attitude, by O(h²), and stands still with Cayley's.
TEST(ImplicitMidpoint, ExponentialAttitudeLosesTheDirectionOfMomentum) {
  const PrincipalMoments I(1.0, 1.75, 2.5);
  const RigidBodyState start{Random(2).attitude(), {0.2, 1.0, 0.3}};
  const Vec3 L0 = angular_momentum_S(I, start);
  const auto turned = [&](const Motion& motion) {
    const Vec3 L = angular_momentum_S(I, motion.at(5));
    return std::atan2(L0.cross(L).norm(), L0.dot(L));
  };
  const double coarse = turned(*implicit_midpoint_exp_motion({I, start, {}}, 0.02)),
               fine = turned(*implicit_midpoint_exp_motion({I, start, {}}, 0.01));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  EXPECT_LE(turned(*implicit_midpoint_motion({I, start, {}}, 0.02)), 250 * 4 * kEps);
}

// A root exists for every h, but which one is a matter of the step: T and |L| are kept by any.
TEST(ImplicitMidpoint, KeepsEnergyAndMomentumWithAnyStepItCanMake) {
  Random random(3);
  int made = 0;
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = random.moments();
    const RigidBodyState start = random.state();
    const double h = random.uniform(0, 3) / start.w_B.norm();
    const RigidBodyState y = implicit_midpoint_motion({I, start, {}}, h)->at(50 * h);
    if (std::isnan(y.w_B[0])) continue;
    ++made;
    EXPECT_NEAR(kinetic_energy(I, y.w_B) / kinetic_energy(I, start.w_B), 1, 50 * 64 * kEps);
    EXPECT_LE((angular_momentum_S(I, y) - angular_momentum_S(I, start)).norm(),
              50 * 64 * kEps * angular_momentum_S(I, start).norm());
  }
  EXPECT_GE(made, 100);
}

TEST(ImplicitMidpoint, RefusesTorque) {
  const Problem driven{PrincipalMoments(1, 2, 3), {}, {BodyTorque{{0, 0, 1}}}};
  EXPECT_THROW(implicit_midpoint_motion(driven, 0.1), std::domain_error);
  EXPECT_THROW(implicit_midpoint_exp_motion(driven, 0.1), std::domain_error);
}

}  // namespace
}  // namespace polhode
