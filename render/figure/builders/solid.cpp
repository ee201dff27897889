// SPDX-License-Identifier: MIT
// The body itself as lit meshes: box, ellipsoid, cylinder, T-handle.
#include "physics/body/euler.h"
#include "render/figure/builders/builders.h"
#include "render/figure/builders/extents.h"
#include "render/figure/builders/parts.h"
#include "render/palette.h"
#include "render/scene/model/heavy_top_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace polhode::builders {
namespace {

constexpr int kSegments = 64;
constexpr double kInsideGlass = 0.84;  // of the energy ellipsoid, for a body drawn in it
constexpr Color kSteel = color_from_hex(0xB7B4AD), kSteelEdge = color_from_hex(0x7E7A72);

}  // namespace

void add_quad(Mesh& mesh, const std::array<Vec3, 4>& corners, const Vec3& normal) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (const Vec3& corner : corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normal);
  }
  for (unsigned k : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.triangles.push_back(first + k);
}

Part box_part(const Vec3& half) {
  Part part;
  part.mesh.color = kSolid;
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {-1, 1}) {
      const Vec3 n = side * Vec3::Unit(axis);
      const Vec3 u = half[(axis + 1) % 3] * Vec3::Unit((axis + 1) % 3);
      const Vec3 v = side * half[(axis + 2) % 3] * Vec3::Unit((axis + 2) % 3);
      const Vec3 c = half[axis] * n;
      add_quad(part.mesh, {c - u - v, c + u - v, c + u + v, c - u + v}, n);
      part.edges.push_back({.points = {c - u - v, c + u - v, c + u + v, c - u + v},
                            .closed = true,
                            .radius = kEdgeRadius,
                            .color = kBodyEdge});
    }
  return part;
}

namespace {

Vec3 on_circle(double turn, double rx, double ry, double z) {
  const double a = 2.0 * std::numbers::pi * turn;
  return {rx * std::cos(a), ry * std::sin(a), z};
}

}  // namespace

Part cylinder_part(const Vec3& half) {
  Part part;
  part.mesh.color = kSolid;
  std::array<Tube, 2> rims;
  for (int i = 0; i < kSegments; ++i) {
    const double t0 = static_cast<double>(i) / kSegments, t1 = static_cast<double>(i + 1) / kSegments;
    const Vec3 a = on_circle(t0, half.x(), half.y(), -half.z()),
               b = on_circle(t1, half.x(), half.y(), -half.z());
    const Vec3 up(0, 0, 2.0 * half.z());
    add_quad(part.mesh, {a, b, b + up, a + up}, Vec3::Zero());
    const Vec3 na = on_circle(t0, half.y(), half.x(), 0).normalized();
    const Vec3 nb = on_circle(t1, half.y(), half.x(), 0).normalized();
    const std::size_t last = part.mesh.normals.size();
    part.mesh.normals[last - 4] = part.mesh.normals[last - 1] = na;
    part.mesh.normals[last - 3] = part.mesh.normals[last - 2] = nb;
    for (int side : {-1, 1}) {
      const double z = side * half.z();
      const Vec3 c(0, 0, z), p(a.x(), a.y(), z), q(b.x(), b.y(), z);
      add_quad(part.mesh, {c, p, q, c}, side * Vec3::UnitZ());
      rims[side > 0].points.push_back(p);
    }
  }
  for (Tube& rim : rims) {
    rim.closed = true;
    rim.radius = kEdgeRadius;
    rim.color = kBodyEdge;
    part.edges.push_back(rim);
  }
  return part;
}

namespace {

Part ellipsoid(const Vec3& half) {
  Part part;
  part.mesh.color = kSolid;
  const int rows = kSegments / 2;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= kSegments; ++i) {
      const double polar = std::numbers::pi * j / rows;
      Vec3 n =
          on_circle(static_cast<double>(i) / kSegments, std::sin(polar), std::sin(polar), std::cos(polar));
      part.mesh.positions.push_back(half.cwiseProduct(n));
      part.mesh.normals.push_back(n.cwiseQuotient(half).normalized());
    }
  const auto row = static_cast<unsigned>(kSegments + 1);
  for (unsigned j = 0; j < static_cast<unsigned>(rows); ++j)
    for (unsigned i = 0; i < static_cast<unsigned>(kSegments); ++i)
      for (unsigned k : {j * row + i, (j + 1) * row + i, (j + 1) * row + i + 1, j * row + i,
                         (j + 1) * row + i + 1, j * row + i + 1})
        part.mesh.triangles.push_back(k);
  for (int axis = 0; axis < 3; ++axis) {  // three great ellipses make the turning visible
    Tube ring{.points = {}, .closed = true, .radius = kEdgeRadius, .color = kBodyEdge};
    for (int i = 0; i < kSegments; ++i) {
      const Vec3 c = on_circle(static_cast<double>(i) / kSegments, 1.0, 1.0, 0.0);
      const Vec3 turned(c[axis % 3], c[(axis + 1) % 3], c[(axis + 2) % 3]);
      ring.points.push_back(half.cwiseProduct(turned) * 1.001);
    }
    part.edges.push_back(std::move(ring));
  }
  return part;
}

/// Two diameters on each face of a cylinder: its turning can be seen.
void add_diameters(Part& part, const Vec3& half) {
  constexpr double kProud = 1.01;
  for (double z : {-half.z(), half.z()})
    for (int axis : {0, 1}) {
      const Vec3 end = half[axis] * Vec3::Unit(axis), up = kProud * z * Vec3::UnitZ();
      part.edges.push_back(
          {.points = {up - end, up + end}, .closed = false, .radius = kEdgeRadius, .color = kBodyEdge});
    }
}

}  // namespace

void turn_and_move(Part& part, const Quat& q, const Vec3& by) {
  for (Vec3& p : part.mesh.positions) p = q * p + by;
  for (Vec3& n : part.mesh.normals) n = q * n;
  for (Tube& edge : part.edges)
    for (Vec3& p : edge.points) p = q * p + by;
}

namespace {

/// A bar of a T-handle: a cylinder turned from axis 3 to lie along `axis`.
Part bar(double diameter, double length, const Vec3& axis, const Vec3& center) {
  Part part = cylinder_part(0.5 * Vec3(diameter, diameter, length));
  part.mesh.color = kSteel;
  for (Tube& edge : part.edges) edge.color = kSteelEdge;
  turn_and_move(part, shortest_rotation(Vec3::UnitZ(), axis), center);
  return part;
}

/// The stem runs on to the crossbar's axis, so that the two are one piece of steel.
std::vector<Part> t_handle(const Vec3& size_m) {
  const THandleGeometry g = t_handle_geometry(size_m);
  const double more = 0.5 * g.diameter_m;
  Part crossbar = bar(g.diameter_m, g.crossbar_length_m, Vec3::UnitX(), Vec3(0.0, g.crossbar_at_m, 0.0));
  Part stem =
      bar(g.diameter_m, g.stem_length_m + more, Vec3::UnitY(), Vec3(0.0, g.stem_at_m + 0.5 * more, 0.0));
  stem.edges.erase(stem.edges.begin() + 1);  // the rim inside the crossbar
  return {std::move(crossbar), std::move(stem)};
}

std::vector<Part> parts_of(const Shape& shape) {
  const Vec3 half = 0.5 * shape.size_m;
  switch (shape.kind) {
    case ShapeKind::box:
      return {box_part(half)};
    case ShapeKind::ellipsoid:
      return {ellipsoid(half)};
    case ShapeKind::cylinder:
      return {cylinder_part(half)};
    case ShapeKind::t_handle:
      return t_handle(shape.size_m);
  }
  return {box_part(half)};
}

/// Largest factor by which the parts may grow and still lie within the ellipsoid of these semi-axes.
double fit(const std::vector<Part>& parts, const Vec3& semi_axes) {
  double reach = 0.0;
  for (const Part& part : parts)
    for (const Vec3& p : part.mesh.positions) reach = std::max(reach, p.cwiseQuotient(semi_axes).norm());
  return reach > 0.0 ? 1.0 / reach : 1.0;
}

void add_patch(const Quat& q_VB, const Vec3& center_B, double half_1, double half_2, const Color& color,
               DrawList& list) {
  Mesh patch;
  patch.color = color;
  const Vec3 u = half_1 * Vec3::UnitX(), v = half_2 * Vec3::UnitY();
  add_quad(patch,
           {q_VB * (center_B - u - v), q_VB * (center_B + u - v), q_VB * (center_B + u + v),
            q_VB * (center_B - u + v)},
           q_VB * Vec3::UnitZ());
  list.meshes.push_back(std::move(patch));
}

/// A cover with a title on the face +3, its head towards +1: a box alone looks the same in four attitudes.
void add_cover(const Quat& q_VB, const Vec3& half, DrawList& list) {
  constexpr double kProud = 0.004;
  const Vec3 face(0.0, 0.0, half.z() + kProud);
  add_patch(q_VB, face, 0.9 * half.x(), 0.88 * half.y(), color_from_hex(0x7C93AB), list);
  add_patch(q_VB, face + Vec3(0.5 * half.x(), 0.0, kProud), 0.09 * half.x(), 0.58 * half.y(),
            color_from_hex(0xF2EFE8), list);
  add_patch(q_VB, face + Vec3(0.22 * half.x(), 0.0, kProud), 0.05 * half.x(), 0.36 * half.y(),
            color_from_hex(0xF2EFE8), list);
}

Vec3 room_for(const Snapshot& m, const Vec3& w_B) {
  if (m.shows(Overlay::energy_ellipsoid) && !w_B.isZero(0.0))
    return kInsideGlass * m.omega_scale * energy_ellipsoid_semi_axes(m.I(), w_B);
  return Vec3::Constant(kAloneRadius);
}

/// In m, about the pivot where the scene shows one.
std::vector<Part> parts_of(const Scene& scene, bool on_pivot, Look look = Look::solid) {
  if (!on_pivot)
    if (std::vector<Part> parts = look_of(scene.body, look); !parts.empty()) return parts;
  if (!on_pivot)
    return parts_of(scene.body.shape.value_or(equivalent_box(scene.body.moments, scene.body.mass_kg)));
  const HeavyTopBody body = heavy_top_body(scene, *heavy_top_of(scene));
  std::vector<Part> parts = parts_of(body.shape);
  if (body.shape.kind == ShapeKind::cylinder) add_diameters(parts.front(), 0.5 * body.shape.size_m);
  for (Part& part : parts) turn_and_move(part, Quat::Identity(), body.center_B);
  return parts;
}

/// In their own colours, or all in one, with lines along the edges of this opacity.
void add_parts(std::vector<Part> parts, const Quat& q_VB, double scale, const std::optional<Color>& color,
               float edges, DrawList& list) {
  for (Part& part : parts) {
    for (Vec3& p : part.mesh.positions) p = q_VB * (scale * p);
    for (Vec3& n : part.mesh.normals) n = q_VB * n;
    for (Tube& edge : part.edges) {
      for (Vec3& p : edge.points) p = q_VB * (scale * p);
      edge.color.a = edges;
      edge.of_body = true;
      list.tubes.push_back(std::move(edge));
    }
    if (color) part.mesh.color = *color;
    list.meshes.push_back(std::move(part.mesh));
  }
}

}  // namespace

double scene_units_per_m(const Snapshot& m) {
  return fit(parts_of(m.model.scene, m.shows(Overlay::pivot)), room_for(m, m.model.scene.w0_B));
}

std::vector<Vec3> solid_corners_B(const Snapshot& m) {
  const Body& body = m.model.scene.body;
  // A racket is known by its name and has no shape; what looks like a book keeps the size of its box.
  const bool has_look = !body.shape && !look_of(body, Look::solid).empty();
  const Shape shape = body.shape.value_or(equivalent_box(body.moments, body.mass_kg));
  const Vec3 half = 0.5 * shape.size_m;
  std::vector<Vec3> corners;
  const auto add_box = [&](const Vec3& center, const Vec3& half_size) {
    for (int k = 0; k < 8; ++k)
      corners.push_back(center +
                        half_size.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  };
  if (has_look) return corners;
  if (shape.kind == ShapeKind::box) {
    add_box(Vec3::Zero(), half);
  } else if (shape.kind == ShapeKind::cylinder) {
    constexpr int kCorners = 12;
    for (int k = 0; k < kCorners; ++k)
      for (const double side : {-1.0, 1.0})
        corners.push_back(on_circle(static_cast<double>(k) / kCorners, half.x(), half.y(), side * half.z()));
  } else if (shape.kind == ShapeKind::t_handle) {
    const THandleGeometry g = t_handle_geometry(shape.size_m);
    const double radius = 0.5 * g.diameter_m;
    add_box({0.0, g.crossbar_at_m, 0.0}, {0.5 * g.crossbar_length_m, radius, radius});
    add_box({0.0, g.stem_at_m, 0.0}, {radius, 0.5 * g.stem_length_m, radius});
  }
  double reach = 0.0;
  for (const Vec3& corner : corners) reach = std::max(reach, corner.norm());
  for (Vec3& corner : corners) corner *= kAloneRadius / reach;
  return corners;
}

void add_solid(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (!m.model.needs.solid) return;
  std::vector<Part> parts = parts_of(m.model.scene, m.shows(Overlay::pivot));
  const double scale = fit(parts, room_for(m, w_B_of_surfaces(m)));
  add_parts(std::move(parts), m.q_VB, scale, std::nullopt, 1.0F, list);
  if (m.turn && m.model.solid.kind == ShapeKind::box && look_of(m.model.scene.body, Look::solid).empty())
    add_cover(m.q_VB, 0.5 * scale * m.model.solid.size_m, list);
}

void add_poses(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (!draws_poses(m.model.scene) || m.view == View::body) return;
  constexpr float kPalest = 0.78F, kLeastPale = 0.45F;  // of the way from a body's colours to the haze
  constexpr Color kHaze = color_from_hex(0xE4E8EB);
  constexpr double kAtStart = 1e-9;  // a pose at t = 0 is there, however its time is rounded
  const std::vector<Part> parts = parts_of(m.model.scene, false);
  const double scale = fit(parts, room_for(m, w_B_of_surfaces(m)));
  const Poses& poses = m.model.scene.poses;
  for (int i = poses.count; i > 0; --i) {
    const double then_s = m.t_s - poses.over_s * i / poses.count;
    if (then_s < -kAtStart * poses.over_s) continue;
    const Snapshot then = snapshot_at(m.model, std::max(0.0, then_s), m.view);
    const float pale =
        std::lerp(kLeastPale, kPalest, static_cast<float>(i) / static_cast<float>(poses.count));
    std::vector<Part> placed = parts;
    for (Part& part : placed) {
      turn_and_move(part, Quat::Identity(), then.q_VB.conjugate() * (then.center_V - m.center_V) / scale);
      part.mesh.color = between(part.mesh.color, kHaze, pale);
      for (Tube& edge : part.edges) edge.color = between(edge.color, kHaze, pale);
    }
    add_parts(std::move(placed), then.q_VB, scale, std::nullopt, 1.0F, list);
  }
}

void add_ghost_of_solid(const Snapshot& m, const Quat& q_SB, DrawList& list) {
  if (!m.model.needs.solid || m.view == View::body) return;  // B is the body's own: there both would coincide
  constexpr float kAlpha = 0.38F, kEdges = 0.6F;
  constexpr double kLarger =
      1.004;  // where both coincide, their faces would show through each other in specks
  std::vector<Part> parts = parts_of(m.model.scene, m.shows(Overlay::pivot), Look::glass);
  const double scale = fit(parts, room_for(m, w_B_of_surfaces(m)));
  add_parts(std::move(parts), q_SB, kLarger * scale, Color{kGlassTint.r, kGlassTint.g, kGlassTint.b, kAlpha},
            kEdges, list);
}

}  // namespace polhode::builders
