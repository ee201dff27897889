// SPDX-License-Identifier: MIT
#include "render/scene/model/rotor.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kThinnest = 1.0 / 20.0;  // of the diameter

bool is_disc_about_3(const Body& body, const Vec3& axis_B) {
  constexpr double kSame = 1e-9;  // of what an author writes with nine digits
  const PrincipalMoments& I = body.moments;
  return !body.shape && std::abs(I[0] - I[1]) <= kSame * I[0] && axis_B.cross(Vec3::UnitZ()).norm() <= kSame;
}

Shape disc_of(const Body& body, double l_m) {
  const PrincipalMoments& I = body.moments;
  const double m = body.mass_kg;
  const double d = std::sqrt(8.0 * I[2] / m);
  const double h2 = 12.0 * (I[0] / m - d * d / 16.0 - l_m * l_m);
  return {ShapeKind::cylinder, Vec3(d, d, std::sqrt(std::max(h2, kThinnest * kThinnest * d * d)))};
}

}  // namespace

const HeavyTop* heavy_top_of(const Scene& scene) {
  const HeavyTop* top = scene.torque.size() == 1 ? std::get_if<HeavyTop>(&scene.torque.front()) : nullptr;
  return top != nullptr && top->mgr != 0.0 && !top->axis_B.isZero(0.0) ? top : nullptr;
}

Rotor rotor_of(const Scene& scene, const HeavyTop& top) {
  const Body& body = scene.body;
  const Vec3 axis_B = top.axis_B.normalized();
  const double l_m = top.mgr / (body.mass_kg * kStandardGravity);
  const Shape shape =
      is_disc_about_3(body, axis_B) ? disc_of(body, l_m) : body.shape.value_or(equivalent_box(body.moments));
  return {shape, l_m * axis_B};
}

}  // namespace polhode
