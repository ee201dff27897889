// SPDX-License-Identifier: MIT
// Energy ellipsoid, momentum sphere and ellipsoid, invariable plane; body and space cones.
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <cmath>
#include <numbers>

namespace polhode::builders {
namespace {

constexpr double kSoftGraticule = 0.6;  // of the momentum sphere, behind or before the ellipsoid's own

/// Translucent fan from the origin over a curve, both sides visible.
Mesh fan(const std::vector<Vec3>& rim, bool closed, const Color& color) {
  Mesh mesh;
  mesh.color = color;
  const std::size_t n = rim.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const Vec3& a = rim[i];
    const Vec3& b = rim[(i + 1) % n];
    const Vec3 normal = a.cross(b).normalized();
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (const Vec3& p : {Vec3(Vec3::Zero()), a, b}) {
      mesh.positions.push_back(p);
      mesh.normals.push_back(normal);
    }
    for (unsigned k = 0; k < 3; ++k) mesh.triangles.push_back(first + k);
  }
  return mesh;
}

std::vector<Vec3> to_view(const Curve& curve, const Quat& q, double scale) {
  std::vector<Vec3> points;
  points.reserve(curve.points.size());
  for (const Vec3& p : curve.points) points.push_back(q * (scale * p));
  return points;
}

/// The herpolhode until it has gone once round z (L's axis): further rounds would lie on the first.
Curve first_round(const Curve& herpolhode_S) {
  const std::vector<Vec3>& points = herpolhode_S.points;
  double turned = 0.0;
  std::size_t n = 1;
  for (; n < points.size() && std::abs(turned) < 2.0 * std::numbers::pi; ++n) {
    const Vec3 &a = points[n - 1], &b = points[n];
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  return {{points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n)}, false};
}

}  // namespace

double plane_z(const Snapshot& m) {
  if (m.model.scene.w0_B.isZero(0.0)) return -1.0;
  // From the start, not from t: it is invariable, and a drift of the motion shall show.
  return -invariable_plane_distance(m.I(), m.model.scene.w0_B) * m.omega_scale;
}

const Vec3& w_B_of_surfaces(const Snapshot& m) {
  return m.model.scene.torque.empty() ? m.model.scene.w0_B : m.state.w_B;
}

Vec3 onto_plane(const Snapshot& m, const Tube& tube) {
  const bool is_drawn = m.shows(Overlay::plane) && m.view == View::space;
  return is_drawn ? Vec3(0.0, 0.0, tube.radius) : Vec3(Vec3::Zero());
}

void add_surfaces(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  const Vec3& w_B = w_B_of_surfaces(m);
  if (w_B.isZero(0.0)) return;
  const double L = norm_of(angular_momentum_B(m.I(), w_B));
  if (m.shows(Overlay::energy_ellipsoid))
    list.ellipsoids.push_back({.rotation = m.q_VB,
                               .semi_axes = energy_ellipsoid_semi_axes(m.I(), w_B) * m.omega_scale,
                               .tint = kGlassTint});
  if (m.shows(Overlay::momentum_ellipsoid))
    list.ellipsoids.push_back({.rotation = m.q_VB,
                               .semi_axes = momentum_ellipsoid_semi_axes(m.I(), w_B) * m.L_scale,
                               .tint = kGlassTint});
  if (m.shows(Overlay::momentum_sphere))
    list.ellipsoids.push_back({.rotation = m.q_VB,
                               .semi_axes = m.L_scale > 0.0
                                                ? Vec3(Vec3::Constant(L * m.L_scale))
                                                : Vec3(L * m.omega_scale * m.I().vector().cwiseInverse()),
                               .tint = kSphereTint,
                               .graticule = kSoftGraticule});
  if (m.shows(Overlay::plane) && m.view == View::space) list.floors.push_back({.z = plane_z(m)});
}

void add_cones(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (!m.model.needs.cones) return;
  constexpr float kAlpha = 0.30F;
  const auto translucent = [&](Color c) { return Color{c.r, c.g, c.b, kAlpha}; };
  const Curve& polhode_B = m.model.polhode_B;
  if (polhode_B.points.size() > 2)
    list.meshes.push_back(
        fan(to_view(polhode_B, m.q_VB, m.omega_scale), polhode_B.closed, translucent(kPolhodeRole.paint)));
  if (m.view == View::space && m.model.herpolhode_S.points.size() > 2)
    list.meshes.push_back(fan(to_view(first_round(m.model.herpolhode_S), m.q_VS, m.omega_scale), false,
                              translucent(kHerpolhodeRole.paint)));
}

}  // namespace polhode::builders
