// SPDX-License-Identifier: MIT
// The motion of the centre of mass, dp/dt = F with p = m v. The force of a scene is constant in space, so
// that both are integrated in closed form, and the rotation has no part in them.
#pragma once

#include "render/scene/description/scene.h"

namespace polhode {

struct Translation {
  Vec3 r_S{0, 0, 0};  ///< m, from where the centre of mass was at t = 0
  Vec3 v_S{0, 0, 0};  ///< m/s
  Vec3 p_S{0, 0, 0};  ///< kg m/s
  Vec3 F_S{0, 0, 0};  ///< N
  double mass_kg = 1.0;
};

/// r = v₀ t + F t²/2m, v = v₀ + F t/m, p = m v. Error: a few roundings.
Translation translation_at(const Scene& scene, double t_s);

/// Whether the scene gives its centre of mass a velocity or a force.
bool drifts(const Scene& scene);

}  // namespace polhode
