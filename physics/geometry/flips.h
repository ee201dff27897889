// SPDX-License-Identifier: MIT
// When a body that turns about its intermediate axis turns over.
//
// A flip is a passage of L's component along the intermediate axis, of the moment I_b with I_a < I_b < I_c,
// through zero, on a polhode that leads L nearer to that axis than kFlipsNearer, |L_b|/|L|. Others only
// wobble. On the polhode L_b is largest where the smaller of two wobbles ends,
//
//     L_b² = min( I_b (2T I_c − L²)/(I_c − I_b), I_b (L² − 2T I_a)/(I_b − I_a) ),
//
// and at the passage, where ω_b = 0, that is I_b (I_c − I_a) min( I_a ω_a²/(I_c − I_b), I_c ω_c²/(I_b − I_a)
// ): ω at the passage decides. Under torque it is the polhode that ω would follow if the torque ended there.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/motion.h"

#include <vector>

namespace polhode {

inline constexpr double kFlipsNearer = 0.9;

/// Times in [from_s, to_s], rising, to 1e-14 of the interval. None where two moments are equal,
/// and where the motion cannot be computed. Two flips nearer to each other than 1/500 of the interval may be
/// missed. Some 500 evaluations of ω, and 40 a flip.
std::vector<double> flip_times(const Motion& motion, const PrincipalMoments& moments, double from_s,
                               double to_s);

}  // namespace polhode
