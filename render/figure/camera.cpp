// SPDX-License-Identifier: MIT
#include "render/figure/camera.h"

#include <cmath>

namespace polhode {

Eigen::Matrix4d Camera::view() const {
  const Vec3 back = (eye - target).normalized();
  const Vec3 right = up.cross(back).normalized();
  Mat3 axes;
  axes << right.transpose(), back.cross(right).transpose(), back.transpose();

  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = axes;
  m.topRightCorner<3, 1>() = -axes * eye;
  return m;
}

Eigen::Matrix4d Camera::projection(double aspect) const {
  const double f = 1.0 / std::tan(0.5 * fov_y_rad);
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = f / aspect;
  m(1, 1) = f;
  m(2, 2) = (far + near) / (near - far);
  m(2, 3) = 2.0 * far * near / (near - far);
  m(3, 2) = -1.0;
  return m;
}

std::optional<Eigen::Vector2d> project(const Camera& camera, const Vec3& point, double width, double height) {
  const Eigen::Vector4d clip = camera.projection(width / height) * (camera.view() * point.homogeneous());
  if (clip.w() <= 0.0) return std::nullopt;
  return Eigen::Vector2d(0.5 * (1.0 + clip.x() / clip.w()) * width,
                         0.5 * (1.0 - clip.y() / clip.w()) * height);
}

}  // namespace polhode
