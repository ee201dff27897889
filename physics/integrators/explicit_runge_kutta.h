// SPDX-License-Identifier: MIT
// Explicit Runge-Kutta methods of fixed step: any body, any torque.
//
//     method              order   evaluations   keeps
//     explicit Euler        1         1         nothing
//     explicit midpoint     2         2         nothing
//     RK4 (classical)       4         4         nothing
//     RK4, projected        4         4         T, |L|, |q|
//
// Kutta, Z. Math. Phys. 46 (1901) 435-453; Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations
// I, 2nd ed., §II.1: midpoint (1.4), RK4 table 1.2. State y = (ω_B, q_SB), equations of euler.h, torque of
// torque.h. T, |L| and |q| drift with the order of the error, L in space too, and none is reversible: h, then
// −h, does not come back. q̇ is linear in q, so the drift of |q| changes no direction (it is scaled by powers
// of two, which is exact, lest it overflow), and a torque that depends on attitude uses q/|q|.
//
// Projection (torque-free only) is the standard one of Hairer, Lubich & Wanner, Geometric Numerical
// Integration, 2nd ed., algorithm IV.4.2: after each step ω goes to the nearest point with the T and L² of
// the start, to first order within span(∇T, ∇L²), by at most four steps of Newton's method; and q to q/|q|. T
// and L² are told by T and D_j = Σ I_i (I_i − I_j) ω_i² = L² − 2T I_j, j the axis with most of L: near a
// steady rotation T and L² say almost the same and D_j, a sum of small terms, is the difference. L in space
// is not kept: the direction of L in space moves with the error of q.
//
// A step costs about 10, 16, 40 and 70 ns without torque. Time, access and range: fixed_step_motion.h. For
// any h there is an answer, until ω or q overflows; from there on it is NaN.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/motion.h"

#include <memory>

namespace polhode {

/// @throws std::domain_error if checked(Problem) refuses it, the step is not finite and > 0, or
/// rk4_projected_motion is given a torque.
std::unique_ptr<const Motion> explicit_euler_motion(const Problem& problem, double step_s,
                                                    const Effort& effort = {});
std::unique_ptr<const Motion> explicit_midpoint_motion(const Problem& problem, double step_s,
                                                       const Effort& effort = {});
std::unique_ptr<const Motion> rk4_motion(const Problem& problem, double step_s, const Effort& effort = {});
std::unique_ptr<const Motion> rk4_projected_motion(const Problem& problem, double step_s,
                                                   const Effort& effort = {});

}  // namespace polhode
