// SPDX-License-Identifier: MIT
// The camera that a scene describes.
#pragma once

#include "render/figure/camera.h"
#include "render/scene/description/scene.h"

namespace polhode {

/// Orbit camera about `target` of a scene of the given radius.
Camera orbit(const CameraSpec& spec, const Vec3& target, double radius);

}  // namespace polhode
