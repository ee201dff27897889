// SPDX-License-Identifier: MIT
// How far ahead a motion can be predicted from numbers in double, whatever the method.
//
// After n periods the phase is 2πn P₀/P: a relative change δ_x of the input x moves it by 2πn Σ |∂ln P/∂ln x|
// |δ_x|. Without a polhode period the angle turned takes the place of the phase. P = 4K(k)/λ; with b the
// intermediate axis, c the one whose ω never changes sign, a the third, d_ca = |I_c − I_a| and so on, k' the
// complementary modulus and D = L² − 2T I_b (DLMF 19.4.1, 19.2.11)
//
//     d ln K/d ln k' = −B(k)/K(k),   B = ∫₀^{π/2} cos²θ dθ/√(1 − k² sin²θ) = cel(k', 1, 1, 0),
//     ln k' = ½ ln(|D| d_ca/d_cb) − ln R,   ln λ = ln R + ½ ln(d_cb/(I_a I_b I_c)),
//     R² = I_b d_ba ω_b² + I_c d_ca ω_c²,   D = ±(I_c d_cb ω_c² − I_a d_ba ω_a²),
//
// so near the separatrix, at relative distance δ, the number grows as 1/δ. That is a property of the motion;
// no method can do better.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/body/problem.h"

#include <optional>

namespace polhode {

struct Conditioning {
  /// rad by which the phase after one period moves when each of I1, I2, I3, ω1, ω2, ω3 is changed by a
  /// relative amount of 1 in the worst direction (to first order): 2π Σ |∂ln P/∂ln x|.
  double phase_per_period;

  /// Periods after which rounding the inputs to double, a relative change of at most ε = 2⁻⁵³ each, may move
  /// the phase by this many radians. For all but bodies near the separatrix some 10¹¹ for 10⁻³ rad.
  double horizon_periods(double phase_rad) const;
};

/// Conditioning of torque-free motion. The period is that of the polhode; of a symmetric body that of ω about
/// its axis; in steady rotation the time of a turn. Nothing at rest, and on the separatrix, which has no
/// period. Relative accuracy 10⁻¹². Under 1 µs.
std::optional<Conditioning> conditioning(const PrincipalMoments& I, const Vec3& w_B);

/// A bound on the error of the closed forms of torque-free motion (uniform, symmetric, asymmetric) after the
/// time t, both on |Δω|/|ω| and on the angle of Δq in rad:
///
///     ε (4 + 5 (|ω| + |L|/I₂) |t| + κ|t|/P),     ε = 2⁻⁵³, I₂ the middle moment, κ = phase_per_period, P the
///                                                period (without one the last term is 0).
///
/// Four numbers of a quaternion are rounded; five times each angle that it is made of, which for a symmetric
/// body are |L t|/I₂ about L and at most |ω t| about its own axis; and the phase as if each input had been.
/// Held against 112 bodies of known truth (tests/reference) and many thousand symmetric ones. Usually 10 to
/// 50 times the error; near the separatrix far more, because κ speaks of inputs that are known to ε, and the
/// motion takes them as exact.
double closed_form_error(const PrincipalMoments& I, const Vec3& w_B, double t_s);

/// The same of a symmetric top under its weight (physics/exact/lagrange_top.h), |Δω| in parts of the |ω|
/// then:
///
///     4ε(1 + cond),   cond the sum of |x ∂/∂x| over I1, I3, mgl, the components of q and ω, and t, of ω and
///                     of the angle of q, whichever is larger,
///
/// by differences of the motion at inputs 2⁻⁴⁰ of themselves apart: a share of 2⁻¹² of it is rounding. Held
/// against 84 tops of known truth (tests/reference). Some 50 µs.
/// @throws std::domain_error as LagrangeTopMotion does.
double top_error(const Problem& problem, double t_s);

}  // namespace polhode
