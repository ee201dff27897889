// SPDX-License-Identifier: MIT
// What bodies of everyday life look like: a box of the moments of a book is drawn as a book. Lengths in m,
// along the body's own axes.
#include "render/figure/builders/parts.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace polhode::builders {
namespace {

constexpr Color kCloth = color_from_hex(0x5E7F9E), kClothBack = color_from_hex(0xA9825A),
                kPages = color_from_hex(0xF3EDDF), kPageEdges = color_from_hex(0xC9BFA9),
                kGilt = color_from_hex(0xF2E7C6), kBand = color_from_hex(0x8C2F2B);
constexpr Color kCase = color_from_hex(0x59616C), kGlass = color_from_hex(0x1B222B),
                kLit = color_from_hex(0x8FA9C4), kLens = color_from_hex(0x10151B);
constexpr Color kFrame = color_from_hex(0x9C3B31), kString = color_from_hex(0xE9E4D6),
                kGrip = color_from_hex(0x4A4038);

/// A box of these half edges about a point.
Part block(const Vec3& center, const Vec3& half, const Color& color, bool has_edges) {
  Part part = box_part(half);
  part.mesh.color = color;
  if (!has_edges) part.edges.clear();
  turn_and_move(part, Quat::Identity(), center);
  return part;
}

/// A block with a quarter circle at each corner of its face, which is normal to axis 3.
Part rounded_block(const Vec3& half, double radius, const Color& color) {
  constexpr int kSteps = 8;
  Part part;
  part.mesh.color = color;
  Tube rim{.points = {}, .closed = true, .radius = kEdgeRadius, .color = kBodyEdge};
  std::vector<Vec3> outward;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = 0.5 * std::numbers::pi * (quarter + static_cast<double>(i) / kSteps);
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
      const double sx = quarter == 0 || quarter == 3 ? 1.0 : -1.0, sy = quarter < 2 ? 1.0 : -1.0;
      rim.points.emplace_back(sx * (half.x() - radius) + radius * out.x(),
                              sy * (half.y() - radius) + radius * out.y(), 0.0);
      outward.push_back(out);
    }
  const Vec3 up = half.z() * Vec3::UnitZ();
  const std::size_t n = rim.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Vec3 &a = rim.points[i], &b = rim.points[next];
    add_quad(part.mesh, {a - up, b - up, b + up, a + up}, Vec3::Zero());
    const std::size_t last = part.mesh.normals.size();
    part.mesh.normals[last - 4] = part.mesh.normals[last - 1] = outward[i];
    part.mesh.normals[last - 3] = part.mesh.normals[last - 2] = outward[next];
    add_quad(part.mesh, {up, a + up, b + up, up}, Vec3::UnitZ());
    add_quad(part.mesh, {-up, b - up, a - up, -up}, -Vec3::UnitZ());
  }
  for (const double side : {-1.0, 1.0}) {
    Tube edge = rim;
    for (Vec3& p : edge.points) p += side * up;
    part.edges.push_back(std::move(edge));
  }
  return part;
}

/// Boards of cloth with their spine towards −2, pages that stand back from them, a title on the front, which
/// is +3 with its head towards +1, a label on the back of another colour, and a rubber band that keeps it
/// shut.
std::vector<Part> book(const Vec3& size_m) {
  const Vec3 half = 0.5 * size_m;
  const double board = 0.16 * half.z(), back = 0.05 * half.y(), margin = 0.025 * half.x(),
               film = 0.012 * half.z();
  std::vector<Part> parts;
  const double leaves = half.z() - 2.0 * board;
  parts.push_back(block({0, 0, half.z() - board}, {half.x(), half.y(), board}, kCloth, true));
  parts.push_back(block({0, 0, board - half.z()}, {half.x(), half.y(), board}, kClothBack, true));
  parts.push_back(block({0, back - half.y(), 0}, {half.x(), back, leaves}, kCloth, false));
  parts.push_back(block({0, back - 0.5 * margin, 0},
                        {half.x() - margin, half.y() - back - 0.5 * margin, leaves}, kPages, false));
  Part& pages = parts.back();
  constexpr int kLeaves = 4;  // lines on the three cut edges
  for (int i = 1; i < kLeaves; ++i) {
    const double z = leaves * (2.0 * i / kLeaves - 1.0), x = half.x() - margin, y = half.y() - margin;
    pages.edges.push_back(
        {.points = {{-x, 2.0 * back - half.y(), z}, {-x, y, z}, {x, y, z}, {x, 2.0 * back - half.y(), z}},
         .radius = 0.35 * kEdgeRadius,
         .color = kPageEdges});
  }
  const auto printed = [&](double side, double x, double hx, double hy, const Color& color) {
    parts.push_back(
        block({x * half.x(), 0, side * half.z()}, {hx * half.x(), hy * half.y(), film}, color, false));
  };
  printed(1, 0.52, 0.085, 0.6, kGilt);
  printed(1, 0.26, 0.04, 0.4, kGilt);
  printed(1, -0.74, 0.03, 0.28, kGilt);
  printed(-1, -0.66, 0.13, 0.3, kGilt);
  const double around = 1.015;
  for (const double side : {-1.0, 1.0}) {
    parts.push_back(block({-0.32 * half.x(), 0, side * around * half.z()},
                          {0.03 * half.x(), around * half.y(), film}, kBand, false));
    parts.push_back(block({-0.32 * half.x(), side * around * half.y(), 0},
                          {0.03 * half.x(), film, around * half.z()}, kBand, false));
  }
  return parts;
}

/// A case with round corners; on +3 the screen, its head towards +1; on −3 the camera.
std::vector<Part> phone(const Vec3& size_m) {
  const Vec3 half = 0.5 * size_m;
  const double film = 0.03 * half.z();
  const auto on_face = [&](double side, const Vec2& at, Part part) {
    turn_and_move(part, Quat::Identity(), Vec3(at.x(), at.y(), side * half.z()));
    part.edges.clear();
    return part;
  };
  std::vector<Part> parts;
  parts.push_back(rounded_block(half, 0.24 * half.y(), kCase));
  for (Tube& edge : parts.back().edges) edge.color = kGlass;
  parts.push_back(
      on_face(1, {0, 0}, rounded_block({0.955 * half.x(), 0.91 * half.y(), film}, 0.17 * half.y(), kGlass)));
  const auto lit = [&](double x, double y, double hx, double hy) {
    parts.push_back(
        on_face(1, {x * half.x(), y * half.y()},
                rounded_block({hx * half.x(), hy * half.y(), 2.0 * film}, 0.8 * hx * half.x(), kLit)));
  };
  lit(0.58, 0, 0.05, 0.46);
  lit(0.43, 0, 0.025, 0.26);
  lit(-0.88, 0, 0.012, 0.3);
  const double side = 0.36 * half.y();
  const Vec2 corner(half.x() - 1.5 * side, 0.48 * half.y());
  parts.push_back(on_face(-1, corner, rounded_block({side, side, 0.25 * half.z()}, 0.45 * side, kCase)));
  parts.back().mesh.color = color_from_hex(0x474E58);
  for (const Vec2& lens : {Vec2(0.42, 0.42), Vec2(-0.42, 0.42), Vec2(0.0, -0.42)})
    parts.push_back(on_face(-1, corner + side * lens,
                            rounded_block({0.3 * side, 0.3 * side, 0.35 * half.z()}, 0.3 * side, kLens)));
  return parts;
}

/// An oval frame in the plane of 1 and 2 with its strings, towards +1; throat and grip towards −1. The centre
/// of mass lies where the throat begins.
std::vector<Part> racket() {
  constexpr double kHead = 0.165, kAcross = 0.125, kThick = 0.011, kFromButt = 0.335, kLength = 0.685;
  constexpr int kRound = 72, kLengthwise = 8, kCrosswise = 10;
  const double middle = kLength - kHead - kFromButt;
  std::vector<Part> parts(1);
  Part& frame = parts.front();
  frame.mesh.color = kFrame;
  const auto on_oval = [&](double turn, double grown) {
    const double angle = 2.0 * std::numbers::pi * turn;
    return Vec3(middle + (kHead + grown) * std::cos(angle), (kAcross + grown) * std::sin(angle), 0.0);
  };
  for (int i = 0; i < kRound; ++i) {
    const double t0 = static_cast<double>(i) / kRound, t1 = static_cast<double>(i + 1) / kRound;
    const Vec3 up = kThick * Vec3::UnitZ();
    const auto strip = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
      add_quad(frame.mesh, {a, b, c, d}, (b - a).cross(d - a).normalized());
    };
    const Vec3 outer0 = on_oval(t0, 0.0), outer1 = on_oval(t1, 0.0), inner0 = on_oval(t0, -kThick),
               inner1 = on_oval(t1, -kThick);
    strip(outer0 - up, outer1 - up, outer1 + up, outer0 + up);
    strip(inner1 - up, inner0 - up, inner0 + up, inner1 + up);
    strip(inner0 + up, outer0 + up, outer1 + up, inner1 + up);
    strip(outer0 - up, inner0 - up, inner1 - up, outer1 - up);
  }
  const auto string = [&](const Vec3& a, const Vec3& b) {
    frame.edges.push_back({.points = {a, b}, .radius = 0.4 * kEdgeRadius, .color = kString});
  };
  const double a = kHead - kThick, b = kAcross - kThick;
  for (int i = 1; i < kLengthwise; ++i) {
    const double y = b * (2.0 * i / kLengthwise - 1.0), x = a * std::sqrt(1.0 - y * y / (b * b));
    string({middle - x, y, 0.0}, {middle + x, y, 0.0});
  }
  for (int i = 1; i < kCrosswise; ++i) {
    const double x = a * (2.0 * i / kCrosswise - 1.0), y = b * std::sqrt(1.0 - x * x / (a * a));
    string({middle + x, -y, 0.0}, {middle + x, y, 0.0});
  }
  const double throat = middle - kHead, grip = -kFromButt, shaft = grip + 0.2;
  for (const double side : {-1.0, 1.0}) {  // the throat: two bars from the frame to the shaft
    const Vec3 from(throat + 0.035, side * 0.075, 0.0), to(shaft, side * 0.008, 0.0);
    Part bar = block(Vec3::Zero(), {0.5 * (to - from).norm(), 0.5 * kThick, kThick}, kFrame, false);
    turn_and_move(bar, shortest_rotation(Vec3::UnitX(), (to - from).normalized()), 0.5 * (from + to));
    parts.push_back(std::move(bar));
  }
  Part handle = cylinder_part(Vec3(0.015, 0.017, 0.5 * (shaft - grip)));
  handle.mesh.color = kGrip;
  turn_and_move(handle, shortest_rotation(Vec3::UnitZ(), Vec3::UnitX()),
                Vec3(0.5 * (shaft + grip), 0.0, 0.0));
  parts.push_back(std::move(handle));
  return parts;
}

}  // namespace

std::vector<Part> look_of(const Body& body) {
  const auto is_a = [&](std::string_view thing) { return body.name.ends_with(thing); };
  if (is_a("racket") && !body.shape) return racket();
  const Shape shape = body.shape.value_or(equivalent_box(body.moments, body.mass_kg));
  if (shape.kind != ShapeKind::box) return {};
  if (is_a("book")) return book(shape.size_m);
  if (is_a("phone")) return phone(shape.size_m);
  return {};
}

}  // namespace polhode::builders
