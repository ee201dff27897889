// SPDX-License-Identifier: MIT
// The centre of mass on its way: path, v, p and F; or a puck that slides beside the body.
#include "render/scene/model/translation.h"

#include "render/figure/builders/builders.h"
#include "render/figure/builders/extents.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode::builders {
namespace {

constexpr int kPathPoints = 96;
constexpr int kMarks = 8;  // equal times between them
constexpr double kPuckRadius = 0.36, kPuckHeight = 0.16;
constexpr double kPuckAside = 1.85;
constexpr double kFloor = -0.98;

/// Lengths of the arrows of v and p where |v| is largest, and of F. v is longer and thinner than p, so that
/// both can be seen on one line.
struct Lengths {
  double v, p, F;
};
constexpr Lengths kOfBody{2.1, 1.45, 1.3};
constexpr Lengths kOfPuck{1.35, 0.9, 0.8};

double fastest(const SceneModel& model) {  // |v| is convex in t
  double speed = 0.0;
  for (double t_s : {0.0, model.span_s, model.scene.at_s})
    speed = std::max(speed, translation_at(model.scene, t_s).v_S.norm());
  return speed;
}

/// Where the centre is drawn, V axes.
Vec3 place_V(const Snapshot& m, double t_s, double units_per_m) {
  return m.q_VS * (translation_at(m.model.scene, t_s).r_S * units_per_m);
}

/// The puck's place half way: on the floor, beside the body at the camera's right.
Vec3 lane_V(const Snapshot& m) {
  const CameraSpec& camera = m.model.scene.camera;
  const Vec3 right(-std::sin(camera.azimuth_rad), std::cos(camera.azimuth_rad), 0.0);
  return (puck_alone(m) ? 0.0 : kPuckAside) * right + Vec3(0.0, 0.0, kFloor + 0.5 * kPuckHeight);
}

Vec3 puck_V(const Snapshot& m, double t_s, double units_per_m) {
  return lane_V(m) + place_V(m, t_s, units_per_m) - place_V(m, 0.5 * m.model.span_s, units_per_m);
}

/// Level disc, seen from all sides.
void add_disc(const Vec3& center, DrawList& list) {
  constexpr unsigned kSides = 72;
  Mesh mesh;
  mesh.color = color_from_hex(0xC9CFD6);
  std::vector<Tube> rims(2,
                         {.points = {}, .closed = true, .radius = 0.006, .color = color_from_hex(0x59616C)});
  const Vec3 up(0.0, 0.0, 0.5 * kPuckHeight);
  for (const Vec3& middle : {Vec3(center + up), Vec3(center - up)}) {
    mesh.positions.push_back(middle);
    mesh.normals.push_back((middle - center).normalized());
  }
  for (unsigned i = 0; i < kSides; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kSides;
    const Vec3 out(std::cos(a), std::sin(a), 0.0);
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (double side : {1.0, -1.0})
      for (const Vec3& normal : {Vec3(side * Vec3::UnitZ()), out}) {
        mesh.positions.push_back(center + kPuckRadius * out + side * up);
        mesh.normals.push_back(normal);
      }
    rims[0].points.push_back(center + kPuckRadius * out + up);
    rims[1].points.push_back(center + kPuckRadius * out - up);
    const unsigned next = i + 1 < kSides ? first + 4 : 2;
    for (unsigned k : {0U, first, next, 1U, next + 2, first + 2, first + 1, first + 3, next + 1, next + 1,
                       first + 3, next + 3})
      mesh.triangles.push_back(k);
  }
  list.meshes.push_back(std::move(mesh));
  for (Tube& rim : rims) list.tubes.push_back(std::move(rim));
}

void add_path(const Snapshot& m, const std::vector<Vec3>& path_V, const Vec3& away_V, DrawList& list) {
  Tube line{.points = {}, .closed = false, .radius = 0.0075, .color = kAxesRole.paint, .dash = 0.06};
  for (const Vec3& p : path_V) line.points.push_back(p + away_V);
  for (int n = 0; n <= kMarks; ++n) {
    if (n * m.model.span_s > kMarks * m.t_s) break;
    list.balls.push_back(
        {path_V[static_cast<std::size_t>(n * kPathPoints / kMarks)] + away_V, 0.024, kAxesRole.paint});
  }
  list.tubes.push_back(std::move(line));
}

void add_arrow(const Snapshot& m, Overlay overlay, const Arrow& arrow, const char* name, const Role& role,
               DrawList& list) {
  list.arrows.push_back(arrow);
  list.arrows.back().color = role.paint;
  list.arrows.back().radius *= m.emphasis(overlay);
  if (m.shows(Overlay::labels))
    list.labels.push_back({.text = name,
                           .anchor = arrow.tip,
                           .color = role.ink,
                           .size = 1.2,
                           .leader = false,
                           .tail = arrow.tail});
}

/// A velocity, a momentum and a force have each the same colour and head, of translation as of rotation.
void add_arrows(const Snapshot& m, const Vec3& at, const Lengths& lengths, const OverlaySet& shown,
                DrawList& list) {
  const Translation now = translation_at(m.model.scene, m.t_s);
  const double most = fastest(m.model);
  const double radius = 0.021 * m.thickness;
  const Vec3 v_V = most > 0.0 ? Vec3(m.q_VS * (now.v_S / most)) : Vec3(Vec3::Zero());
  const bool moves = v_V.norm() > 1e-3;
  if (shown.contains(Overlay::v) && moves)
    add_arrow(m, Overlay::v, {.tail = at, .tip = at + lengths.v * v_V, .radius = 0.8 * radius, .color = {}},
              "$\\vec v$", kOmegaRole, list);
  if (shown.contains(Overlay::p) && moves)
    add_arrow(m, Overlay::p, {.tail = at, .tip = at + lengths.p * v_V, .radius = 1.35 * radius, .color = {}},
              "$\\vec p$", kLRole, list);
  if (shown.contains(Overlay::F) && !now.F_S.isZero(0.0))
    add_arrow(
        m, Overlay::F,
        {.tail = at, .tip = at + lengths.F * (m.q_VS * now.F_S.normalized()), .radius = radius, .color = {}},
        "$\\vec F$", kNRole, list);
}

}  // namespace

bool puck_alone(const Snapshot& m) {
  for (Overlay o :
       {Overlay::shape, Overlay::energy_ellipsoid, Overlay::omega, Overlay::L, Overlay::axes_body})
    if (m.shows(o)) return false;
  return true;
}

std::vector<Vec3> path_of_center_V(const Snapshot& m) {
  const double units_per_m = scene_units_per_m(m);
  std::vector<Vec3> path_V;
  for (int n = 0; n <= kPathPoints; ++n) {
    const double t_s = m.model.span_s * n / kPathPoints;
    path_V.push_back(m.shows(Overlay::puck) ? puck_V(m, t_s, units_per_m) : place_V(m, t_s, units_per_m));
  }
  return path_V;
}

std::vector<Vec3> tips_of_center_V(const Snapshot& m) {
  const Lengths& lengths = m.shows(Overlay::puck) ? kOfPuck : kOfBody;
  const std::vector<Vec3> path_V = path_of_center_V(m);
  const double most = fastest(m.model);
  std::vector<Vec3> tips_V;
  for (int n = 0; n <= kMarks && most > 0.0; ++n) {
    const Translation then = translation_at(m.model.scene, m.model.span_s * n / kMarks);
    const Vec3& at_V = path_V[static_cast<std::size_t>(n * kPathPoints / kMarks)];
    if (m.shows(Overlay::v)) tips_V.push_back(at_V + m.q_VS * (then.v_S * (lengths.v / most)));
    if (m.shows(Overlay::p))
      tips_V.push_back(at_V + m.q_VS * (then.p_S * (lengths.p / (most * then.mass_kg))));
    if (m.shows(Overlay::F)) tips_V.push_back(at_V + m.q_VS * (lengths.F * then.F_S.normalized()));
  }
  return tips_V;
}

void add_extents_of_translation(const Snapshot& m, Extents& extents) {
  constexpr double kRoundPuck = 0.42, kOnPath = 0.03, kName = 0.14;
  const bool puck = m.shows(Overlay::puck);
  for (const Vec3& at_V : path_of_center_V(m)) extents.push_back(ball_at(at_V, puck ? kRoundPuck : kOnPath));
  for (const Vec3& at_V : tips_of_center_V(m)) extents.push_back(ball_at(at_V, kName));
  if (!puck && m.shows(Overlay::axes_space))
    for (int i = 0; i < 3; ++i) extents.push_back(ball_at(kTriadLength * Vec3::Unit(i), kName));
}

Vec3 center_of_mass_V(const Snapshot& m, double t_s) {
  if (m.view == View::body || m.shows(Overlay::puck) || !drifts(m.model.scene)) return Vec3::Zero();
  return place_V(m, t_s, scene_units_per_m(m));
}

void add_translation(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  const OverlaySet& shown = m.model.drawn;
  if (m.shows(Overlay::puck)) {
    if (m.view == View::body) return;
    const Vec3 at = puck_V(m, m.t_s, scene_units_per_m(m));
    if (list.floors.empty()) list.floors.push_back({.z = kFloor});
    add_disc(at, list);
    if (!drifts(m.model.scene)) return;
    const Vec3 on_floor(0.0, 0.0, 0.016 - 0.5 * kPuckHeight);
    add_path(m, path_of_center_V(m), on_floor, list);
    add_arrows(m, at + Vec3(0.0, 0.0, 0.5 * kPuckHeight + 0.05), kOfPuck, shown, list);
    return;
  }
  if (!drifts(m.model.scene)) return;
  if (m.view == View::space) add_path(m, path_of_center_V(m), -m.center_V, list);
  add_arrows(m, Vec3::Zero(), kOfBody, shown, list);
}

}  // namespace polhode::builders
