// SPDX-License-Identifier: MIT
// Sine, cosine and exponential as straight-line code: no branch, no table, no call. Unlike the C library's
// they are vectorised by the compiler inside a loop without -ffast-math, which is what makes a batch of times
// cheap, and they give the same bits on every machine. Taylor series on a reduced range (DLMF 4.19.1, 4.19.2,
// 4.2.19), the truncation below ε/10.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numbers>

namespace polhode {

// x + 1.5·2⁵² rounds |x| < 2⁵¹ to an integer and leaves it, in two's complement, in the lowest bits.
inline constexpr double kRounder = 0x1.8p52;

/// c0 + c1 z + … by halves (Estrin): a shorter chain of dependent operations than Horner's.
inline double polynomial(const std::array<double, 5>& c, double z) {
  const double z2 = z * z;
  return (c[0] + c[1] * z) + z2 * ((c[2] + c[3] * z) + z2 * c[4]);
}
inline double polynomial(const std::array<double, 8>& c, double z) {
  const double z2 = z * z;
  const double low = (c[0] + c[1] * z) + z2 * (c[2] + c[3] * z);
  const double high = (c[4] + c[5] * z) + z2 * (c[6] + c[7] * z);
  return low + (z2 * z2) * high;
}

struct SinCos {
  double sin, cos;
};

/// sin and cos of y quarter turns (y π/2), |y| ≤ kLargestQuarterTurns = 2⁵⁰. In quarter turns the reduction
/// of y is exact, however large it is. Error ≤ 1.5 ulp, relative also near the zeros.
inline constexpr double kLargestQuarterTurns = 0x1p50;
inline SinCos sincos_quarter_turns(double y) {
  constexpr std::array kSine{-1.0 / 6,
                             1.0 / 120,
                             -1.0 / 5040,
                             1.0 / 362880,
                             -1.0 / 39916800,
                             1.0 / 6227020800.0,
                             -1.0 / 1307674368000.0,
                             1.0 / 355687428096000.0};
  constexpr std::array kCosine{
      -1.0 / 2,       1.0 / 24,          -1.0 / 720,           1.0 / 40320,
      -1.0 / 3628800, 1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};
  const double shifted = y + kRounder;
  const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
  const double x = (y - (shifted - kRounder)) * (std::numbers::pi / 2);  // |x| ≤ π/4
  const double z = x * x;
  const double s = x + x * z * polynomial(kSine, z);
  const double c = 1.0 + z * polynomial(kCosine, z);
  const bool swapped = (quadrant & 1) != 0;
  const double sine = swapped ? c : s;
  const double cosine = swapped ? s : c;
  return {(quadrant & 2) != 0 ? -sine : sine, ((quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

struct Decay {
  double exp;            ///< e^{−x}
  double inverse;        ///< e^{x}
  double one_minus_exp;  ///< 1 − e^{−x}, relative accuracy also for small x
};

/// e^{∓x} for 0 ≤ x ≤ kLastDecay, where they are 10^{∓307}. Error ≤ 2 ulp.
inline constexpr double kLastDecay = 708.0;
inline Decay decay(double x) {
  constexpr double kLn2High = 0x1.62e42fefp-1;  // 32 bits: its product with n is exact
  constexpr double kLn2Low = 0x1.473de6af278edp-34;
  constexpr std::array kCosh{1.0 / 2,       1.0 / 24,          1.0 / 720,           1.0 / 40320,
                             1.0 / 3628800, 1.0 / 479001600.0, 1.0 / 87178291200.0, 0.0};
  constexpr std::array kSinh{1.0 / 6,        1.0 / 120,          1.0 / 5040, 1.0 / 362880,
                             1.0 / 39916800, 1.0 / 6227020800.0, 0.0,        0.0};
  const double shifted = x * std::numbers::log2e + kRounder;
  const double n = shifted - kRounder;
  const double f = (x - n * kLn2High) - n * kLn2Low;  // x = n ln 2 + f, |f| ≤ ½ ln 2
  const double z = f * f;
  const double cosh_minus_1 = z * polynomial(kCosh, z);
  const double sinh = f + f * z * polynomial(kSinh, z);
  const auto bits = std::bit_cast<std::uint64_t>(shifted);
  const double down = std::bit_cast<double>((1023 - bits) << 52);  // 2⁻ⁿ, n ≤ 1022
  const double up = std::bit_cast<double>((1023 + bits) << 52);
  const double expm1 = cosh_minus_1 - sinh;
  return {down + down * expm1, up + up * (cosh_minus_1 + sinh), (1.0 - down) - down * expm1};
}

}  // namespace polhode
