// SPDX-License-Identifier: MIT
// State of a rigid body that turns about its centre of mass or about a fixed point.
#pragma once

#include "physics/body/types.h"

namespace polhode {

/// Aligned to 32 bytes everywhere. Eigen aligns a quaternion to 16 or 32 by the compiler's -march; a program
/// and a library that were built for different processors would not agree on where a state may lie.
struct alignas(32) RigidBodyState {
  Quat q_SB = Quat::Identity();  ///< attitude, unit; takes body components to space components
  Vec3 w_B = Vec3::Zero();       ///< angular velocity, rad/s, body components
};

/// The state with q_SB scaled to unit length.
/// @throws std::domain_error if ω or q is not finite, or q is zero.
RigidBodyState checked(const RigidBodyState& state);

}  // namespace polhode
