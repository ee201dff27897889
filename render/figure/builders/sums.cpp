// SPDX-License-Identifier: MIT
// Arrows that add up: the triangle of the transport theorem, the terms of I·ω̇ + ω×(I·ω) = N.
#include "physics/analysis/euler_terms.h"
#include "physics/exact/powers_of_two.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"
#include "render/scene/model/transport_arrow.h"

#include <algorithm>
#include <cmath>

namespace polhode::builders {
namespace {

constexpr double kRadius = 0.0135;
constexpr double kTooShort = 0.03;  // for an arrow, scene units

/// a + b = sum. Rates seen from the body are green as the polhode is, those seen from space as the
/// herpolhode, the term of the turning as ω.
struct Side {
  Vec3 along_V;
  const char* name;
  Role role;
  double dash = 0.0;
};

void add_side(const Snapshot& m, const Side& side, const Vec3& from_V, double radius, DrawList& list) {
  if (!(side.along_V.norm() > kTooShort)) return;  // NaN too: the motion does not reach so far
  list.arrows.push_back({.tail = from_V,
                         .tip = from_V + side.along_V,
                         .radius = radius,
                         .color = side.role.paint,
                         .dash = side.dash});
  if (m.shows(Overlay::labels))
    list.labels.push_back(
        {.text = side.name, .anchor = from_V + 0.55 * side.along_V, .color = side.role.ink, .size = 0.95});
}

/// a from `at`, b from its end, and the sum from `at` to where b ends. Sides of a triangle that has no area
/// lie beside one another.
void add_triangle(const Snapshot& m, const Side& a, const Side& b, const Side& sum, const Vec3& at_V,
                  double radius, const Camera& camera, DrawList& list) {
  const double longest = std::max({a.along_V.norm(), b.along_V.norm(), sum.along_V.norm()});
  if (!(longest > 0.0)) return;
  Vec3 apart = Vec3::Zero();
  if (a.along_V.cross(b.along_V).norm() < 0.06 * longest * longest) {
    const Vec3& long_one = a.along_V.norm() > b.along_V.norm() ? a.along_V : b.along_V;
    apart = 2.8 * radius * long_one.cross(camera.eye - camera.target).normalized();
  }
  add_side(m, a, at_V - apart, radius, list);
  add_side(m, b, at_V + a.along_V + apart, radius, list);
  add_side(m, sum, at_V + (a.along_V.norm() > kTooShort ? apart : Vec3(-apart)), radius, list);
}

/// The part of the tip's path that has just been gone, in the frame of the view.
void add_trail_of_tip(const Snapshot& m, DrawList& list) {
  constexpr int kPoints = 120;
  Tube trail{.points = {}, .closed = false, .radius = 0.008, .color = kTRole.paint, .fade_start = 0.0};
  for (int n = 0; n <= kPoints; ++n) {
    const double t_s = m.t_s - 0.6 * m.model.span_s * (1.0 - static_cast<double>(n) / kPoints);
    const Vec3 A_S = arrow_A_S(m.model, t_s);
    trail.points.push_back(m.view == View::space ? A_S
                                                 : Vec3(m.model.motion->at(t_s).q_SB.conjugate() * A_S));
  }
  double length = 0.0;
  for (std::size_t n = 1; n < trail.points.size(); ++n)
    length += (trail.points[n] - trail.points[n - 1]).norm();
  if (length > kTooShort) list.tubes.push_back(std::move(trail));
}

}  // namespace

void add_transport(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.shows(Overlay::transport)) return;
  constexpr double kLongest = 1.0;  // of a rate as large as |ω₀||A|
  const ArrowRates rates = arrow_rates(m.model, m.t_s);
  const double speed = norm_of(m.model.scene.w0_B);
  const double scale = kLongest / (speed > 0.0 ? speed : 1.0);
  const Vec3 A_V = m.q_VS * rates.A_S;
  const auto drawn = [&](const Vec3& rate_S) -> Vec3 { return m.q_VS * (scale * rate_S); };
  const double radius = kRadius * m.thickness * m.emphasis(Overlay::transport);
  add_trail_of_tip(m, list);
  list.arrows.push_back({.tail = Vec3::Zero(), .tip = A_V, .radius = 1.2 * radius, .color = kTRole.paint});
  if (m.shows(Overlay::labels))
    list.labels.push_back(
        {.text = "$\\vec A$", .anchor = 0.55 * A_V, .color = kAxesRole.ink, .size = 1.2, .leader = false});
  add_triangle(m, {drawn(rates.star_rate_S), "$d^*\\!\\vec A/dt$", kPolhodeRole},
               {drawn(rates.turning_S), "$\\vec\\omega\\times\\vec A$", kOmegaRole, 0.04},
               {drawn(rates.rate_S), "$d\\vec A/dt$", kHerpolhodeRole}, A_V, radius, camera, list);
}

/// At the tip of L, where that is shown, they are its rates: d*L/dt and ω×L of dL/dt = d*L/dt + ω×L.
void add_terms(const Snapshot& m, const Camera& camera, DrawList& list) {
  if (!m.shows(Overlay::terms) || m.model.longest_term == 0.0) return;
  constexpr double kLongest = 1.0;
  const EulerTerms terms = euler_terms_at(*m.model.motion, m.I(), m.model.scene.torque, m.t_s);
  const double scale = kLongest / m.model.longest_term;
  const auto drawn = [&](const Vec3& term_B) -> Vec3 { return m.q_VB * (scale * term_B); };
  const double radius = kRadius * m.thickness * m.emphasis(Overlay::terms);
  const bool at_L = m.shows(Overlay::L);
  const Vec3 at_V = at_L ? m.L_tip_V() : Vec3(Vec3::Zero());
  add_triangle(m,
               {drawn(terms.inertial_B),
                at_L ? "$d^*\\!\\vec L/dt$" : "$\\mathbf I\\cdot\\dot{\\vec\\omega}$", kPolhodeRole},
               {drawn(terms.gyroscopic_B),
                at_L ? "$\\vec\\omega\\times\\vec L$" : "$\\vec\\omega\\times(\\mathbf I\\cdot\\vec\\omega)$",
                kOmegaRole},
               {drawn(terms.N_B), "$\\vec N$", kNRole, 0.045}, at_V, radius, camera, list);
}

}  // namespace polhode::builders
