// SPDX-License-Identifier: MIT
#include "render/figure/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace polhode {

Camera orbit(const CameraSpec& spec, const Vec3& target, double radius) {
  // Keep clear of the poles, where `up` would be along the line of sight.
  constexpr double kSteepest_rad = 1.55;
  constexpr double kFieldOfView_rad = 0.6;
  const double elevation = std::clamp(spec.elevation_rad, -kSteepest_rad, kSteepest_rad);
  const Vec3 direction(std::cos(elevation) * std::cos(spec.azimuth_rad),
                       std::cos(elevation) * std::sin(spec.azimuth_rad), std::sin(elevation));
  Camera camera;
  camera.target = target;
  camera.eye = target + spec.distance * radius * direction;
  camera.fov_y_rad = 2.0 * std::atan(std::tan(0.5 * kFieldOfView_rad) / spec.zoom);
  camera.near = 0.02 * spec.distance * radius;
  camera.far = 30.0 * spec.distance * radius;
  return camera;
}

}  // namespace polhode
