// SPDX-License-Identifier: MIT
#include "app/session/camera_moves.h"

#include "app/session/scene_edits.h"
#include "base/angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {

CameraSpec orbited(CameraSpec camera, double dx, double dy, double height) {
  constexpr double kSteepest = 89.0 * kRadiansPerDegree;
  if (!(height > 0.0) || !std::isfinite(dx) || !std::isfinite(dy)) return camera;
  const double per_px = std::numbers::pi / height;
  if (dx != 0.0 || dy != 0.0) camera = turned_from_here(camera);
  camera.azimuth_rad = std::remainder(camera.azimuth_rad - dx * per_px, 2.0 * std::numbers::pi);
  camera.elevation_rad = std::clamp(camera.elevation_rad + dy * per_px, -kSteepest, kSteepest);
  return camera;
}

CameraSpec zoomed(CameraSpec camera, double notches) {
  constexpr double kWidest = 0.25, kNearest = 8.0, kNotch = 1.1;
  if (!std::isfinite(notches)) return camera;
  camera.zoom = std::clamp(camera.zoom * std::pow(kNotch, notches), kWidest, kNearest);
  return camera;
}

const std::vector<CameraPreset>& camera_presets() {
  const auto from = [](double azimuth_deg, double elevation_deg) {
    return CameraSpec{.azimuth_rad = azimuth_deg * kRadiansPerDegree,
                      .elevation_rad = elevation_deg * kRadiansPerDegree};
  };
  static const std::vector<CameraPreset> kPresets = {{"three-quarter", CameraSpec{}},
                                                     {"front", from(0, 0)},
                                                     {"side", from(90, 0)},
                                                     {"top", from(-90, 89)},
                                                     {"below", from(-90, -89)}};
  return kPresets;
}

}  // namespace polhode
