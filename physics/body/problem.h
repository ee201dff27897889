// SPDX-License-Identifier: MIT
// What there is to be followed in time: a body, its state at t = 0 and the torque on it.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/body/state.h"
#include "physics/body/torque.h"

namespace polhode {

struct Problem {
  PrincipalMoments I;
  RigidBodyState start;  ///< at t = 0
  Torque torque;         ///< empty: torque-free
};

/// The problem with q_SB scaled to unit length.
/// @throws std::domain_error if the state or the torque is not finite, or the axis of a HeavyTop is no unit
/// vector: within 1e-6, since an axis may come from six digits or from single precision.
Problem checked(const Problem& problem);

}  // namespace polhode
