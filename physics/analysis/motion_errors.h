// SPDX-License-Identifier: MIT
// How far a computed motion is from the true one, and how well it keeps what is to be kept.
//
// A motion that keeps T and |L| need not keep the direction of L in space, nor the phase: each is measured
// for itself.
#pragma once

#include "physics/body/problem.h"

#include <span>

namespace polhode {

bool is_finite(const RigidBodyState& state);

/// Both NaN where one of the states is not finite.
struct StateError {
  double omega = 0;         ///< |ω − ω_ref|/|ω_ref|
  double attitude_rad = 0;  ///< angle of q_ref⁻¹ q, 0…π: 2 atan2(|vector part|, |scalar part|), not acos
};
StateError error_of(const RigidBodyState& state, const RigidBodyState& reference);

/// Largest departures from the start. NaN where the torque does not keep the quantity, or a state is not
/// finite, or ω at the start is zero.
struct InvariantDrift {
  double T = 0;                ///< |T/T₀ − 1|; kept without torque
  double L = 0;                ///< ||L|/|L₀| − 1|; kept without torque and by an EnergySink
  double L_direction_rad = 0;  ///< angle in space from L₀ to L, by atan2; kept as |L| is
};
InvariantDrift drift_along(const Problem& problem, std::span<const RigidBodyState> states);

}  // namespace polhode
