// SPDX-License-Identifier: MIT
// Angles between vectors, and in degrees, which only people read and write.
#pragma once

#include "base/vectors.h"

#include <cmath>
#include <numbers>

namespace polhode {

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180,
                        kDegreesPerRadian = 180 / std::numbers::pi, kRadiansPerTurn = 2 * std::numbers::pi;

/// From 0 to π, rad; small angles and those near π are as accurate as others. Lengths do not matter, as long
/// as the square of none over- or underflows; with a zero vector it is 0.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace polhode
