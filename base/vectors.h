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

/// The rotation by the smallest angle that takes the direction of `from` to that of `to`, neither of them
/// zero; about some axis where they are opposite. Eigen's, instantiated once: it is dear to compile.
Quat shortest_rotation(const Vec3& from, const Vec3& to);

}  // namespace polhode
