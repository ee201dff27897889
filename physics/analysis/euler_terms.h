// SPDX-License-Identifier: MIT
// The terms of Euler's equation, I·ω̇ + ω×(I·ω) = N, on a motion.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/body/torque.h"
#include "physics/motion.h"

namespace polhode {

/// N m, body components.
struct EulerTerms {
  Vec3 inertial_B;    ///< I·ω̇
  Vec3 gyroscopic_B;  ///< ω×(I·ω)
  Vec3 N_B;
  double largest() const;  ///< norm of the longest
};

/// ω̇ is the difference quotient of the motion (derivative_at), so that the sum is N only as far as the motion
/// obeys (6): to some 1e-12 of the longest term where it is exact, to the error of the method where it is
/// not. Friction inside the body (EnergySink) is outside (6), and leaves a gap.
EulerTerms euler_terms_at(const Motion& motion, const PrincipalMoments& I, const Torque& torque, double t_s);

}  // namespace polhode
