// SPDX-License-Identifier: MIT
// Random bodies and rates over the whole range of double, and beside every special case: no NaN, no
// exception, no motion that loses T or L. Seeds are fixed.
#include "physics/analysis/conditioning.h"
#include "physics/geometry/poinsot.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

double any_size(Random& random) {
  return std::scalbn(random.uniform(0.5, 1), random.uniform_int(-1073, 1024));
}
double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, random.uniform(low, high));
}

Vec3 moments_of_some_kind(Random& random) {
  const double scale = any_size(random), b = scale * random.uniform(0.5, 1);
  const double next = std::nextafter(b, kMax);
  switch (random.uniform_int(0, 9)) {
    case 0:  // any two sizes
      return {b, any_size(random), b};
    case 1: {  // needle
      const double thin = b * power_of_ten(random, -17, 0);
      return {thin, b, b + thin * random.uniform(-1, 1)};
    }
    case 2:  // nearly symmetric
      return {b, next, b * random.uniform(0.01, 1.99)};
    case 3:  // nearly symmetric needle
      return {b, next, b * power_of_ten(random, -17, 0)};
    case 4:  // near-sphere
      return {b, next, std::nextafter(b, 0)};
    case 5:  // symmetric
      return {b, b, b * power_of_ten(random, -320, 0.3)};
    case 6: {  // flat
      const double c = scale * random.uniform(0.01, 1);
      return {b / 2, c / 2, b / 2 + c / 2};
    }
    case 7:  // few bits
      return Vec3(random.uniform_int(1, 4), random.uniform_int(1, 4), random.uniform_int(1, 4)) * kTiny;
    case 8:
      return Vec3(random.uniform(0.3, 1), random.uniform(0.3, 1), random.uniform(0.3, 1)) * kMax;
    default:  // generic
      return Vec3(random.uniform(0.3, 1), random.uniform(0.3, 1), random.uniform(0.3, 1)) * scale;
  }
}

std::optional<PrincipalMoments> some_body(Random& random) {
  Vec3 I = moments_of_some_kind(random);
  std::shuffle(I.data(), I.data() + 3, random.engine());
  if (why_impossible(I[0], I[1], I[2])) return std::nullopt;
  return PrincipalMoments(I[0], I[1], I[2]);
}

// On the separatrix or some ulps from it, where the body has one.
Vec3 w_about_the_separatrix(Random& random, const PrincipalMoments& I, double scale) {
  std::array<int, 3> o{0, 1, 2};
  std::sort(o.begin(), o.end(), [&](int i, int j) { return I[i] < I[j]; });
  const double ratio = std::sqrt(I[o[2]] / I[o[0]]) * std::sqrt((I[o[2]] - I[o[1]]) / (I[o[1]] - I[o[0]]));
  Vec3 w_B;
  w_B[o[1]] = scale * random.uniform(0, 1);
  w_B[o[2]] = scale * random.uniform(0.1, 1);
  w_B[o[0]] = w_B[o[2]] * ratio;
  double& nudged = w_B[random.uniform_int(0, 1) == 0 ? o[0] : o[2]];
  for (int ulps = random.uniform_int(0, 4); ulps > 0; --ulps) nudged = std::nextafter(nudged, kMax);
  return w_B;
}

Vec3 some_w(Random& random, const PrincipalMoments& I) {
  const double scale = any_size(random);
  Vec3 w_B(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  switch (random.uniform_int(0, 6)) {
    case 0:
      w_B = {any_size(random), any_size(random), any_size(random)};
      break;
    case 1:  // nearly steady
      for (double& x : w_B) x *= scale * power_of_ten(random, -320, 0);
      w_B[random.uniform_int(0, 2)] = scale;
      break;
    case 2:  // in a principal plane
      w_B *= scale;
      w_B[random.uniform_int(0, 2)] = 0;
      break;
    case 3:  // few bits
      w_B = Vec3(random.uniform_int(0, 3), random.uniform_int(0, 3), random.uniform_int(0, 3)) * kTiny;
      break;
    case 4:
      w_B *= kMax;
      break;
    case 5:
      w_B = w_about_the_separatrix(random, I, scale);
      break;
    default:
      w_B *= scale;
  }
  for (double& x : w_B)
    if (random.uniform_int(0, 1) == 0) x = -x;
  return w_B.allFinite() ? w_B : Vec3(0, -0.0, 1);
}

void check_state(const PrincipalMoments& I, const RigidBodyState& start, const RigidBodyState& state) {
  ASSERT_NEAR(state.q_SB.norm(), 1, 8 * kEps);
  ASSERT_FALSE(state.w_B.hasNaN());
  if (!state.w_B.allFinite()) {  // none grows more than twofold: the triangle inequality, T and |L|
    ASSERT_GT(start.w_B.cwiseAbs().maxCoeff(), kMax / 4);
    return;
  }
  const test::Drift drift = test::drift(I, start, state);
  ASSERT_LE(drift.T, 4e-15);
  ASSERT_LE(drift.L, 4e-15);
  ASSERT_LE(drift.direction, 1e-14);
}

void check_body(Random& random, const PrincipalMoments& I, const Vec3& w_B) {
  const RigidBodyState start{random.attitude(), w_B};
  const auto motion = test::exact_motion(I, start);
  const double turn = 1 / std::max(w_B.cwiseAbs().maxCoeff(), kTiny);
  const double t_any = any_size(random) * (random.uniform_int(0, 1) == 0 ? 1 : -1);
  for (const double t : {0.0, t_any, 3.3 * turn, std::max(-1e9 * turn, -kMax), kMax})
    ASSERT_NO_FATAL_FAILURE(check_state(I, start, motion->at(t))) << "t = " << t;
  const auto number = conditioning(I, w_B);
  ASSERT_TRUE(!number || number->phase_per_period > 0);
  const auto P = polhode_period(I, w_B);
  ASSERT_TRUE(!P || *P > 0);
}

TEST(ExtremesFuzz, EveryPossibleBodyMoves) {
  Random random(2026);
  int bodies = 0;
  while (bodies < 200'000) {
    const auto I = some_body(random);
    if (!I) continue;
    const Vec3 w_B = some_w(random, *I);
    ++bodies;
    ASSERT_NO_FATAL_FAILURE(check_body(random, *I, w_B))
        << std::hexfloat << "I " << I->vector().transpose() << " w " << w_B.transpose();
  }
}

}  // namespace
}  // namespace polhode
