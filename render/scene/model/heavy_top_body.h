// SPDX-License-Identifier: MIT
// What turns about a pivot: the body of a scene with one HeavyTop, put where gravity says that its centre of
// mass is.
#pragma once

#include "physics/body/pivot.h"
#include "render/scene/description/scene.h"

namespace polhode {

struct HeavyTopBody {
  Shape shape;
  Vec3 center_B;  ///< of mass, m, from the pivot
};

/// The one HeavyTop of the scene's torque that weighs something; null if there is none, or more than one.
const HeavyTop* heavy_top_of(const Scene& scene);

/// The centre of mass lies at l = mgr/(m g) along the top's axis. A body keeps its shape. One known by its
/// moments alone, which are those about the pivot, is the disc that has them if I1 = I2 and the axis is along
/// 3: I3 = m d²/8, I1 = m(d²/16 + h²/12 + l²), with h = d/20 if that leaves no height; else the box.
HeavyTopBody heavy_top_body(const Scene& scene, const HeavyTop& top);

}  // namespace polhode
