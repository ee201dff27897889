// SPDX-License-Identifier: MIT
#include "render/scene/model/translation.h"

namespace polhode {

Translation translation_at(const Scene& scene, double t_s) {
  const double m = scene.body.mass_kg;
  const Vec3 gained_S = scene.F_S * (t_s / m);
  const Vec3 v_S = scene.v0_S + gained_S;
  return {
      .r_S = (scene.v0_S + 0.5 * gained_S) * t_s, .v_S = v_S, .p_S = m * v_S, .F_S = scene.F_S, .mass_kg = m};
}

bool drifts(const Scene& scene) { return !scene.v0_S.isZero(0.0) || !scene.F_S.isZero(0.0); }

}  // namespace polhode
