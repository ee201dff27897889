// SPDX-License-Identifier: MIT
// When a body that turns about its intermediate axis turns over.
//
// Let I_a < I_b < I_c. A flip is a time at which L_b, the component of L along the intermediate axis, passes
// through zero, on a polhode that elsewhere takes L close to that axis: |L_b|/|L| > kFlipsNearer. On other
// polhodes L_b passes through zero too, but the body only wobbles. The largest L_b of a polhode follows from
// T and L,
//
//     L_b² = min( I_b (2T I_c − L²)/(I_c − I_b), I_b (L² − 2T I_a)/(I_b − I_a) ),
//
// which at the passage, where ω_b = 0, is
//
//     L_b² = I_b (I_c − I_a) min( I_a ω_a²/(I_c − I_b), I_c ω_c²/(I_b − I_a) ),
//
// so that ω at the passage decides. Under a torque the polhode meant is the one that ω would follow if the
// torque ended there.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/motion.h"

#include <vector>

namespace polhode {

inline constexpr double kFlipsNearer = 0.9;

/// Whether a body that turns freely with this ω flips, again and again: its polhode goes from one end of the
/// intermediate axis to the other. On the separatrix, where it would do so once, it does not.
bool keeps_flipping(const PrincipalMoments& moments, const Vec3& w_B);

/// Times in [from_s, to_s], rising, to 1e-14 of the interval. None where two moments are equal,
/// and where the motion cannot be computed. Two flips nearer to each other than 1/500 of the interval may be
/// missed. Some 500 evaluations of ω, and 40 a flip.
std::vector<double> flip_times(const Motion& motion, const PrincipalMoments& moments, double from_s,
                               double to_s);

}  // namespace polhode
