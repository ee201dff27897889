// SPDX-License-Identifier: MIT
// Vectors, matrices and rotations; in which frame and unit their components are, their names say.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace polhode {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

}  // namespace polhode
