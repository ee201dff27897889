// SPDX-License-Identifier: MIT
// Lie-Poisson splitting of the free rigid body into rotations about its principal axes.
// McLachlan, Phys. Rev. Lett. 71 (1993) 3043-3046; Reich, Physica D 76 (1994) 375-383; Touma & Wisdom,
// Astron. J. 107 (1994) 1189-1202; Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed., §VII.5.
//
// T = T_1 + T_2 + T_3 with T_i = L_i²/2I_i. The flow of T_i alone keeps L_i, turns the body about axis i at
// L_i/I_i, and L stands still in space. One step is Strang's composition
//
//     φ_1(h/2) φ_2(h/2) φ_3(h) φ_2(h/2) φ_1(h/2)
//
// Order 2. Costs 4 sines and cosines (the last rotation about axis 1 and the first of the next step are by
// the same angle), about 80 ns. Keeps L in space, hence |L|, and |q|, all to rounding; a Poisson map, so T
// oscillates and does not drift; reversible. Steady rotation about a principal axis is exact. For any h there
// is an answer. Counts one evaluation a step. Not for needles: L_1 errs by rounding of |L| and by h³, ω_1 by
// I/I_1 as much.
//
// Torque that depends on attitude alone: kick / free flow / kick, attitude_torque.h.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/motion.h"

#include <memory>

namespace polhode {

/// @throws std::domain_error if checked(Problem) refuses it, the step is not finite and > 0, or the torque
/// depends on ω.
std::unique_ptr<const Motion> splitting_motion(const Problem& problem, double step_s,
                                               const Effort& effort = {});

}  // namespace polhode
