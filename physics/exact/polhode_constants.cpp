// SPDX-License-Identifier: MIT
#include "physics/exact/polhode_constants.h"

#include "physics/exact/uniform_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

// I_far |I_far − I_mid| ω²: one half of D.
DoubleDouble half_of_D(DoubleDouble I_far, DoubleDouble I_mid, DoubleDouble w) {
  return abs(I_far - I_mid) * I_far * w * w;
}

// D = I3(I3 − I2)ω3² − I1(I2 − I1)ω1² of moments and ω in ascending order of the moments.
DoubleDouble signed_distance_from_separatrix(const Vec3& I, const Vec3& w) {
  return half_of_D(I[2], I[1], w[2]) - half_of_D(I[0], I[1], w[0]);
}

// In Extended no product leaves the range.
PolhodeConstants constants(const PrincipalMoments& I, const Vec3& w_B, const std::array<int, 3>& axes) {
  const DoubleDouble D = signed_distance_from_separatrix({I[axes[0]], I[axes[1]], I[axes[2]]},
                                                         {w_B[axes[0]], w_B[axes[1]], w_B[axes[2]]});
  const bool about_smallest = D < 0;
  PolhodeConstants p;
  p.sigma = about_smallest ? -1.0 : 1.0;
  p.a = about_smallest ? axes[2] : axes[0];
  p.b = axes[1];
  p.c = about_smallest ? axes[0] : axes[2];
  p.sign_c = w_B[p.c] < 0 ? -1.0 : 1.0;
  p.sign_b = parity(p.a, p.b) * p.sign_c;

  const Extended I_a = I[p.a], I_b = I[p.b], I_c = I[p.c];
  const Extended d_ca = abs(I_c - I_a), d_cb = abs(I_c - I_b), d_ba = abs(I_b - I_a);
  const auto squared = [](Extended x) { return x * x; };
  const Extended P2 = I_a * d_ca * squared(w_B[p.a]) + I_b * d_cb * squared(w_B[p.b]);
  const Extended R2 = I_b * d_ba * squared(w_B[p.b]) + I_c * d_ca * squared(w_B[p.c]);
  p.A = sqrt(P2 / (I_a * d_ca));
  p.B = sqrt(P2 / (I_b * d_cb));
  p.C = sqrt(R2 / (I_c * d_ca));
  p.k = std::min(Extended{1}, sqrt(P2 * d_ba / (R2 * d_cb)));
  p.kp = std::min(Extended{1}, sqrt(to_extended(abs(D)) * d_ca / (R2 * d_cb)));
  p.lambda = sqrt(R2 * d_cb / (I_a * I_b * I_c));
  return p;
}

}  // namespace

std::array<int, 3> sorted_axes(const PrincipalMoments& I) {
  std::array<int, 3> axes{0, 1, 2};
  for (const std::size_t i : {0u, 1u, 0u})  // bubble sort, which is stable
    if (I[axes[i + 1]] < I[axes[i]]) std::swap(axes[i], axes[i + 1]);
  return axes;
}

double parity(int a, int b) { return (a + 1) % 3 == b ? 1.0 : -1.0; }

std::optional<PolhodeConstants> polhode_constants(const PrincipalMoments& I, const Vec3& w_B) {
  if (is_steady(I, w_B)) return std::nullopt;
  return constants(I, w_B, sorted_axes(I));
}

}  // namespace polhode
