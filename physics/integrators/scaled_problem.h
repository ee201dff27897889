// SPDX-License-Identifier: MIT
// A problem in units of its own, powers of two of SI: what the steppers compute in, so that no square of a
// moment or an angular velocity leaves the range of doubles and results are the same to the bit at any scale.
// Internal to physics/.
#pragma once

#include "physics/body/problem.h"

namespace polhode {

/// I/2^eI, ω/2^ew, N/2^(eI + 2 ew), damping/2^(eI + ew); q as it is. A moment that falls below the normal
/// numbers, 10³⁰⁸ times smaller than its unit, is the smallest of them instead.
Problem in_units(const Problem& problem, int eI, int ew);

struct ScaledProblem {
  Problem problem;  ///< I/2^eI, ω/2^ew, N/2^(eI + 2 ew): the largest moment in [1, 2), and ω too if there is
                    ///< no torque
  int ew;  ///< t·2^ew is its time
};

/// ew is that of |ω| at the start, or of √(N/I) where a torque alone would turn the body faster. Exact,
/// unless a number falls below the range of doubles, 1e300 times smaller than what it stands beside.
ScaledProblem scaled(const Problem& problem);

}  // namespace polhode
