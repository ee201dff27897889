// SPDX-License-Identifier: MIT
// When a body that turns about its intermediate axis turns over.
#pragma once

#include "physics/principal_moments.h"
#include "physics/motion.h"

#include <vector>

namespace polhode {

/// A flip is a passage of L's component along the intermediate axis through zero, of a body whose L comes
/// nearer than kFlipsNearer to that axis before or after it: |L_mid|/|L| there. Others only wobble.
inline constexpr double kFlipsNearer = 0.9;

/// Times in [from_s, to_s], rising, to about 1e-9 of the interval; at most 1000. None where two moments are
/// equal, and where the motion cannot be computed. Some 500 evaluations of ω, and 40 a flip.
std::vector<double> flip_times(const Motion& motion, const PrincipalMoments& moments, double from_s,
                               double to_s);

}  // namespace polhode
