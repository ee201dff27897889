// SPDX-License-Identifier: MIT
#include "render/gl/passes/geometry.h"

#include "render/gl/passes/far_sides.h"
#include "render/gl/passes/floats.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

constexpr int kConeSegments = 40;
constexpr int kBallRows = 16;
constexpr float kInBody = 0.42F;  // of the opacity of what is seen through a body

/// Tangent where two segments meet: their mean along a smooth curve, the segment's own at a corner.
Vec3 tangent_between(const Vec3& own, const Vec3& neighbour) {
  constexpr double kCorner = 0.87;  // cosine of 30 degrees
  return own.dot(neighbour) > kCorner ? Vec3((own + neighbour).normalized()) : own;
}

void append_tube(const Tube& tube, Geometry<TubeVertex>& out) {
  const std::vector<SegmentTangents> tangents = tangents_of(tube);
  const double segments = static_cast<double>(tangents.size());
  const double dashes = tube.dash > 0.0 ? 1.0 / tube.dash : 0.0;
  double along = 0.0;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const std::array<Vec3, 2> ends = {tube.points[i], tube.points[(i + 1) % tube.points.size()]};
    const double length = (ends[1] - ends[0]).norm();
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    for (std::size_t at_end = 0; at_end < 2; ++at_end)
      for (float side : {-1.0F, 1.0F})
        out.vertices.push_back(
            {floats(ends[at_end]),
             floats(at_end ? tangents[i].end : tangents[i].start),
             floats(tube.color, std::lerp(tube.fade_start, 1.0, static_cast<double>(i + at_end) / segments)),
             {side, static_cast<float>(tube.radius),
              static_cast<float>((along + static_cast<double>(at_end) * length) * dashes)}});
    for (std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) out.indices.push_back(first + k);
    along += length;
  }
}

/// Surface of revolution about `axis`: a cone from a ring of radius r0 at `a` to one of radius r1 at `b`.
void append_frustum(const Vec3& a, const Vec3& b, double r0, double r1, const Color& color,
                    Geometry<MeshVertex>& out) {
  const Vec3 axis = direction(a, b);
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  const double slope = (r0 - r1) / std::max((b - a).norm(), 1e-12);
  const auto first = static_cast<std::uint32_t>(out.vertices.size());
  for (int i = 0; i <= kConeSegments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kConeSegments;
    const Vec3 radial = std::cos(angle) * u + std::sin(angle) * v;
    const Vec3 normal = std::isfinite(slope) && (b - a).norm() > 1e-9
                            ? Vec3((radial + slope * axis).normalized())
                            : Vec3(-axis);
    out.vertices.push_back({floats(Vec3(a + r0 * radial)), floats(normal), floats(color)});
    out.vertices.push_back({floats(Vec3(b + r1 * radial)), floats(normal), floats(color)});
  }
  for (std::uint32_t i = 0; i < kConeSegments; ++i)
    for (std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) out.indices.push_back(first + 2 * i + k);
}

/// Disc that closes the wide end of a cone.
void append_disc(const Vec3& center, const Vec3& normal, double radius, const Color& color,
                 Geometry<MeshVertex>& out) {
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  const auto first = static_cast<std::uint32_t>(out.vertices.size());
  out.vertices.push_back({floats(center), floats(normal), floats(color)});
  for (int i = 0; i <= kConeSegments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kConeSegments;
    const Vec3 p = center + radius * (std::cos(angle) * u + std::sin(angle) * v);
    out.vertices.push_back({floats(p), floats(normal), floats(color)});
  }
  for (std::uint32_t i = 1; i <= kConeSegments; ++i)
    for (std::uint32_t k : {0U, i, i + 1}) out.indices.push_back(first + k);
}

void append_cone(const Vec3& base, const Vec3& tip, double radius, const Color& color,
                 Geometry<MeshVertex>& out) {
  append_frustum(base, tip, radius, 0.0, color, out);
  append_disc(base, -direction(base, tip), radius, color, out);
}

void append_arrow(const Arrow& arrow, PaneGeometry& out) {
  const auto parts = parts_of(arrow);
  if (!parts) return;
  append_tube(parts->shaft, out.tubes);
  append_cone(parts->head.base, parts->head.tip, parts->head.radius, parts->head.color, out.solid);
}

void append_ball(const Ball& ball, Geometry<MeshVertex>& out) {
  const auto first = static_cast<std::uint32_t>(out.vertices.size());
  constexpr int kColumns = 2 * kBallRows;
  for (int j = 0; j <= kBallRows; ++j)
    for (int i = 0; i <= kColumns; ++i) {
      const double polar = std::numbers::pi * j / kBallRows, turn = 2.0 * std::numbers::pi * i / kColumns;
      const Vec3 n(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
      out.vertices.push_back({floats(Vec3(ball.center + ball.radius * n)), floats(n), floats(ball.color)});
    }
  constexpr std::uint32_t kRow = kColumns + 1;
  for (std::uint32_t j = 0; j < kBallRows; ++j)
    for (std::uint32_t i = 0; i < kColumns; ++i)
      for (std::uint32_t k : {0U, kRow, kRow + 1, 0U, kRow + 1, 1U})
        out.indices.push_back(first + j * kRow + i + k);
}

Color faint(const Color& c, float part) { return {c.r, c.g, c.b, c.a * part}; }

/// Shaft and head as one layer, for what lies over itself would be less faint there.
void append_in_body(const Arrow& arrow, Geometry<TubeVertex>& out) {
  const auto parts = parts_of(arrow);
  if (!parts) return;
  Tube shaft = parts->shaft;
  shaft.points.back() = parts->head.base;
  shaft.color = faint(shaft.color, kInBody);
  append_tube(shaft, out);
  const Cone& head = parts->head;
  append_tube({.points = {head.base, head.tip}, .radius = head.radius, .color = shaft.color}, out);
  for (std::size_t k = out.vertices.size() - 2; k < out.vertices.size(); ++k) out.vertices[k].shape[1] = 0.0F;
}

void append_mesh(const Mesh& mesh, Geometry<MeshVertex>& out) {
  const auto first = static_cast<std::uint32_t>(out.vertices.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    out.vertices.push_back({floats(mesh.positions[i]), floats(mesh.normals[i]), floats(mesh.color)});
  for (unsigned k : mesh.triangles) out.indices.push_back(first + k);
}

}  // namespace

Vec3 direction(const Vec3& from, const Vec3& to) {
  const Vec3 d = to - from;
  const double length = d.norm();
  return length > 0.0 ? Vec3(d / length) : Vec3(Vec3::Zero());
}

std::vector<SegmentTangents> tangents_of(const Tube& tube) {
  const std::size_t n = tube.points.size();
  if (n < 2) return {};
  std::vector<Vec3> own(tube.closed ? n : n - 1);
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = direction(tube.points[i], tube.points[(i + 1) % n]);
  std::vector<SegmentTangents> tangents(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool has_before = tube.closed || i > 0, has_after = tube.closed || i + 1 < own.size();
    tangents[i].start = has_before ? tangent_between(own[i], own[(i + own.size() - 1) % own.size()]) : own[i];
    tangents[i].end = has_after ? tangent_between(own[i], own[(i + 1) % own.size()]) : own[i];
  }
  return tangents;
}

std::optional<ArrowParts> parts_of(const Arrow& arrow) {
  const double length = (arrow.tip - arrow.tail).norm();
  if (length <= 0.0) return std::nullopt;
  const Vec3 axis = direction(arrow.tail, arrow.tip);
  const double head = std::min(6.6 * arrow.radius, 0.45 * length);
  const Vec3 neck = arrow.tip - head * axis;
  ArrowParts parts;
  parts.shaft = {.points = {arrow.tail, neck + 0.15 * head * axis},
                 .radius = arrow.radius,
                 .color = arrow.color,
                 .dash = arrow.dash};
  parts.head = {neck, arrow.tip, 0.38 * head, arrow.color};
  return parts;
}

PaneGeometry make_geometry(const DrawList& list, const Vec3& eye) {
  PaneGeometry out;
  for (const Tube& tube : with_faint_far_sides(list, eye))
    append_tube(tube, tube.fade_start < 1.0 ? out.faded_tubes : out.tubes);
  for (const Arrow& arrow : list.arrows) append_arrow(arrow, out);
  for (const Ball& ball : list.balls) append_ball(ball, out.solid);
  for (const Mesh& mesh : list.meshes) append_mesh(mesh, mesh.color.a < 1.0F ? out.translucent : out.bodies);
  if (out.bodies.indices.empty()) return out;
  for (const Arrow& arrow : list.arrows) append_in_body(arrow, out.arrows_in_bodies);
  const float one_side = 1.0F - std::sqrt(1.0F - kInBody);  // a ball is seen through twice
  for (Ball ball : list.balls) {
    ball.color = faint(ball.color, one_side);
    append_ball(ball, out.balls_in_bodies);
  }
  return out;
}

}  // namespace polhode
