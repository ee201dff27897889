// SPDX-License-Identifier: MIT
// What a symmetric top does, in closed form: rates of precession and nutation, free and under gravity.
// Goldstein, Classical Mechanics, 3rd ed., §5.6-5.7; Landau & Lifshitz, Mechanics, §33 and §35.
#pragma once

#include "physics/body/problem.h"

#include <optional>

namespace polhode {

/// Moments count as equal within this part: of what an author writes with nine digits.
inline constexpr double kEqualMoments = 1e-9;

/// Free symmetric top: its axis turns about L at |L|/I1, seen from space, ω about the axis at (I3 − I1)/I1
/// ω3, seen from the body (positive: in the sense from axis 1 to 2, and cyclic). I3 is the moment about the
/// axis.
struct FreePrecession {
  int axis = 2;         ///< of symmetry: 0, 1, 2
  double in_space = 0;  ///< |L|/I1, rad/s
  double in_body = 0;   ///< (I3 − I1)/I1 ω3, rad/s
};
/// Nothing unless just two moments are equal.
std::optional<FreePrecession> free_precession(const PrincipalMoments& I, const Vec3& w_B);

/// A symmetric top with a fixed point on its axis, under gravity alone. θ = 0: its centre of mass is right
/// above the point.
struct SymmetricTop {
  double I1 = 0, I3 = 0;        ///< kg m² about the point, across the axis and along it
  double mgl = 0;               ///< N m, > 0
  Vec3 axis_B = Vec3::UnitZ();  ///< unit, from the point to the centre of mass
};
/// Of the HeavyTops in `torque`; other terms are passed over. Nothing if they weigh nothing, their centre of
/// mass lies on no principal axis, or the moments about the two others differ.
std::optional<SymmetricTop> symmetric_top(const PrincipalMoments& I, const Torque& torque);

/// Steady precession about the vertical at θ and ω3 = ω·axis: the roots Ω of
///
///     I1 cosθ Ω² − I3 ω3 Ω + mgl = 0.
struct SteadyPrecession {
  double slow = 0;             ///< rad/s; the root of smaller |Ω|
  std::optional<double> fast;  ///< nothing where the axis is level, cosθ = 0: there is one root
};
/// Nothing if no root is real. |cosθ| ≤ 2⁻⁵² counts as level: it is what π/2 in double has. Error: some ε of
/// the discriminant.
std::optional<SteadyPrecession> steady_precession(const SymmetricTop& top, double cos_theta, double w3);
/// The least |ω3| at which there is one, rad/s: √(4 I1 mgl cosθ)/I3; 0 for an axis that hangs or is level.
double least_spin(const SymmetricTop& top, double cos_theta);

/// Nutation: u = cosθ swings between two roots of u̇² = f(u),
///
///     f(u) = (1 − u²)(α − βu) − (b − au)²,   β = 2 mgl/I1,   a = I3 ω3/I1,   b = L_z/I1,
///
/// u1 ≤ u2 ≤ 1 ≤ u3, as u1 + (u2 − u1) sn²: the period is 4 K(k)/√(β(u3 − u1)), k² = (u2 − u1)/(u3 − u1).
/// Where the top precesses steadily, or sleeps, u1 = u2, and that is the period of a small nutation.
struct Nutation {
  double theta_least_rad = 0, theta_most_rad = 0;  ///< turning points
  double rate = 0;                                 ///< 2π/period, rad/s
};
/// Of the motion through this state. Nothing where it has no period: on the way to the upright position, or
/// balanced there without the spin to keep it. Error of the rate: about 1e-7 of it close to steady
/// precession, where two roots meet, else some 1e-14.
std::optional<Nutation> nutation(const SymmetricTop& top, const RigidBodyState& state);

}  // namespace polhode
