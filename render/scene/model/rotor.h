// SPDX-License-Identifier: MIT
// What turns about a pivot: the body of a scene with one HeavyTop, put where gravity says that its centre of
// mass is.
#pragma once

#include "base/result.h"
#include "render/scene/description/scene.h"

namespace polhode {

inline constexpr double kStandardGravity = 9.80665;  ///< m/s², CGPM 1901

struct Rotor {
  Shape shape;
  Vec3 center_B;  ///< of mass, m, from the pivot
};

/// Steiner's theorem for a body known by its shape and mass, whose moments are about the centre of mass: with
/// HeavyTops in `torque` its moments about the pivot, at l = Σ mgr a/(m g) from there; without them as it is.
/// It fails where l lies on no principal axis, since 1, 2, 3 are then not principal at the pivot, and where
/// the moments overflow; the message names the body.
Result<Body> on_its_pivot(Body body, const Torque& torque);

/// The one torque of the scene, if it is a HeavyTop that weighs something; null otherwise.
const HeavyTop* heavy_top_of(const Scene& scene);

/// The centre of mass lies at l = mgr/(m g) along the top's axis. A body known by its moments alone, which
/// are those about the pivot, with I1 = I2 and the axis along 3, is the disc that has them: I3 = m d²/8, I1 =
/// m(d²/16 + h²/12 + l²); one of d/20 if that leaves no height. Other bodies keep their shape.
Rotor rotor_of(const Scene& scene, const HeavyTop& top);

}  // namespace polhode
