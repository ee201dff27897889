// SPDX-License-Identifier: MIT
// Which way a body spins about its axis 3: an arrow bent about that axis.
#include "render/figure/builders/builders.h"
#include "render/palette.h"
#include "render/scene/model/heavy_top_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode::builders {
namespace {

/// Circles about axis 3, over the one and the other side of the body.
struct Hoops {
  double middle, above, radius;  ///< scene units: of the body on axis 3, and from there
};

Hoops hoops_over(const Snapshot& m) {
  constexpr double kAlone = 1.0, kAloneRadius = 0.26;  // of a body that is not drawn
  if (!m.model.needs.solid) return {0.0, kAlone, kAloneRadius};
  constexpr double kGap = 0.06, kPart = 0.6, kLeast = 0.12;
  const double scale = scene_units_per_m(m);
  const HeavyTop* top = m.shows(Overlay::pivot) ? heavy_top_of(m.model.scene) : nullptr;
  const Vec3 center_B = top ? heavy_top_body(m.model.scene, *top).center_B : Vec3(Vec3::Zero());
  const Vec3 half = 0.5 * scale * (top ? heavy_top_body(m.model.scene, *top).shape : m.model.solid).size_m;
  return {scale * center_B.z(), half.z() + kGap, std::max(kLeast, kPart * std::min(half.x(), half.y()))};
}

}  // namespace

void add_spin(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.shows(Overlay::spin) || m.state.w_B.z() == 0.0) return;
  constexpr int kPoints = 64;
  constexpr double kDegree = std::numbers::pi / 180.0, kFrom_rad = -150.0 * kDegree, kTo_rad = 50.0 * kDegree,
                   kShaft = 0.13, kHead = 0.11;
  const double radius = 0.75 * kArrowRadius * m.thickness * m.emphasis(Overlay::spin);
  const Hoops hoops = hoops_over(m);
  const Vec3 axis_V = m.q_VB * Vec3::UnitZ(), body_V = hoops.middle * axis_V;
  // It stands before the body with its head in front, wherever one looks from: it does not turn with the
  // body.
  const Vec3 to_eye = camera.eye - body_V, across = to_eye - to_eye.dot(axis_V) * axis_V;
  const Vec3 middle_V = body_V + std::copysign(hoops.above, to_eye.dot(axis_V)) * axis_V;
  const Vec3 front =
      across.norm() > 1e-6 * to_eye.norm() ? Vec3(across.normalized()) : Vec3(m.q_VB * Vec3::UnitX());
  const double sense = m.state.w_B.z() > 0.0 ? 1.0 : -1.0;
  const auto at = [&](double angle_rad) {
    return Vec3(middle_V + hoops.radius * (Eigen::AngleAxisd(sense * angle_rad, axis_V) * front));
  };
  // A head takes no more than a part of its arrow, whose shaft lies in the end of the arc.
  const double shaft_rad = kShaft / hoops.radius;
  Tube arc{.points = {}, .radius = radius, .color = kOmegaRole.paint};
  for (int n = 0; n <= kPoints; ++n)
    arc.points.push_back(
        at(std::lerp(kFrom_rad, kTo_rad - 0.5 * shaft_rad, static_cast<double>(n) / kPoints)));
  const Vec3 end = at(kTo_rad), along = sense * axis_V.cross(end - middle_V).normalized();
  list.tubes.push_back(std::move(arc));
  list.arrows.push_back({.tail = at(kTo_rad - shaft_rad),
                         .tip = end + kHead * along,
                         .radius = radius,
                         .color = kOmegaRole.paint});
}

}  // namespace polhode::builders
