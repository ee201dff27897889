// SPDX-License-Identifier: MIT
// Euler's angles z-x-z, as books on tops have them: Goldstein, Classical Mechanics, 3rd ed., §4.4; Landau &
// Lifshitz, Mechanics, §35.
#pragma once

#include "physics/body/types.h"

namespace polhode {

/// R_SB = R_z(φ) R_x(θ) R_z(ψ), rad: θ is the angle of axis 3 from the vertical z of space, φ − π/2 the
/// azimuth of axis 3 from x, ψ the turn about axis 3. e3 = (sinθ sinφ, −sinθ cosφ, cosθ) in space.
struct EulerAngles {
  double phi_rad = 0, theta_rad = 0, psi_rad = 0;
};

Quat attitude_of(const EulerAngles& angles);

/// θ in [0, π], φ and ψ in [−π, π]. Where axis 3 is vertical only φ + ψ, or φ − ψ, is defined; ψ is then 0.
/// A few ε, also close to there.
EulerAngles euler_angles_of(const Quat& q_SB);

/// ω_B of the rates φ̇ and θ̇, and of ω3 itself: φ̇ (sinθ sinψ, sinθ cosψ, 0) + θ̇ (cosψ, −sinψ, 0) + ω3 e3.
Vec3 w_B_of(const EulerAngles& angles, double phi_rate, double theta_rate, double w3);

}  // namespace polhode
