// SPDX-License-Identifier: MIT
// The exact motion beside the computed one: a translucent body, dashed arrows.
#include "physics/euler.h"
#include "render/scene/builders/builders.h"
#include "render/scene/palette.h"

#include <algorithm>

namespace polhode::builders {
namespace {

constexpr float kAlpha = 0.6F;
constexpr double kDash = 0.06;

/// No name where the computed arrow, with its own, is as good as here.
void add_arrow(const Moment& m, const Vec3& tip_V, const Vec3& computed_V, Arrow::Head head, const char* name,
               const Role& role, DrawList& list) {
  Color paint = role.paint;
  paint.a = kAlpha;
  list.arrows.push_back({.head = head,
                         .tail = Vec3::Zero(),
                         .tip = tip_V,
                         .radius = 0.017 * m.thickness,
                         .color = paint,
                         .dash = kDash});
  constexpr double kApart = 0.15;
  if (m.shows(Overlay::labels) && (tip_V - computed_V).norm() > kApart)
    list.labels.push_back(
        {.text = name, .anchor = 1.05 * tip_V, .color = role.ink, .size = 0.9, .leader = false});
}

Vec3 furthest(const Mesh& mesh, const Vec3& direction) {
  return *std::max_element(mesh.positions.begin(), mesh.positions.end(),
                           [&](const Vec3& a, const Vec3& b) { return a.dot(direction) < b.dot(direction); });
}

void name_body(const DrawList& list, std::size_t first, const Vec3& direction, std::string name,
               std::vector<Label>& labels) {
  if (first >= list.meshes.size()) return;
  labels.push_back({.text = std::move(name),
                    .anchor = furthest(list.meshes[first], direction),
                    .color = kInk,
                    .size = 0.8});
}

}  // namespace

void add_ghost(const Moment& m, const Camera& camera, DrawList& list) {
  if (!m.model.needs.ghost) return;
  RigidBodyState exact{Quat::Identity(), m.model.exact->w_B_at(m.t_s)};
  if (m.model.needs.attitude) exact = m.model.exact->at(m.t_s);
  const Quat q_VB = m.view == View::space ? exact.q_SB : Quat::Identity();

  const std::size_t computed = 0, ghost = list.meshes.size();
  add_ghost_of_solid(m, exact.q_SB, list);
  const bool turning = !exact.w_B.isZero(0.0);
  if (m.shows(Overlay::L) && turning)
    add_arrow(m, q_VB * m.L_drawn_B(angular_momentum_B(m.I(), exact.w_B)), m.L_tip_V(),
              Arrow::Head::double_cone, "$\\vec L$ exact", kLRole, list);
  if (m.shows(Overlay::omega) && turning)
    add_arrow(m, q_VB * (exact.w_B * m.omega_scale), m.omega_tip_V(), Arrow::Head::cone,
              "$\\vec\\omega$ exact", kOmegaRole, list);
  if (!m.shows(Overlay::labels) || ghost == list.meshes.size() || ghost == 0) return;
  name_body(list, computed, screen_direction(camera, -1.0, -0.3), std::string(m.model.motion->method()),
            list.labels);
  name_body(list, ghost, screen_direction(camera, 1.0, -0.3), "exact", list.labels);
}

}  // namespace polhode::builders
