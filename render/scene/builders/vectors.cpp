// SPDX-License-Identifier: MIT
// Arrows of ω, L and N, the triads of both frames, the trails of the tips.
#include "physics/euler.h"
#include "render/scene/builders/builders.h"
#include "render/scene/palette.h"

#include <algorithm>
#include <cmath>

namespace polhode::builders {
namespace {

constexpr double kArrowRadius = 0.021;
constexpr double kTorqueLength = 0.62;
constexpr double kTriadRadius = 0.008;
constexpr int kTrailPoints = 240;

void add_triad(const Quat& q_VF, double length, double dash, DrawList& list) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis_V = q_VF * Vec3::Unit(i);
    list.arrows.push_back({.tail = Vec3::Zero(),
                           .tip = length * axis_V,
                           .radius = kTriadRadius,
                           .color = kAxesRole.paint,
                           .dash = dash});
  }
}

/// Times of the past that a trail shows. Torque-free motion has no beginning; a driven one starts at t = 0.
double trail_start_s(const Moment& m) {
  const double start = m.t_s - m.model.span_s;
  return m.model.scene.torque.empty() ? start : std::max(0.0, start);
}

template <class TipAt>
void add_trail(const Moment& m, const Role& role, TipAt tip_at, DrawList& list) {
  Tube trail{
      .points = {}, .closed = false, .radius = 0.011 * m.thickness, .color = role.paint, .fade_start = 0.0};
  const double start_s = trail_start_s(m);
  for (int n = 0; n <= kTrailPoints; ++n) {
    const double t_s = std::lerp(start_s, m.t_s, static_cast<double>(n) / kTrailPoints);
    RigidBodyState then = m.state;
    if (m.model.needs.attitude)
      then = m.model.motion->at(t_s);
    else
      then.w_B = m.model.motion->w_B_at(t_s);
    trail.points.push_back(tip_at(then));
  }
  list.tubes.push_back(std::move(trail));
}

}  // namespace

void add_trails(const Moment& m, DrawList& list) {
  const auto to_view = [&](const RigidBodyState& then, const Vec3& v_B) -> Vec3 {
    return m.view == View::space ? Vec3(then.q_SB * v_B) : v_B;
  };
  if (m.model.needs.trail_omega)
    add_trail(
        m, kOmegaRole, [&](const RigidBodyState& s) { return to_view(s, s.w_B * m.omega_scale); }, list);
  if (m.model.needs.trail_L)
    add_trail(
        m, kLRole,
        [&](const RigidBodyState& s) {
          const Vec3 L_B = angular_momentum_B(m.I(), s.w_B);
          return to_view(s, L_B.isZero(0.0) ? L_B : Vec3(L_B.normalized() * m.L_length));
        },
        list);
}

void add_vectors(const Moment& m, DrawList& list) {
  const double radius = kArrowRadius * m.thickness;
  const bool turning = !m.state.w_B.isZero(0.0);
  if (m.shows(Overlay::L) && turning)
    list.arrows.push_back({.head = Arrow::Head::double_cone,
                           .tail = Vec3::Zero(),
                           .tip = m.L_tip_V(),
                           .radius = radius,
                           .color = kLRole.paint});
  if (m.shows(Overlay::omega) && turning)
    list.arrows.push_back(
        {.tail = Vec3::Zero(), .tip = m.omega_tip_V(), .radius = radius, .color = kOmegaRole.paint});
  if (m.shows(Overlay::N) && !m.N_B.isZero(0.0)) {
    const Vec3 tail = m.shows(Overlay::L) ? m.L_tip_V() : Vec3::Zero();  // N is the velocity of L's tip
    list.arrows.push_back({.tail = tail,
                           .tip = tail + m.q_VB * (m.N_B.normalized() * kTorqueLength),
                           .radius = radius,
                           .color = kNRole.paint,
                           .dash = 0.045});
  }
  if ((m.shows(Overlay::L) || m.shows(Overlay::omega)) && turning)
    list.balls.push_back({Vec3::Zero(), 1.7 * radius, color_from_hex(0xE9ECF0)});
}

void add_axes(const Moment& m, DrawList& list) {
  if (m.shows(Overlay::axes_space)) add_triad(m.q_VS, kTriadLength, 0.05, list);
  if (m.shows(Overlay::axes_body)) add_triad(m.q_VB, kTriadLength, 0.0, list);
}

}  // namespace polhode::builders
