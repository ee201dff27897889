// SPDX-License-Identifier: MIT
// The implicit midpoint rule for the free rigid body.
// Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed., §II.1 eq. (1.18); quadratic invariants:
// theorem IV.2.1; attitude by the Cayley map: Lewis & Simo, J. Nonlinear Sci. 4 (1994) 253-299; Austin,
// Krishnaprasad & Wang, J. Comput. Phys. 107 (1993) 105-117.
//
//     I (ω' − ω) = h (I ω̄)×ω̄,   ω̄ = ½(ω + ω'),
//     implicit-midpoint:       q' = q ⊗ (1, ½hω̄)/√(1 + ¼h²|ω̄|²)    (Cayley)
//     implicit-midpoint-exp:   q' = q ⊗ exp(½hω̄)
//
// Order 2. Keeps T and |L| to rounding, being quadratic in ω: the equation is solved to rounding. With the
// Cayley map L stands still in space too: the rotation by 2 atan(½h|ω̄|) about ω̄ takes L'_B to L_B exactly,
// since L' − L = ½h (L + L')×ω̄. With the exponential map it does not: the direction of L errs with O(h²).
// Keeps |q|. Reversible.
//
// A step costs 1 to 3 evaluations, one residual and its corrections (midpoint_equation.h), about 65 ns, 80
// with the exponential. The equation has a root for every h, since |Iω̄| ≤ |L| whatever h is, but only while
// h|ω| is well below 1 is it surely the one that goes to ω as h → 0. Where Newton's method finds none within
// 60 rounds, the answer is NaN from there on.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/motion.h"

#include <memory>

namespace polhode {

/// @throws std::domain_error if the state is not finite, the step is not finite and > 0, or there is a
/// torque.
std::unique_ptr<const Motion> implicit_midpoint_motion(const Problem& problem, double step_s,
                                                       const Effort& effort = {});
std::unique_ptr<const Motion> implicit_midpoint_exp_motion(const Problem& problem, double step_s,
                                                           const Effort& effort = {});

}  // namespace polhode
