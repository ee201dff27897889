// SPDX-License-Identifier: MIT
// Polhode, its family, separatrices, herpolhode.
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>

namespace polhode::builders {
namespace {

constexpr double kFamilyRadius = 0.0062;

/// Curves were computed for the energy of t = 0. ω scales with √T, and so do curves of the same L²/2T.
double growth(const Snapshot& m) {
  const Vec3& w0_B = m.model.scene.w0_B;
  if (m.model.scene.torque.empty() || w0_B.isZero(0.0)) return 1.0;
  const int e = exponent_of(w0_B);  // lest the energies leave the range of double
  const auto T = [&](const Vec3& w_B) { return kinetic_energy(m.I(), times_two_to(-e, w_B)); };
  return std::sqrt(T(m.state.w_B) / T(w0_B));
}

/// Body components of ω-space, or of L-space where the scene shows that, to the view.
Vec3 place(const Snapshot& m, const Vec3& w_B) {
  if (m.L_scale > 0.0) return m.q_VB * (angular_momentum_B(m.I(), w_B) * m.L_scale);
  return m.q_VB * (w_B * m.omega_scale);
}

void add_body_curve(const Snapshot& m, const Curve& curve, double radius, const Color& color,
                    DrawList& list) {
  if (curve.points.size() < 2) return;
  Tube tube{.points = {}, .closed = curve.closed, .radius = radius * m.thickness, .color = color};
  tube.points.reserve(curve.points.size());
  const double scale = growth(m);
  for (const Vec3& w_B : curve.points) tube.points.push_back(place(m, scale * w_B));
  list.tubes.push_back(std::move(tube));
}

/// A surface of constant T and one of constant |L| meet in the polhode and in its mirror image.
bool surfaces_meet(const Snapshot& m) {
  return m.model.needs.polhode && m.shows(Overlay::polhode) && m.shows(Overlay::momentum_sphere) &&
         (m.shows(Overlay::momentum_ellipsoid) || m.shows(Overlay::energy_ellipsoid));
}

void add_herpolhode(const Snapshot& m, DrawList& list) {
  Curve local;
  const Curve* curve_S = &m.model.herpolhode_S;
  const auto [from_s, to_s] = herpolhode_times_s(m);
  if (from_s != 0.0) {
    local = herpolhode(*m.model.motion, from_s, to_s, 2e-4 / m.omega_scale);
    curve_S = &local;
  }
  Tube tube{.points = {},
            .closed = curve_S->closed,
            .radius = kHerpolhodeRadius * m.thickness * m.emphasis(Overlay::herpolhode),
            .color = kHerpolhodeRole.paint};
  const Vec3 lift = onto_plane(m, tube);
  for (const Vec3& w_S : curve_S->points) tube.points.push_back(m.q_VS * (w_S * m.omega_scale) + lift);
  if (tube.points.size() > 1) list.tubes.push_back(std::move(tube));
}

}  // namespace

// What is computed once, or outside of that the stretch that ends now.
std::pair<double, double> herpolhode_times_s(const Snapshot& m) {
  const double span_s = herpolhode_span_s(m.model.scene);
  return m.t_s < 0.0 || m.t_s > span_s ? std::pair(m.t_s - span_s, m.t_s) : std::pair(0.0, span_s);
}

double scale_place(const PrincipalMoments& I, double L2_over_2T) {
  Vec3 s = I.vector();
  std::sort(s.begin(), s.end());
  if (L2_over_2T <= s[1]) return s[1] > s[0] ? 0.5 * (L2_over_2T - s[0]) / (s[1] - s[0]) : 0.5;
  return s[2] > s[1] ? 0.5 + 0.5 * (L2_over_2T - s[1]) / (s[2] - s[1]) : 0.5;
}

void add_curves(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (m.model.needs.polhode_family)
    for (const PolhodeOfFamily& member : m.model.family_B)
      for (const Curve& branch : member.branches)
        add_body_curve(m, branch, kFamilyRadius, family_color(scale_place(m.I(), member.L2_over_2T)), list);
  if (m.model.needs.separatrix)
    for (const Curve& ellipse : m.model.separatrices_B)
      add_body_curve(m, ellipse, kFamilyRadius * 1.3 * m.emphasis(Overlay::separatrix), kSeparatrixPaint,
                     list);
  if (m.model.needs.polhode)
    add_body_curve(m, m.model.polhode_B, kPolhodeRadius * m.emphasis(Overlay::polhode), kPolhodeRole.paint,
                   list);
  if (surfaces_meet(m)) {
    Curve opposite = m.model.polhode_B;
    for (Vec3& w_B : opposite.points) w_B = -w_B;
    add_body_curve(m, opposite, kFamilyRadius, kPolhodeRole.paint, list);
  }
  if (m.model.needs.herpolhode && m.view == View::space) add_herpolhode(m, list);
}

}  // namespace polhode::builders
