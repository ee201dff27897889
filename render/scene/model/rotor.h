// SPDX-License-Identifier: MIT
// What turns about a pivot: the body of a scene with one HeavyTop, put where gravity says that its centre of
// mass is.
#pragma once

#include "physics/body/pivot.h"
#include "render/scene/description/scene.h"

namespace polhode {

struct Rotor {
  Shape shape;
  Vec3 center_B;  ///< of mass, m, from the pivot
};

/// The one torque of the scene, if it is a HeavyTop that weighs something; null otherwise.
const HeavyTop* heavy_top_of(const Scene& scene);

/// The centre of mass lies at l = mgr/(m g) along the top's axis. A body known by its moments alone, which
/// are those about the pivot, with I1 = I2 and the axis along 3, is the disc that has them: I3 = m d²/8, I1 =
/// m(d²/16 + h²/12 + l²); one of d/20 if that leaves no height. Other bodies keep their shape.
Rotor rotor_of(const Scene& scene, const HeavyTop& top);

}  // namespace polhode
