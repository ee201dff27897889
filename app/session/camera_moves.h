// SPDX-License-Identifier: MIT
// The camera of a figure, turned and zoomed by hand, and the places that have a name.
#pragma once

#include "render/scene/description/scene.h"

#include <string>
#include <vector>

namespace polhode {

/// The camera turned by a drag of (dx, dy) px, y down, in a picture `height` px high. A drag over the whole
/// height turns it by half a turn, and what is in front goes with the hand. Elevation stays within ±89°, and
/// the scale is kept.
CameraSpec orbited(CameraSpec camera, double dx, double dy, double height);
/// The camera zoomed by a tenth for each notch of the wheel; zoom stays within 0.25…8.
CameraSpec zoomed(CameraSpec camera, double notches);

struct CameraPreset {
  std::string name;  ///< "front", "side", "top", "below", "three-quarter"
  CameraSpec camera;
};
const std::vector<CameraPreset>& camera_presets();

}  // namespace polhode
