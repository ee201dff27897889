// SPDX-License-Identifier: MIT
// A body that hangs on a pivot by its weight: its moments about there.
#pragma once

#include "base/result.h"
#include "physics/body/bodies.h"
#include "physics/body/torque.h"

namespace polhode {

inline constexpr double kStandardGravity = 9.80665;  ///< m/s², CGPM 1901

/// Gravity on a body that is held at a point `pivot_B`, m, from its centre of mass: mgr = m g |pivot_B|,
/// along −pivot_B, which is not zero.
HeavyTop weight_at(double mass_kg, const Vec3& pivot_B);

/// Steiner's theorem for a body with moments about its centre of mass: with HeavyTops in `torque` its moments
/// about the pivot, from where the centre of mass lies at l = Σ mgr a/(m g); without them as it is. It fails
/// where l lies on no principal axis, since 1, 2, 3 are then not principal at the pivot, and where the
/// moments overflow; the message names the body.
Result<Body> about_pivot(Body body, const Torque& torque);

/// The same for a body that is known by its shape and mass; one known by its moments alone stays as it is:
/// these are those about the pivot.
Result<Body> on_its_pivot(Body body, const Torque& torque);

/// l = Σ mgr a/(m g), m, of the HeavyTops in `torque`: the centre of mass from the pivot; zero without them.
Vec3 center_from_pivot_B(double mass_kg, const Torque& torque);

}  // namespace polhode
