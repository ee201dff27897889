// SPDX-License-Identifier: MIT
// The camera: a view matrix and a perspective, the same for CPU and GPU.
#pragma once

#include "base/vectors.h"

#include <optional>

namespace polhode {

/// Looks from eye to target; right-handed, OpenGL clip space. Lengths in scene units.
struct Camera {
  Vec3 eye{4, 0, 1};
  Vec3 target{0, 0, 0};
  Vec3 up{0, 0, 1};
  double fov_y_rad = 0.5;
  double near = 0.05, far = 100;

  Eigen::Matrix4d view() const;
  Eigen::Matrix4d projection(double aspect) const;
};

/// Pixel (from the left, from the top, at pixel centres .5) of a point in a viewport of width x height px;
/// nothing if it is behind the camera.
std::optional<Eigen::Vector2d> project(const Camera& camera, const Vec3& point, double width, double height);

}  // namespace polhode
