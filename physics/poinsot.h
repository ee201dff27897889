// SPDX-License-Identifier: MIT
// Poinsot's construction: the curves and surfaces of torque-free motion, as closed forms and polylines.
#pragma once

#include <optional>
#include <vector>

#include "physics/motion.h"
#include "physics/principal_moments.h"

namespace polhode {

/// A polyline whose distance from the true curve is at most the chord tolerance it was asked with.
struct Curve {
  std::vector<Vec3> points;  ///< frame and unit are the maker's
  bool closed = false;       ///< the last point joins the first, which is not repeated
};

/// Semi-axes √(2T/I_i) of the energy ellipsoid Σ I_i ω_i² = 2T, rad/s, body axes.
Vec3 energy_ellipsoid_semi_axes(const PrincipalMoments& I, double two_T);

/// Semi-axes √(2T I_i) of the momentum ellipsoid Σ L_i²/I_i = 2T, kg m²/s, body axes. The momentum sphere has
/// radius |L|.
Vec3 momentum_ellipsoid_semi_axes(const PrincipalMoments& I, double two_T);

/// Distance 2T/|L| of the invariable plane ω·L = 2T from the centre, rad/s (ω-space).
double invariable_plane_distance(const PrincipalMoments& I, const Vec3& w_B);

/// The polhode through w_B: the component of {Σ I_i ω_i² = 2T} ∩ {Σ I_i² ω_i² = L²} that holds w_B, in ω-space,
/// body axes, rad/s. Closed form, no integration. A steady state gives one point; a separatrix state its branch's
/// whole ellipse.
Curve polhode(const PrincipalMoments& I, const Vec3& w_B, double chord_tolerance);

struct PolhodeOfFamily {
  double L2_over_2T;            ///< kg m², between I_min and I_max
  std::vector<Curve> branches;  ///< one or two, mirror images
};
/// Polhodes of the same energy for the given L²/2T, each strictly between the extreme moments.
std::vector<PolhodeOfFamily> polhode_family(const PrincipalMoments& I, double two_T,
                                            const std::vector<double>& L2_over_2T, double chord_tolerance);

/// The two plane ellipses L² = 2T·I_mid that part the polhodes about I_min from those about I_max; empty if two
/// moments are equal.
std::vector<Curve> separatrices(const PrincipalMoments& I, double two_T, double chord_tolerance);

/// ω's tip in space over [t0_s, t1_s], rad/s, S components: the herpolhode if the motion is torque-free.
Curve herpolhode(const Motion& motion, double t0_s, double t1_s, double chord_tolerance);

/// Period of the polhode, 4K(k)/λ, s; empty for steady rotation, on the separatrix.
std::optional<double> polhode_period(const PrincipalMoments& I, const Vec3& w_B);

}  // namespace polhode
