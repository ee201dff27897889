// SPDX-License-Identifier: MIT
// Euler's equations of motion of a rigid body and the quantities they speak of.
// Goldstein, Classical Mechanics, 3rd ed., eqs (5.39)-(5.40); Landau & Lifshitz, Mechanics, §36 eq. (36.5).
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/body/state.h"

namespace polhode {

/// L_B = I·ω, kg m²/s, in principal axes.
Vec3 angular_momentum_B(const PrincipalMoments& I, const Vec3& w_B);

/// L_S = R_SB I·ω, kg m²/s.
Vec3 angular_momentum_S(const PrincipalMoments& I, const RigidBodyState& state);

/// T = ½ Σ I_i ω_i², J: energy of rotation.
double kinetic_energy(const PrincipalMoments& I, const Vec3& w_B);

/// ω̇_B, rad/s², from Euler's equations: I1 ω̇1 = (I2 − I3) ω2 ω3 + N1, and cyclic.
Vec3 angular_acceleration_B(const PrincipalMoments& I, const Vec3& w_B, const Vec3& N_B = Vec3::Zero());

}  // namespace polhode
