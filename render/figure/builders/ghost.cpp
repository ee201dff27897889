// SPDX-License-Identifier: MIT
// The exact motion beside the computed one: a translucent body, dashed arrows.
#include "base/words/figure_words.h"
#include "physics/body/euler.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace polhode::builders {
namespace {

constexpr float kAlpha = 0.6F;
constexpr double kDash = 0.06;

/// No name where the computed arrow, with its own, is as good as here.
void add_arrow(const Snapshot& m, const Vec3& tip_V, const Vec3& computed_V, const Phrase& name,
               const Role& role, DrawList& list) {
  Color paint = role.paint;
  paint.a = kAlpha;
  list.arrows.push_back(
      {.tail = Vec3::Zero(), .tip = tip_V, .radius = 0.017 * m.thickness, .color = paint, .dash = kDash});
  constexpr double kApart = 0.15;
  if (m.shows(Overlay::labels) && (tip_V - computed_V).norm() > kApart)
    list.labels.push_back({.text = std::string(name.in(m.model.scene.language)),
                           .anchor = 1.05 * tip_V,
                           .color = role.ink,
                           .size = 0.9,
                           .leader = false,
                           .tail = Vec3(Vec3::Zero())});
}

/// Where the points of a body are seen: on the plane through the camera's target.
std::vector<Vec3> as_seen(std::span<const Mesh> body, const Camera& camera) {
  const Vec3 ahead = camera.target - camera.eye;
  std::vector<Vec3> seen;
  for (const Mesh& mesh : body)
    for (const Vec3& p : mesh.positions) {
      const Vec3 ray = p - camera.eye;
      seen.emplace_back(camera.eye + ahead.squaredNorm() / ray.dot(ahead) * ray);
    }
  return seen;
}

Vec3 furthest(const std::vector<Vec3>& points, const Vec3& direction) {
  return *std::ranges::max_element(points, {}, [&](const Vec3& p) { return p.dot(direction); });
}

struct Place {
  Vec3 end, direction;
  double out;  ///< by how far the end lies outside the other body's outline; < 0: inside
};

/// Where a body stands out furthest from the other, as seen: there its name lies outside both. Where places
/// are about as good, on the side `preferred`, -1 left or 1 right.
Place standing_out(const std::vector<Vec3>& body, const std::vector<Vec3>& other, const Camera& camera,
                   double preferred) {
  constexpr int kDirections = 24;
  constexpr double kPreference = 0.1;  // scene units
  Place best{Vec3::Zero(), Vec3::Zero(), 0.0};
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    const Vec3 direction = screen_direction(camera, std::cos(angle), std::sin(angle));
    const Vec3 end = furthest(body, direction);
    const double out = (end - furthest(other, direction)).dot(direction);
    const double worth = out + kPreference * preferred * std::cos(angle);
    if (worth > most) {
      best = {end, direction, out};
      most = worth;
    }
  }
  return best;
}

/// A label's own leader is short, and beside a name looks like a dash. What lies before the other body has a
/// line that leads out of it, in front of both.
void name_body(std::string_view name, const Place& place, const Camera& camera, DrawList& list) {
  constexpr double kBeyond = 0.1, kTowardsEye = 0.4, kRadius = 0.003;
  const auto in_front = [&](const Vec3& p) -> Vec3 { return p + kTowardsEye * (camera.eye - p); };
  Vec3 anchor = place.end;
  if (place.out < 0.0) {
    anchor = in_front(place.end + (kBeyond - place.out) * place.direction);
    list.tubes.push_back(
        {.points = {in_front(place.end), anchor}, .radius = kRadius, .color = kAxesRole.paint});
  }
  list.labels.push_back(
      {.text = std::string(name), .anchor = anchor, .color = kInk, .size = 0.8, .leader = false});
}

}  // namespace

void add_ghost(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.model.needs.ghost) return;
  RigidBodyState exact{Quat::Identity(), m.model.exact->w_B_at(m.t_s)};
  if (m.model.needs.attitude) exact = m.model.exact->at(m.t_s);
  const Quat q_VB = m.view == View::space ? exact.q_SB : Quat::Identity();

  const std::size_t computed = list.meshes.size();  // those before the ghost's are the computed body's
  add_ghost_of_solid(m, exact.q_SB, list);
  const bool turning = !exact.w_B.isZero(0.0);
  if (m.shows(Overlay::L) && turning)
    add_arrow(m, q_VB * m.L_drawn_B(angular_momentum_B(m.I(), exact.w_B)), m.L_tip_V(), words::kExactL,
              kLRole, list);
  if (m.shows(Overlay::omega) && turning)
    add_arrow(m, q_VB * (exact.w_B * m.omega_scale), m.omega_tip_V(), words::kExactOmega, kOmegaRole, list);
  if (!m.shows(Overlay::labels) || computed == 0 || list.meshes.size() == computed) return;
  const std::span<const Mesh> meshes = list.meshes;
  const std::vector<Vec3> computed_body = as_seen(meshes.first(computed), camera),
                          ghost_body = as_seen(meshes.subspan(computed), camera);
  name_body(facts_of(*m.model.scene.motion.method).term,
            standing_out(computed_body, ghost_body, camera, -1.0), camera, list);
  name_body(std::string(words::kExactMotion.in(m.model.scene.language)),
            standing_out(ghost_body, computed_body, camera, 1.0), camera, list);
}

}  // namespace polhode::builders
