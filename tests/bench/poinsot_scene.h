// SPDX-License-Identifier: MIT
// The scene that frames are measured with, by us and by the peers: everything Poinsot's construction has.
#pragma once

#include "render/scene/description/scene.h"

namespace polhode::bench {

inline Scene poinsot_scene() {
  using O = Overlay;
  Scene scene;
  scene.w0_B = Vec3(0.2, 1.1, 1.6);
  scene.show = {O::energy_ellipsoid, O::omega,      O::L,     O::polhode, O::polhode_family,
                O::separatrix,       O::herpolhode, O::plane, O::labels,  O::values};
  return scene;
}

/// From frame to frame the camera turns by so much, while time goes on at 25 frames/s.
inline constexpr double kTurnOfCamera_rad = 0.01;
inline constexpr double kFramesPerSecond = 25.0;

}  // namespace polhode::bench
