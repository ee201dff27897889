// SPDX-License-Identifier: MIT
#include "render/scene/model/heavy_top_body.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kThinnest = 1.0 / 20.0;  // of the diameter

bool is_disc_about_3(const Body& body, const Vec3& axis_B) {
  constexpr double kSame = 1e-9;  // of what an author writes with nine digits
  const PrincipalMoments& I = body.moments;
  return std::abs(I[0] - I[1]) <= kSame * I[0] && axis_B.cross(Vec3::UnitZ()).norm() <= kSame;
}

Shape disc_of(const Body& body, double l_m) {
  const PrincipalMoments& I = body.moments;
  const double m = body.mass_kg;
  const double d = std::sqrt(8.0 * I[2] / m);
  const double h2 = 12.0 * (I[0] / m - d * d / 16.0 - l_m * l_m);
  return {ShapeKind::cylinder, Vec3(d, d, std::sqrt(std::max(h2, kThinnest * kThinnest * d * d)))};
}

/// The box that has the body's moments about its centre of mass, at l from the pivot; those about the pivot
/// where Steiner's theorem leaves no body there.
Shape box_of(const Body& body, double l_m, const Vec3& axis_B) {
  const Vec3 I = body.moments.vector() - body.mass_kg * l_m * l_m * (Vec3::Ones() - axis_B.cwiseAbs2());
  if (why_impossible(I[0], I[1], I[2])) return equivalent_box(body.moments, body.mass_kg);
  return equivalent_box(PrincipalMoments(I[0], I[1], I[2]), body.mass_kg);
}

}  // namespace

const HeavyTop* heavy_top_of(const Scene& scene) {
  const HeavyTop* found = nullptr;
  for (const TorqueTerm& term : scene.torque) {
    const auto* top = std::get_if<HeavyTop>(&term);
    if (top == nullptr || top->mgr == 0.0 || top->axis_B.isZero(0.0)) continue;
    if (found != nullptr) return nullptr;
    found = top;
  }
  return found;
}

HeavyTopBody heavy_top_body(const Scene& scene, const HeavyTop& top) {
  const Body& body = scene.body;
  const Vec3 axis_B = top.axis_B.normalized();
  const double l_m = top.mgr / (body.mass_kg * kStandardGravity);
  const Vec3 center_B = l_m * axis_B;
  if (body.shape) return {*body.shape, center_B};
  return {is_disc_about_3(body, axis_B) ? disc_of(body, l_m) : box_of(body, l_m, axis_B), center_B};
}

}  // namespace polhode
