// SPDX-License-Identifier: MIT
// State of a rigid body that turns about its centre of mass or about a fixed point.
#pragma once

#include "physics/types.h"

namespace polhode {

struct RigidBodyState {
  Quat q_SB = Quat::Identity();  ///< attitude, unit; takes body components to space components
  Vec3 w_B = Vec3::Zero();       ///< angular velocity, rad/s, body components
};

}  // namespace polhode
