// SPDX-License-Identifier: MIT
// Elliptic integrals in the forms the exact motion needs: every one takes the complementary modulus k' (or
// square roots of Carlson's arguments), so that nothing is lost where k → 1 or k' → 0. k² + k'² = 1.
//
// Constants of a motion are computed in Extended precision and rounded once: their errors are multiplied by
// the number of periods, and there are only some dozens of them. η = 2⁻⁶⁴ is the roundoff of x87, at which
// the iterations and series stop, also where Extended has more bits.
#pragma once

#include "physics/exact/extended.h"

namespace polhode {

/// K(k) = ∫₀^{π/2} dθ/√(1 − k² sin²θ) = π/(2 AGM(1, k')), the quarter period of sn; DLMF 19.8.5. k' in (0,
/// 1]; at most kMaxAgmSteps steps, relative error 4η.
Extended complete_elliptic_K(Extended kp);
inline constexpr int kMaxAgmSteps = 24;

/// R_F(x², y², z²) = ½ ∫₀^∞ ds/√((s + x²)(s + y²)(s + z²)), Carlson's symmetric integral of the first kind,
/// of the square roots x, y, z ≥ 0, at most one of them zero; DLMF 19.16.1. Roots, because x² of 10⁻³⁰⁰
/// underflows and R_F does not. Carlson, Numer. Algorithms 10 (1995) 13-26: duplication (DLMF 19.26.18), then
/// the series DLMF 19.36.1. z about 1 (R_F is homogeneous of degree −1). Relative error 4η; 5 to 20
/// duplications, 3 roots each.
Extended carlson_RF_of_squares(Extended x, Extended y, Extended z);

/// cel(k', p, a, b) = ∫₀^{π/2} (a cos²θ + b sin²θ)/(cos²θ + p sin²θ) · dθ/√(cos²θ + k'² sin²θ), Bulirsch's
/// general complete integral: Numer. Math. 13 (1969) 305-315; DLMF 19.2.11. k' > 0, p > 0 and a, b ≥ 0: every
/// sum has positive terms, so nothing cancels. Given √p and b/√p, which stay in range where p does not.
/// Relative error 4η.
Extended bulirsch_cel(Extended kp, Extended root_p, Extended a, Extended b_over_root_p);

}  // namespace polhode
