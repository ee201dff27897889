// SPDX-License-Identifier: MIT
// Five terms of a theta function as polynomials: one sine and cosine then serve all of them, and zeros keep
// their relative accuracy. DLMF 18.5.1, 18.5.2.
#pragma once

#include <array>

namespace polhode {

using ThetaSeries = std::array<double, 5>;  ///< coefficients n = 0 … 4

/// Σ c_n sin((2n+1)x)/sin x as a polynomial in sin²x; Σ (−1)ⁿ c_n cos((2n+1)x)/cos x in cos²x.
inline ThetaSeries odd_harmonics(const ThetaSeries& c) {
  return {c[0] + 3 * c[1] + 5 * c[2] + 7 * c[3] + 9 * c[4], -4 * c[1] - 20 * c[2] - 56 * c[3] - 120 * c[4],
          16 * c[2] + 112 * c[3] + 432 * c[4], -64 * c[3] - 576 * c[4], 256 * c[4]};
}

/// Σ c_n cos(2nx) as a polynomial in sin²x; Σ (−1)ⁿ c_n cos(2nx) in cos²x.
inline ThetaSeries even_harmonics(const ThetaSeries& c) {
  return {c[0] + c[1] + c[2] + c[3] + c[4], -2 * c[1] - 8 * c[2] - 18 * c[3] - 32 * c[4],
          8 * c[2] + 48 * c[3] + 160 * c[4], -32 * c[3] - 256 * c[4], 128 * c[4]};
}

}  // namespace polhode
