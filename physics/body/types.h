// SPDX-License-Identifier: MIT
// The conventions every file of physics relies on.
//
// Frames   S: the inertial space frame. B: the body frame (S* in the lecture), along the principal axes.
// Suffixes v_B are components in B, v_S in S. q_SB and R_SB take body components to space components:
//          v_S = q_SB * v_B = R_SB * v_B. A vector without a frame suffix is a bug.
// Rotation Hamilton quaternions, active; scalar first in every text ("wxyz"), Eigen's own order in memory.
// Units    SI and radians.
#pragma once

#include "base/vectors.h"
