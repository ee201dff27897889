// SPDX-License-Identifier: MIT
#include "physics/exact/polhode_constants.h"

#include "physics/exact/powers_of_two.h"
#include "physics/exact/uniform_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

// Unevaluated sum hi + lo, |lo| ≤ ε|hi|: Dekker 1971; fma gives the exact rounding error of a product.
struct DoubleDouble {
  double hi, lo;
};

DoubleDouble two_sum(double x, double y) {
  const double sum = x + y;
  const double y_part = sum - x;
  return {sum, (x - (sum - y_part)) + (y - y_part)};
}

DoubleDouble times(DoubleDouble x, double y) {
  const double product = x.hi * y;
  return two_sum(product, std::fma(x.hi, y, -product) + x.lo * y);
}

DoubleDouble minus(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble high = two_sum(x.hi, -y.hi);
  const DoubleDouble low = two_sum(x.lo, -y.lo);
  const DoubleDouble sum = two_sum(high.hi, high.lo + low.hi);
  return two_sum(sum.hi, sum.lo + low.lo);
}

// I_far |I_far − I_mid| ω²: one half of D.
DoubleDouble half_of_D(double I_far, double I_mid, double w) {
  const DoubleDouble difference = two_sum(std::max(I_far, I_mid), -std::min(I_far, I_mid));
  return times(times(times(difference, I_far), w), w);
}

struct Side {
  double sign;    // of D
  Extended size;  // |D|
};

// D = I3(I3 − I2)ω3² − I1(I2 − I1)ω1² of moments and ω in ascending order of the moments. Double-double has
// the range of double: the moments, and ω1 and ω3, are scaled by powers of two of their own.
Side side_of_separatrix(const Vec3& I, const Vec3& w) {
  const Vec3 w_outer(w[0], 0, w[2]);
  const int e_I = exponent_of(I), e_w = w_outer.isZero(0.0) ? 0 : exponent_of(w_outer);
  const Vec3 J = times_two_to(-e_I, I), v = times_two_to(-e_w, w_outer);
  const DoubleDouble D = minus(half_of_D(J[2], J[1], v[2]), half_of_D(J[0], J[1], v[0]));
  const double sign = D.hi == 0 ? 0.0 : std::copysign(1.0, D.hi);
  return {sign, std::scalbn(std::abs(Extended{D.hi} + D.lo), 2 * (e_I + e_w))};
}

// In Extended no product leaves the range.
PolhodeConstants constants(const PrincipalMoments& I, const Vec3& w_B, const std::array<int, 3>& axes) {
  const Side side =
      side_of_separatrix({I[axes[0]], I[axes[1]], I[axes[2]]}, {w_B[axes[0]], w_B[axes[1]], w_B[axes[2]]});
  PolhodeConstants p;
  p.sigma = side.sign < 0 ? -1.0 : 1.0;
  p.a = side.sign < 0 ? axes[2] : axes[0];
  p.b = axes[1];
  p.c = side.sign < 0 ? axes[0] : axes[2];
  p.sign_c = w_B[p.c] < 0 ? -1.0 : 1.0;
  p.sign_b = parity(p.a, p.b) * p.sign_c;

  const Extended I_a = I[p.a], I_b = I[p.b], I_c = I[p.c];
  const Extended d_ca = std::abs(I_c - I_a), d_cb = std::abs(I_c - I_b), d_ba = std::abs(I_b - I_a);
  const auto squared = [](Extended x) { return x * x; };
  const Extended P2 = I_a * d_ca * squared(w_B[p.a]) + I_b * d_cb * squared(w_B[p.b]);
  const Extended R2 = I_b * d_ba * squared(w_B[p.b]) + I_c * d_ca * squared(w_B[p.c]);
  p.A = std::sqrt(P2 / (I_a * d_ca));
  p.B = std::sqrt(P2 / (I_b * d_cb));
  p.C = std::sqrt(R2 / (I_c * d_ca));
  p.k = std::min(Extended{1}, std::sqrt(P2 * d_ba / (R2 * d_cb)));
  p.kp = std::min(Extended{1}, std::sqrt(side.size * d_ca / (R2 * d_cb)));
  p.lambda = std::sqrt(R2 * d_cb / (I_a * I_b * I_c));
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
