// SPDX-License-Identifier: MIT
// Laws the exact motion obeys whatever the body: scaling to the bit, conservation, symmetries of Euler's
// equations, one motion however it is asked.
#include "physics/analysis/batch.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace polhode {
namespace {

using test::exact_motion;
using test::kEps;
using test::Random;

PrincipalMoments moments_of(const Vec3& I) { return {I[0], I[1], I[2]}; }

// Generic, one in eight each: needle, nearly symmetric, near-sphere, symmetric.
PrincipalMoments some_moments(Random& random) {
  const double small = std::pow(10, random.uniform(-14, -1));
  Vec3 I = random.moments().vector();
  switch (random.uniform_int(0, 7)) {
    case 0:
      I = {small, 1, 1 + 0.9 * small};
      break;
    case 1:
      I = {1, 1 + small, random.uniform(0.2, 1.9)};
      break;
    case 2:
      I = {1, 1 + small, 1 - 2 * small};
      break;
    case 3:
      return random.symmetric_moments();
    default:
      break;
  }
  std::shuffle(I.data(), I.data() + 3, random.engine());
  return moments_of(I);
}

// Generic, or all but about one axis.
Vec3 some_w(Random& random) {
  Vec3 w_B = random.vector(2);
  const int axis = random.uniform_int(0, 5);
  for (int i = 0; axis < 3 && i < 3; ++i)
    if (i != axis) w_B[i] *= std::pow(10, random.uniform(-15, -1));
  return w_B;
}

constexpr int kBodies = 20'000;

TEST(ExactProperties, ScaleByPowersOfTwoToTheBit) {
  Random random(101);
  for (int i = 0; i < kBodies; ++i) {
    const PrincipalMoments I = some_moments(random);
    const RigidBodyState start{random.attitude(), some_w(random)};
    const double t = random.uniform(-100, 100);
    const RigidBodyState plain = exact_motion(I, start)->at(t);
    const int e_I = random.uniform_int(-900, 900), e_w = random.uniform_int(-300, 300);

    const PrincipalMoments I_scaled = moments_of(I.vector() * std::scalbn(1.0, e_I));
    ASSERT_TRUE(test::same_bits(exact_motion(I_scaled, start)->at(t), plain)) << i;

    RigidBodyState faster = start;
    faster.w_B *= std::scalbn(1.0, e_w);
    RigidBodyState state = exact_motion(I, faster)->at(t * std::scalbn(1.0, -e_w));
    state.w_B *= std::scalbn(1.0, -e_w);
    ASSERT_TRUE(test::same_bits(state, plain)) << i;

    state = exact_motion(I_scaled, faster)->at(t * std::scalbn(1.0, -e_w));
    state.w_B *= std::scalbn(1.0, -e_w);
    ASSERT_TRUE(test::same_bits(state, plain)) << i;
  }
}

TEST(ExactProperties, KeepEnergyAndMomentumInSpace) {
  Random random(102);
  test::Drift worst{0, 0, 0};
  double worst_norm = 0;
  for (int i = 0; i < kBodies; ++i) {
    const PrincipalMoments I = some_moments(random);
    const RigidBodyState start{random.attitude(), some_w(random)};
    const auto motion = exact_motion(I, start);
    for (int k = 0; k < 3; ++k) {
      const RigidBodyState state = motion->at(random.uniform(-100, 100));
      const test::Drift drift = test::drift(I, start, state);
      worst = {std::max(worst.T, drift.T), std::max(worst.L, drift.L),
               std::max(worst.direction, drift.direction)};
      worst_norm = std::max(worst_norm, std::abs(state.q_SB.norm() - 1));
    }
  }
  EXPECT_LE(worst.T, 4e-15);
  EXPECT_LE(worst.L, 4e-15);
  EXPECT_LE(worst.direction, 1e-14);
  EXPECT_LE(worst_norm, 8 * kEps);
  RecordProperty("T", std::to_string(worst.T * 1e15) + "e-15");
  RecordProperty("L", std::to_string(worst.L * 1e15) + "e-15");
  RecordProperty("direction", std::to_string(worst.direction * 1e15) + "e-15");
}

TEST(ExactProperties, AreOneMotionHoweverAsked) {
  Random random(103);
  std::vector<double> t_s(130);  // two blocks of a batch, and a rest
  std::vector<RigidBodyState> states(t_s.size());
  for (int i = 0; i < 1000; ++i) {
    const auto motion = exact_motion(some_moments(random), {random.attitude(), some_w(random)});
    for (double& t : t_s) t = random.uniform(-1e4, 1e4);
    t_s[0] = 0;
    t_s[7] = 1e300;
    motion->at(t_s, states);
    for (std::size_t k = 0; k < t_s.size(); ++k) {
      ASSERT_TRUE(test::same_bits(states[k], motion->at(t_s[k]))) << i << " " << t_s[k];
      const Vec3 w_B = motion->w_B_at(t_s[k]);
      ASSERT_EQ(std::memcmp(w_B.data(), states[k].w_B.data(), sizeof(double) * 3), 0) << i << " " << t_s[k];
    }
  }
}

// Turns and mirrors of the body's axes: 6 orders times 8 octants. ω and the vector of q are pseudovectors.
struct SignedPermutation {
  std::array<int, 3> axes;
  Vec3 signs;

  PrincipalMoments of(const PrincipalMoments& I) const { return {I[axes[0]], I[axes[1]], I[axes[2]]}; }
  Vec3 of_pseudovector(const Vec3& v) const {
    const double parity = (axes[0] + 1) % 3 == axes[1] ? 1 : -1;
    return parity * signs.prod() * signs.cwiseProduct(Vec3(v[axes[0]], v[axes[1]], v[axes[2]]));
  }
  RigidBodyState of(const RigidBodyState& x) const {
    const Vec3 v = of_pseudovector(x.q_SB.vec());
    return {Quat(x.q_SB.w(), v[0], v[1], v[2]), of_pseudovector(x.w_B)};
  }
};

std::vector<SignedPermutation> all_signed_permutations() {
  std::vector<SignedPermutation> all;
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int octant = 0; octant < 8; ++octant)
      all.push_back({axes, Vec3(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1)});
  } while (std::next_permutation(axes.begin(), axes.end()));
  return all;
}

// Both bodies are computed by the same numbers but for the order in which |L|² is summed.
TEST(ExactProperties, DoNotDependOnTheOrderAndTheSenseOfTheAxes) {
  Random random(104);
  const auto all = all_signed_permutations();
  ASSERT_EQ(all.size(), 48u);
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = some_moments(random);
    const RigidBodyState start{random.attitude(), some_w(random)};
    const double t = random.uniform(-10, 10);
    const RigidBodyState plain = exact_motion(I, start)->at(t);
    const double turned = 4 * start.w_B.norm() * std::abs(t);  // no rate exceeds 4|ω|
    for (const SignedPermutation& p : all) {
      const RigidBodyState state = exact_motion(p.of(I), p.of(start))->at(t);
      ASSERT_LE(test::w_error(state.w_B, p.of(plain).w_B), 8 * kEps * (1 + turned)) << i;
      ASSERT_LE(test::q_error(state.q_SB, p.of(plain).q_SB), 8 * kEps * (1 + turned)) << i;
    }
  }
}

TEST(ExactProperties, TurningTheStartTurnsTheMotion) {
  Random random(105);
  for (int i = 0; i < 2000; ++i) {
    const PrincipalMoments I = some_moments(random);
    const Vec3 w_B = some_w(random);
    const Quat q_SB = random.attitude();
    const double t = random.uniform(-100, 100);
    const RigidBodyState plain = exact_motion(I, {Quat::Identity(), w_B})->at(t);
    const RigidBodyState turned = exact_motion(I, {q_SB, w_B})->at(t);
    ASSERT_LE(test::q_error(turned.q_SB, q_SB * plain.q_SB), 16 * kEps) << i;
    ASSERT_EQ(turned.w_B, plain.w_B) << i;
  }
}

TEST(ExactProperties, RunBackwardsAsForwards) {
  Random random(106);
  for (int i = 0; i < 2000; ++i) {
    const PrincipalMoments I = some_moments(random);
    const RigidBodyState start{random.attitude(), some_w(random)};
    const double t = random.uniform(-10, 10);
    const RigidBodyState plain = exact_motion(I, start)->at(t);
    const RigidBodyState reversed = exact_motion(I, {start.q_SB, -start.w_B})->at(-t);
    const double turned = 4 * start.w_B.norm() * std::abs(t);
    ASSERT_LE(test::w_error(-reversed.w_B, plain.w_B), 8 * kEps * (1 + turned)) << i;
    ASSERT_LE(test::q_error(reversed.q_SB, plain.q_SB), 8 * kEps * (1 + turned)) << i;
  }
}

// at(t1 + t2) from a restart at t1. ω(t1) is rounded, which the motion from there on multiplies by its
// condition number: bounded for bodies with k' > 0.1, that is for moments and rates that are not nearly on
// the separatrix.
TEST(ExactProperties, RestartedOnTheWayGoOnTheSame) {
  Random random(107);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(0.5, 1);
    const PrincipalMoments I = moments_of({x, x + random.uniform(0.1, 0.3), x + random.uniform(0.4, 0.5)});
    const double side = random.uniform(0, 1) < 0.5 ? 0 : 1;  // about the greatest or the least axis
    const RigidBodyState start{random.attitude(),
                               Vec3(0.1 + 1.5 * side, random.uniform(-0.5, 0.5), 1.6 - 1.5 * side)};
    const auto motion = exact_motion(I, start);
    const double t1 = random.uniform(-5, 5), t2 = random.uniform(-5, 5);
    const RigidBodyState direct = motion->at(t1 + t2);
    const RigidBodyState relayed = exact_motion(I, motion->at(t1))->at(t2);
    const double cond =
        100 * 1.7 * 5;  // 30/δ per period, δ > 0.1, and the angle turned, of at most a few periods
    ASSERT_LE(test::w_error(relayed.w_B, direct.w_B), 4 * kEps * cond) << i;
    ASSERT_LE(test::q_error(relayed.q_SB, direct.q_SB), 4 * kEps * cond) << i;
  }
}

}  // namespace
}  // namespace polhode
