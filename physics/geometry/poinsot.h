// SPDX-License-Identifier: MIT
// Poinsot's construction: the curves and surfaces of torque-free motion, as closed forms and polylines.
// Poinsot 1834; Goldstein, Classical Mechanics, 3rd ed., §5.6; Landau & Lifshitz, Mechanics, §37.
//
// ω-space and L-space, body axes: ω's tip lies on the energy ellipsoid Σ I_i ω_i² = 2T and on Σ I_i² ω_i² =
// L², and runs along their intersection, the polhode. In S it stays in the invariable plane ω·L = 2T, where
// it draws the herpolhode. Every function is scale-free: no intermediate result overflows unless the answer
// does. Chord tolerances are in rad/s, finite and > 0, otherwise std::domain_error.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/motion.h"

#include <optional>
#include <vector>

namespace polhode {

/// A polyline whose distance from the true curve is at most the chord tolerance it was asked with, and the
/// curve's from it (Hausdorff distance). The tolerance is not taken below 2⁻²⁶ of the curve's size: of the
/// larger of A and B below for polhodes and separatrices, whose tolerance is not below 2⁻⁵⁰ C either (the
/// rounding of a small polhode far out), and of the largest |ω| for herpolhodes.
struct Curve {
  std::vector<Vec3> points;  ///< frame and unit are the maker's
  bool closed = false;       ///< the last point joins the first, which is not repeated
};

/// Semi-axes √(2T/I_i) of the energy ellipsoid Σ I_i ω_i² = 2T, rad/s, body axes. Relative error 2ε.
Vec3 energy_ellipsoid_semi_axes(const PrincipalMoments& I, double two_T);

/// Semi-axes √(2T I_i) of the momentum ellipsoid Σ L_i²/I_i = 2T, kg m²/s, body axes. The momentum sphere has
/// radius |L|. Relative error 2ε.
Vec3 momentum_ellipsoid_semi_axes(const PrincipalMoments& I, double two_T);

/// The same two for the energy of a body that turns with w_B ≠ 0. They may be in range where 2T is not.
Vec3 energy_ellipsoid_semi_axes(const PrincipalMoments& I, const Vec3& w_B);
Vec3 momentum_ellipsoid_semi_axes(const PrincipalMoments& I, const Vec3& w_B);

/// Distance 2T/|L| of the invariable plane ω·L = 2T from the centre, rad/s (ω-space). Zero for ω = 0.
/// Relative error 4ε.
double invariable_plane_distance(const PrincipalMoments& I, const Vec3& w_B);

/// The polhode through w_B: the component of {Σ I_i ω_i² = 2T} ∩ {Σ I_i² ω_i² = L²} that holds w_B, in
/// ω-space, body axes, rad/s. Closed form, no integration: along the axes a, b (intermediate) and c (whose ω
/// never changes sign), with amplitudes A, B, C, signs σ and the complementary modulus k',
///
///     ω = (A cos φ, σB sin φ, C √(cos²φ + k'² sin²φ)),   0 ≤ φ < 2π,
///
/// a positive sum under the root, so the curve keeps its shape next to the separatrix, for needles and for
/// small circles about a steady axis. At least 16 points, the four vertices among them, in the direction of
/// the motion. A steady state gives one point (closed = false); a separatrix state its branch's whole
/// ellipse, on which the motion runs from one end of the intermediate axis to the other along both halves.
/// The same points for every w_B of a polhode, but for rounding.
Curve polhode_curve(const PrincipalMoments& I, const Vec3& w_B, double chord_tolerance);

struct PolhodeOfFamily {
  double L2_over_2T;            ///< kg m², between I_min and I_max
  std::vector<Curve> branches;  ///< two, mirror images; for L2_over_2T = I_mid the separatrices
};

/// Polhodes of the same energy for the given L²/2T, each strictly between the extreme moments. Built from the
/// ratios of differences (I_i − L²/2T)/(I_i − I_j).
/// @throws std::domain_error if a value is not strictly between, or two_T is not finite and > 0.
std::vector<PolhodeOfFamily> polhode_family(const PrincipalMoments& I, double two_T,
                                            const std::vector<double>& L2_over_2T, double chord_tolerance);

/// The same for the energy of a body that turns with w_B ≠ 0. That energy itself may be out of range.
std::vector<PolhodeOfFamily> polhode_family(const PrincipalMoments& I, const Vec3& w_B,
                                            const std::vector<double>& L2_over_2T, double chord_tolerance);

/// The two plane ellipses L² = 2T·I_mid that part the polhodes about I_min from those about I_max; empty if
/// two moments are equal. @throws std::domain_error if two_T is not finite and > 0.
std::vector<Curve> separatrices(const PrincipalMoments& I, double two_T, double chord_tolerance);
/// The same for the energy of a body that turns with w_B ≠ 0.
std::vector<Curve> separatrices(const PrincipalMoments& I, const Vec3& w_B, double chord_tolerance);

/// ω's tip in space over [t0_s, t1_s] (either order), rad/s, S components: the herpolhode if the motion is
/// torque-free. An open curve; one point if ω never leaves the tolerance. Equal pieces of at most ½ rad, at
/// the largest |ω| of nine times, are halved until the chord tolerance is met. There are at most a quarter of
/// kMaxHerpolhodePoints pieces, longer ones if need be, and none is halved once there are half of
/// kMaxHerpolhodePoints points: a longer curve is followed more coarsely. Ends where the motion does
/// (Motion::at gives NaN). Costs three to four times its points in calls of motion.at.
/// @throws std::domain_error if a time is not finite.
Curve herpolhode(const Motion& motion, double t0_s, double t1_s, double chord_tolerance);
inline constexpr int kMaxHerpolhodePoints = 1 << 16;

/// Period of the polhode, 4K(k)/λ, s; for a symmetric top this is 2π/|ν|. Empty for steady rotation and on
/// the separatrix, and if it exceeds the range of double. Relative error a few ε in terms of the moments'
/// differences.
std::optional<double> polhode_period(const PrincipalMoments& I, const Vec3& w_B);

/// When ω's tip has gone k/count of the whole polhode since from_s, for k = 0 … count − 1: times in
/// [from_s, from_s + period_s), where period_s is the polhode's. By then it has gone as far on the
/// herpolhode, for |d*ω/dt| = |dω/dt|: the polhode rolls on it without slipping. Torque-free motion. The
/// speed is that of Euler's equations at motion.w_B_at, which is asked some 2000 times; arc lengths have
/// relative errors of about 1e-9, next to the separatrix too.
/// @throws std::domain_error if a time is not finite, or period_s or count is not > 0.
std::vector<double> equal_arc_times(const Motion& motion, const PrincipalMoments& I, double from_s,
                                    double period_s, int count);

}  // namespace polhode
