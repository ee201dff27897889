// SPDX-License-Identifier: MIT
// Preprocessed discrete Moser-Veselov integrators of the free rigid body: the best step-by-step methods for
// it. Moser & Veselov, Commun. Math. Phys. 139 (1991) 217-243; quaternion form and the modified inertia:
// Hairer & Vilmart, J. Phys. A 39 (2006) 13225-13235, eqs (5)-(7) and (12).
//
//     c_i = α h m_i/(2 Ĩ_i) + (Ĩ_j − Ĩ_k)/Ĩ_i c_j c_k (cyclic),   α = 1 + |c|²,
//     m_i ← m_i + 4/(hα) (Ĩ_j − Ĩ_k) c_j c_k,   q ← q ⊗ (1, c)/√α,
//
// with m = L_B and the modified moments of moser_veselov_modification.h: order 2 with Ĩ = I, 6 and 10 with
// two and four more terms of their series. T and |L| are invariants of the map, so Ĩ is computed once.
//
// Order 2, 6, 10. Keeps T, L in space and |q|, all to rounding, whatever the order; a Poisson map;
// reversible. A step costs 1 to 3 evaluations, one residual and its corrections (midpoint_equation.h), and 60
// to 80 ns. Order 10 on I = (1, 2, 3), ω = (0.1, 1.5, 0.2): 80 steps a period are good to 6e-9 after 1000
// periods, and 130 to 3e-11.
//
// A step must turn the body by well less than a quarter turn: a steady rotation has a root for h|ω̃| ≤ 1, ω̃ =
// I ω/Ĩ, and the series for Ĩ want h|ω| ≲ 1. Where no root is found, the answer is NaN from there on.
//
// Torque that depends on attitude alone: kick / free flow / kick of order 2 (attitude_torque.h), with Ĩ anew
// at each step, since a kick changes T and |L|.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/motion.h"

#include <memory>

namespace polhode {

/// order 2, 6 or 10: "moser-veselov-2", ...
/// @throws std::domain_error if checked(Problem) refuses it, the step is not finite and > 0, the torque
/// depends on ω, or the order is another.
std::unique_ptr<const Motion> moser_veselov_motion(int order, const Problem& problem, double step_s,
                                                   const Effort& effort = {});

}  // namespace polhode
