// SPDX-License-Identifier: MIT
// Arrows of ω, L and N, the triads of both frames, the trails of the tips.
#include "physics/body/euler.h"
#include "physics/method_facts.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode::builders {
namespace {

constexpr double kTriadRadius = 0.008;
constexpr int kTrailPoints = 240;
constexpr double kOverCurve = 1.15;  ///< of a trail that lies on a curve

void add_triad(const Quat& q_VF, const Vec3& origin_V, double emphasis, double dash,
               const std::array<Role, 3>& roles, DrawList& list) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis_V = q_VF * Vec3::Unit(i);
    list.arrows.push_back({.tail = origin_V,
                           .tip = origin_V + kTriadLength * axis_V,
                           .radius = kTriadRadius * emphasis,
                           .color = roles[static_cast<std::size_t>(i)].paint,
                           .dash = dash});
  }
}

/// Over the curve that it lies on, or both would show in specks.
double trail_radius(const Snapshot& m, Overlay trail) {
  const double radius = kTrailRadius * m.emphasis(trail);
  const bool on_polhode =
      m.view == View::body && m.shows(Overlay::polhode) && (trail == Overlay::trail_L) == (m.L_scale > 0.0);
  const bool on_herpolhode =
      m.view == View::space && m.shows(Overlay::herpolhode) && trail == Overlay::trail_omega;
  if (on_polhode) return std::max(radius, kOverCurve * kPolhodeRadius * m.emphasis(Overlay::polhode));
  if (on_herpolhode)
    return std::max(radius, kOverCurve * kHerpolhodeRadius * m.emphasis(Overlay::herpolhode));
  return radius;
}

template <class TipAt>
void add_trail(const Snapshot& m, Overlay overlay, const Role& role, TipAt tip_at, DrawList& list) {
  Tube trail{.points = {},
             .closed = false,
             .radius = m.thickness * trail_radius(m, overlay),
             .color = role.paint,
             .fade_start = kOldestOfTrail};
  const Vec3 lift = overlay == Overlay::trail_omega ? onto_plane(m, trail) : Vec3(Vec3::Zero());
  const double start_s = trail_start_s(m);
  for (int n = 0; n <= kTrailPoints; ++n) {
    const double t_s = std::lerp(start_s, m.t_s, static_cast<double>(n) / kTrailPoints);
    RigidBodyState then = m.state;
    if (m.model.needs.attitude)
      then = m.model.motion->at(t_s);
    else
      then.w_B = m.model.motion->w_B_at(t_s);
    trail.points.push_back(tip_at(then) + lift);
  }
  end_behind_tip(trail);
  list.tubes.push_back(std::move(trail));
}

}  // namespace

double trail_start_s(const Snapshot& m) {
  const double start = m.t_s - m.model.span_s;
  const auto& method = m.model.scene.motion.method;
  const bool is_closed = !method || facts_of(*method).control == StepControl::none;
  const bool has_past = m.model.scene.torque.empty() && is_closed;
  return has_past ? start : std::max(0.0, start);
}

void end_behind_tip(Tube& trail) {
  std::vector<Vec3>& points = trail.points;
  const Vec3 tip = points.back();
  while (points.size() > 2 && (points.back() - tip).norm() < trail.radius) points.pop_back();
  const Vec3 way = tip - points.back();
  if (way.norm() > trail.radius) points.push_back(tip - trail.radius * way.normalized());
}

void add_trails(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  const auto to_view = [&](const RigidBodyState& then, const Vec3& v_B) -> Vec3 {
    return m.view == View::space ? Vec3(then.q_SB * v_B) : v_B;
  };
  if (m.model.needs.trail_omega)
    add_trail(
        m, Overlay::trail_omega, kOmegaRole,
        [&](const RigidBodyState& s) { return to_view(s, s.w_B * m.omega_scale); }, list);
  if (m.model.needs.trail_L)
    add_trail(
        m, Overlay::trail_L, kLRole,
        [&](const RigidBodyState& s) { return to_view(s, m.L_drawn_B(angular_momentum_B(m.I(), s.w_B))); },
        list);
}

Ends torque_ends(const Snapshot& m) {
  const Vec3 tail = m.shows(Overlay::L) ? m.L_tip_V() : Vec3::Zero();  // N is the velocity of L's tip
  return {tail, tail + m.q_VB * (m.N_B.normalized() * kTorqueLength)};
}

void add_turn(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (!m.turn) return;
  constexpr int kPoints = 48;
  constexpr double kPlace = 1.02, kArcRadius = 0.26, kLeast_rad = 0.15;
  const Vec3 axis_V = m.q_VS * m.turn->axis_S;
  list.arrows.push_back({.tail = Vec3::Zero(),
                         .tip = kTriadLength * axis_V,
                         .radius = 0.8 * kArrowRadius,
                         .color = kOmegaRole.paint});
  if (m.turn->angle_rad < kLeast_rad) return;
  Tube arc{.points = {}, .closed = false, .radius = 0.011, .color = kOmegaRole.paint};
  for (int n = 0; n <= kPoints; ++n) {
    const Eigen::AngleAxisd by(m.turn->angle_rad * n / kPoints, axis_V);
    arc.points.push_back(kPlace * axis_V + by * (kArcRadius * Vec3::UnitZ()));
  }
  const Vec3 tip = arc.points.back();
  list.arrows.push_back({.tail = tip - 0.02 * axis_V.cross(tip).normalized(),
                         .tip = tip + 0.09 * axis_V.cross(tip).normalized(),
                         .radius = 0.012,
                         .color = kOmegaRole.paint});
  list.tubes.push_back(std::move(arc));
}

void add_vectors(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  const double radius = kArrowRadius * m.thickness;
  const bool turning = !m.state.w_B.isZero(0.0);
  if (m.shows(Overlay::L) && turning)
    list.arrows.push_back({.tail = Vec3::Zero(),
                           .tip = m.L_tip_V(),
                           .radius = radius * m.emphasis(Overlay::L),
                           .color = kLRole.paint});
  if (m.shows(Overlay::omega) && turning)
    list.arrows.push_back({.tail = Vec3::Zero(),
                           .tip = m.omega_tip_V(),
                           .radius = radius * m.emphasis(Overlay::omega),
                           .color = kOmegaRole.paint});
  if (m.shows(Overlay::N) && !m.shows(Overlay::terms) && !m.N_B.isZero(0.0)) {
    const Ends ends = torque_ends(m);
    list.arrows.push_back({.tail = ends.tail,
                           .tip = ends.tip,
                           .radius = radius * m.emphasis(Overlay::N),
                           .color = kNRole.paint,
                           .dash = kArrowDash});
  }
  if ((m.shows(Overlay::L) || m.shows(Overlay::omega)) && turning)
    list.balls.push_back({Vec3::Zero(), 1.7 * radius, color_from_hex(0xE9ECF0)});
}

void add_axes(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (m.shows(Overlay::axes_space))
    add_triad(m.q_VS, -m.center_V, m.emphasis(Overlay::axes_space), 0.05, {kAxesRole, kAxesRole, kAxesRole},
              list);
  if (m.shows(Overlay::axes_body))
    add_triad(m.q_VB, Vec3::Zero(), m.emphasis(Overlay::axes_body), 0.0, kBodyAxisRoles, list);
}

}  // namespace polhode::builders
