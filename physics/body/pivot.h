// SPDX-License-Identifier: MIT
// A body that hangs on a pivot by its weight: its moments about there.
#pragma once

#include "base/result.h"
#include "physics/body/bodies.h"
#include "physics/body/torque.h"

namespace polhode {

inline constexpr double kStandardGravity = 9.80665;  ///< m/s², CGPM 1901

/// Steiner's theorem for a body known by its shape and mass, whose moments are about the centre of mass: with
/// HeavyTops in `torque` its moments about the pivot, at l = Σ mgr a/(m g) from there; without them as it is.
/// It fails where l lies on no principal axis, since 1, 2, 3 are then not principal at the pivot, and where
/// the moments overflow; the message names the body.
Result<Body> on_its_pivot(Body body, const Torque& torque);

}  // namespace polhode
