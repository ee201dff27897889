// SPDX-License-Identifier: MIT
#include "render/gl/passes/sheet_geometry.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kHalfFringe = 0.5;    // px
constexpr double kLongestMiter = 2.5;  // times the fringe: tips sharper than that are cut

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the area, positive if the corners go from x to y.
double turning(const std::vector<Vec2>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return sum;
}

/// How far each corner moves when both its edges move out by one.
std::vector<Vec2> miters_of(const std::vector<Vec2>& corners) {
  const double side = turning(corners) < 0.0 ? -1.0 : 1.0;
  const std::size_t n = corners.size();
  std::vector<Vec2> normals, miters;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 edge = (corners[(i + 1) % n] - corners[i]).normalized();
    normals.emplace_back(side * edge.y(), -side * edge.x());
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 sum = normals[(i + n - 1) % n] + normals[i];
    miters.push_back(sum / std::max(0.5 * sum.squaredNorm(), sum.norm() / kLongestMiter + 1e-9));
  }
  return miters;
}

class ShapeBuilder {
 public:
  void add(const Area& area) {
    const std::vector<Vec2> corners = without_repeats(area.points);
    if (corners.size() < 3) return;
    const std::vector<Vec2> miters = miters_of(corners);
    Vec2 centroid(0, 0);
    std::vector<Vec2> inner, outer;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      centroid += corners[i] / static_cast<double>(corners.size());
      inner.push_back(corners[i] - kHalfFringe * miters[i]);
      outer.push_back(corners[i] + kHalfFringe * miters[i]);
    }
    add_fringed(centroid, inner, outer, area.color);
  }

  void add(const Stroke& stroke) {
    Stroke shown = stroke;
    if (shown.width < 1.0) {
      shown.color.a *= static_cast<float>(std::max(0.0, shown.width));
      shown.width = 1.0;
    }
    if (shown.dash > 0.0)
      add_dashes(shown);
    else
      for (std::size_t i = 1; i < shown.points.size(); ++i)
        add_piece(shown.points[i - 1], shown.points[i], shown);
  }

  Geometry<ShapeVertex> made;

 private:
  static std::vector<Vec2> without_repeats(const std::vector<Vec2>& given) {
    std::vector<Vec2> corners;
    for (const Vec2& c : given)
      if (corners.empty() || (c - corners.back()).norm() > 1e-6) corners.push_back(c);
    while (corners.size() > 1 && (corners.front() - corners.back()).norm() <= 1e-6) corners.pop_back();
    return corners;
  }

  void add_vertex(const Vec2& p, const Color& c, float coverage) {
    const float a = c.a * coverage;
    made.vertices.push_back(
        {{static_cast<float>(p.x()), static_cast<float>(p.y())}, {c.r * a, c.g * a, c.b * a, a}, kNoPiece});
  }

  /// Full colour within `inner`, which is seen whole from `center`, none outside `outer`.
  void add_fringed(const Vec2& center, const std::vector<Vec2>& inner, const std::vector<Vec2>& outer,
                   const Color& color) {
    const auto n = static_cast<std::uint32_t>(inner.size());
    const auto first = static_cast<std::uint32_t>(made.vertices.size());
    add_vertex(center, color, 1.0F);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      add_vertex(inner[i], color, 1.0F);
      add_vertex(outer[i], color, 0.0F);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t in = first + 1 + 2 * i, next_in = first + 1 + 2 * ((i + 1) % n);
      for (std::uint32_t k : {first, in, next_in, in, in + 1, next_in, next_in, in + 1, next_in + 1})
        made.indices.push_back(k);
    }
  }

  /// A straight piece with round ends.
  void add_piece(const Vec2& from, const Vec2& to, const Stroke& stroke) {
    const Vec2 middle = 0.5 * (from + to), way = to - from;
    const double half = 0.5 * way.norm(), radius = 0.5 * stroke.width;
    const Vec2 along = half > 0.0 ? Vec2(way / (2.0 * half)) : Vec2(1.0, 0.0), across(-along.y(), along.x());
    const double reach = radius + kHalfFringe;
    const Color& c = stroke.color;
    const auto first = static_cast<std::uint32_t>(made.vertices.size());
    for (int k = 0; k < 4; ++k) {
      const double x = (k & 1 ? 1.0 : -1.0) * (half + reach), y = (k & 2 ? 1.0 : -1.0) * reach;
      const Vec2 p = middle + x * along + y * across;
      made.vertices.push_back({{static_cast<float>(p.x()), static_cast<float>(p.y())},
                               {c.r * c.a, c.g * c.a, c.b * c.a, c.a},
                               {static_cast<float>(x), static_cast<float>(y), static_cast<float>(half),
                                static_cast<float>(radius)}});
    }
    for (std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) made.indices.push_back(first + k);
  }

  void add_dashes(const Stroke& stroke) {
    double along = 0.0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      const Vec2 from = stroke.points[i - 1], way = stroke.points[i] - from;
      const double length = way.norm();
      const auto place = [&](double s) {
        return Vec2(from + way * (std::clamp(s - along, 0.0, length) / length));
      };
      const double period = 2.0 * stroke.dash;
      for (double s = std::floor(along / period) * period; s < along + length && length > 0.0; s += period)
        if (s + stroke.dash > along) add_piece(place(s), place(s + stroke.dash), stroke);
      along += length;
    }
  }
};

}  // namespace

Geometry<ShapeVertex> make_geometry(const std::vector<FlatShape>& shapes) {
  ShapeBuilder builder;
  for (const FlatShape& shape : shapes) std::visit([&](const auto& s) { builder.add(s); }, shape);
  return std::move(builder.made);
}

}  // namespace polhode
