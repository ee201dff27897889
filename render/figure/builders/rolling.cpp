// SPDX-License-Identifier: MIT
// The contact of polhode and herpolhode, and ticks of equal arc length on both: one that is now in the
// contact lies on the other's, and so did all before and will all after it. That is rolling without slipping.
#include "physics/analysis/motion_errors.h"
#include "physics/body/euler.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace polhode::builders {
namespace {

constexpr double kContactRadius = 0.024;
constexpr double kTickRadius = 0.006;
constexpr int kLongEvery = 4;  // ticks; they are black, so that one finds the same ones on both curves

void add_contact(const Snapshot& m, DrawList& list) {
  const double radius = kContactRadius * m.thickness;
  const bool lies_on_plane = m.shows(Overlay::plane) && m.view == View::space;
  const Vec3 lift = lies_on_plane ? Vec3(0.0, 0.0, radius) : Vec3(Vec3::Zero());
  list.balls.push_back({m.omega_tip_V() + lift, radius, kTRole.paint});
}

/// Across both curves where ω's tip is in this state, body components, scene units: square to its velocity,
/// in the plane that touches the energy ellipsoid there, whose normal is L.
Ends tick_B(const Snapshot& m, const Vec3& w_B, double half_length) {
  const Vec3 across_B =
      angular_momentum_B(m.I(), w_B).stableNormalized().cross(angular_acceleration_B(m.I(), w_B));
  const Vec3 tip_B = w_B * m.omega_scale, half_B = half_length * across_B.stableNormalized();
  return {tip_B - half_B, tip_B + half_B};
}

Tube tick(const Ends& ends_B, const Quat& q_VB, double radius, const Color& color) {
  return {.points = {q_VB * ends_B.tail, q_VB * ends_B.tip}, .radius = radius, .color = color};
}

/// As many as lie on the polhode, half of them before and half after the contact: each has its own on the
/// herpolhode, where that is drawn.
void add_ticks(const Snapshot& m, DrawList& list) {
  constexpr double kLongest = 0.036, kPartOfSpacing = 0.36, kLong = 1.7;
  const RollingTicks& ticks = m.model.ticks;
  const Motion& motion = *m.model.motion;
  const auto count = static_cast<std::int64_t>(ticks.times_s.size());
  const auto time_s = [&](std::int64_t k) {
    const auto periods = static_cast<std::int64_t>(std::floor(static_cast<double>(k) / kRollingTicks));
    return ticks.times_s[static_cast<std::size_t>(k - periods * count)] +
           static_cast<double>(periods) * ticks.period_s;
  };
  const double spacing = (motion.w_B_at(time_s(1)) - motion.w_B_at(time_s(0))).norm() * m.omega_scale;
  const double half_length = std::min(kLongest, kPartOfSpacing * spacing);
  const auto [from_s, to_s] = herpolhode_times_s(m);
  std::int64_t next = count * static_cast<std::int64_t>(std::floor((m.t_s - time_s(0)) / ticks.period_s));
  while (time_s(next) < m.t_s) ++next;
  for (std::int64_t k = next - count / 2; k < next + count / 2; ++k) {
    const RigidBodyState then = motion.at(time_s(k));
    if (!is_finite(then)) continue;  // further than the motion is computed
    const bool is_long = k % kLongEvery == 0;
    const Ends ends_B = tick_B(m, then.w_B, half_length * (is_long ? kLong : 1.0));
    const double radius = kTickRadius * m.thickness;
    list.tubes.push_back(tick(ends_B, m.q_VB, radius, is_long ? kTRole.paint : kPolhodeRole.paint));
    if (time_s(k) < from_s || time_s(k) > to_s) continue;
    Tube laid = tick(ends_B, then.q_SB, radius, is_long ? kTRole.paint : kHerpolhodeRole.paint);
    for (Vec3& p : laid.points) p += onto_plane(m, laid);
    list.tubes.push_back(std::move(laid));
  }
}

}  // namespace

void add_rolling(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (m.view != View::space || m.state.w_B.isZero(0.0)) return;
  if (m.model.needs.herpolhode && m.shows(Overlay::herpolhode)) add_contact(m, list);
  if (!m.model.ticks.times_s.empty() && m.L_scale == 0.0) add_ticks(m, list);
}

}  // namespace polhode::builders
