// SPDX-License-Identifier: MIT
// Vectors and colours as the driver takes them. Internal to render/gl/.
#pragma once

#include "base/color.h"
#include "base/vectors.h"

#include <array>

namespace polhode {

inline std::array<float, 2> floats(const Vec2& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}
inline std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
inline std::array<float, 4> floats(const Color& c, double alpha_factor = 1.0) {
  return {c.r, c.g, c.b, c.a * static_cast<float>(alpha_factor)};
}

}  // namespace polhode
