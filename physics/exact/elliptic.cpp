// SPDX-License-Identifier: MIT
#include "physics/exact/elliptic.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr Extended kCloseEnough = 0x1p-33;  // arithmetic and geometric means converge quadratically

}  // namespace

Extended complete_elliptic_K(Extended kp) {
  Extended a = 1.0;
  Extended g = kp;
  for (int i = 0; i < kMaxAgmSteps && abs(a - g) > kCloseEnough * a; ++i) {
    const Extended mean = 0.5L * (a + g);
    g = sqrt(a * g);
    a = mean;
  }
  return kPi / (a + g);  // one more arithmetic mean: the error is squared
}

Extended carlson_RF_of_squares(Extended x, Extended y, Extended z) {
  constexpr int kMaxDuplications = 40;          // 10⁻³⁰⁸ takes 16
  constexpr Extended kCloseForSeries = 0x1p-8;  // which errs by the eighth power
  const Extended third = Extended{1} / 3;
  Extended X = x * x, Y = y * y, Z = z * z, mean = 0;
  for (int i = 0; i < kMaxDuplications; ++i) {
    const Extended lambda = x * y + y * z + z * x;
    X = 0.25L * (X + lambda);
    Y = 0.25L * (Y + lambda);
    Z = 0.25L * (Z + lambda);
    mean = (X + Y + Z) * third;
    if (std::max({X, Y, Z}) - std::min({X, Y, Z}) <= kCloseForSeries * mean) break;
    x = sqrt(X);
    y = sqrt(Y);
    z = sqrt(Z);
  }
  const Extended inverse = 1 / mean, dx = 1 - X * inverse, dy = 1 - Y * inverse, dz = -(dx + dy);
  const Extended E2 = dx * dy - dz * dz, E3 = dx * dy * dz;
  // Beside 1 these terms are below 2⁻¹⁸, so that double precision of their factors is enough.
  const Extended series = 1 - E2 * (1 / 10.0L) + E3 * (1 / 14.0L) + E2 * E2 * (1 / 24.0L) -
                          E2 * E3 * (3 / 44.0L) - E2 * E2 * E2 * (5 / 208.0L) + E3 * E3 * (3 / 104.0L) +
                          E2 * E2 * E3 * (1 / 16.0L);
  return series / sqrt(mean);
}

Extended bulirsch_cel(Extended kp, Extended root_p, Extended a, Extended b_over_root_p) {
  constexpr int kMaxSteps = 24;
  Extended p = root_p, b = b_over_root_p;
  Extended m = 1.0, g = kp, e = kp;  // arithmetic and geometric mean, twice over
  for (int i = 0; i < kMaxSteps; ++i) {
    const Extended a_before = a, ratio = e / p;
    a += b / p;
    b = 2 * (b + a_before * ratio);
    p += ratio;
    const Extended m_before = m;
    m += g;
    if (abs(m_before - g) <= kCloseEnough * m_before) break;
    g = 2 * sqrt(e);
    e = g * m;
  }
  return kPi / 2 * (b + a * m) / (m * (m + p));
}

}  // namespace polhode
