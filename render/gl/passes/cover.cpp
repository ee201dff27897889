// SPDX-License-Identifier: MIT
#include "render/gl/passes/cover.h"

#include "render/gl/passes/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace polhode {
namespace {

constexpr int kRows = 16;  // of a band
// Samples lie up to half a pixel from its middle, and vertices are rounded to floats and parts of a pixel.
constexpr double kRounding = 1.0;

struct Interval {
  double from = std::numeric_limits<double>::infinity(), to = -from;
  void add(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

/// Columns of a triangle between two heights: its edges are cut there, for it is convex.
Interval columns_between(const std::array<Eigen::Vector2d, 3>& triangle, double low, double high) {
  Interval columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (a.y() >= low && a.y() <= high) columns.add(a.x());
    for (const double y : {low, high})
      if ((a.y() < y) != (b.y() < y)) columns.add(std::lerp(a.x(), b.x(), (y - a.y()) / (b.y() - a.y())));
  }
  return columns;
}

/// Points of the view's frame on the viewport.
class Projected {
 public:
  Projected(const Viewpoint& at, const PixelArea& viewport) : at_(at), viewport_(viewport) {}

  struct Seen {
    Eigen::Vector2d px;
    double distance;  ///< along the line of sight
  };
  std::optional<Seen> operator()(const Vec3& point) const {
    const Eigen::Vector4d clip = at_.view_projection * point.homogeneous();
    if (!(clip.w() > 0.0)) return std::nullopt;
    return Seen{pixels({clip.x() / clip.w(), clip.y() / clip.w()}), clip.w()};
  }
  Eigen::Vector2d pixels(const Eigen::Vector2d& clip) const {
    return {0.5 * (1.0 + clip.x()) * viewport_.width, 0.5 * (1.0 + clip.y()) * viewport_.height};
  }

  /// How far from it, px, what is within `radius` of a point in space can be seen. A step δ moves x/w by
  /// (δx − (x/w) δw) / (w + δw), which by Cauchy and Schwarz is at most |δ| √(1 + (x/w)²) / (w − |δ|).
  double reach(const Seen& point, double radius) const {
    const Eigen::Vector2d off_axis =
        at_.pixel * (point.px - 0.5 * Eigen::Vector2d(viewport_.width, viewport_.height));
    const double nearest = point.distance - radius;
    if (!(nearest > 0.0)) return std::numeric_limits<double>::infinity();
    return radius * std::sqrt(1.0 + off_axis.cwiseAbs2().maxCoeff()) / (at_.pixel * nearest);
  }

 private:
  const Viewpoint& at_;
  const PixelArea& viewport_;
};

/// A ball moved from one point to another: its outline lies within the larger reach of the line between them.
void add_swept_ball(const Vec3& a, const Vec3& b, double radius, const Projected& projected, Cover& cover) {
  const auto from = projected(a), to = projected(b);
  if (!from || !to) return cover.add_all();
  const double reach = std::max(projected.reach(*from, radius), projected.reach(*to, radius));
  cover.add({from->px, to->px, to->px}, reach + kRounding);
}

void add_tube(const Tube& tube, const Projected& projected, Cover& cover) {
  const std::size_t n = tube.points.size();
  for (std::size_t i = 0; i + (tube.closed ? 0 : 1) < n; ++i)
    add_swept_ball(tube.points[i], tube.points[(i + 1) % n], tube.radius, projected, cover);
}

void add_mesh(const Mesh& mesh, const Projected& projected, Cover& cover) {
  std::vector<Eigen::Vector2d> px;
  px.reserve(mesh.positions.size());
  for (const Vec3& position : mesh.positions) {
    const auto seen = projected(position);
    if (!seen) return cover.add_all();
    px.push_back(seen->px);
  }
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3)
    cover.add({px[mesh.triangles[i]], px[mesh.triangles[i + 1]], px[mesh.triangles[i + 2]]}, kRounding);
}

void add_glass(const GlassEllipsoid& e, const Viewpoint& at, const Projected& projected, Cover& cover) {
  const std::vector<Eigen::Vector2d> outline = outline_polygon(e, at.view_projection);
  for (std::size_t i = 2; i < outline.size(); ++i)
    cover.add({projected.pixels(outline[0]), projected.pixels(outline[i - 1]), projected.pixels(outline[i])},
              kRounding);
}

}  // namespace

Cover::Cover(const PixelArea& part)
    : part_(part), bands_(static_cast<std::size_t>((part.height + kRows - 1) / kRows)) {}

void Cover::add(const std::array<Eigen::Vector2d, 3>& triangle, double margin) {
  Interval rows;
  for (const Eigen::Vector2d& corner : triangle) rows.add(corner.y());
  if (!std::isfinite(margin + rows.from + rows.to)) return add_all();
  const int bands = static_cast<int>(bands_.size());
  const int first = static_cast<int>(std::clamp(std::floor((rows.from - margin) / kRows), 0.0, 1.0 * bands));
  const int last = static_cast<int>(std::clamp(std::floor((rows.to + margin) / kRows), -1.0, bands - 1.0));
  for (int band = first; band <= last; ++band) {
    const Interval columns = columns_between(triangle, band * kRows - margin, (band + 1) * kRows + margin);
    const auto column = [&](double x) {
      return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(part_.width)));
    };
    const Span added{column(std::floor(columns.from - margin)), column(std::ceil(columns.to + margin))};
    if (added.from >= added.to) continue;
    Span& span = bands_[static_cast<std::size_t>(band)];
    if (span.from >= span.to)
      span = added;
    else
      span = {std::min(span.from, added.from), std::max(span.to, added.to)};
  }
}

void Cover::add_all() { bands_.assign(bands_.size(), {0, part_.width}); }

std::vector<PixelArea> Cover::boxes() const {
  std::vector<PixelArea> boxes;
  for (std::size_t band = 0; band < bands_.size(); ++band) {
    const auto [from, to] = bands_[band];
    if (from >= to) continue;
    const int y = static_cast<int>(band) * kRows;
    boxes.push_back({from, y, to - from, std::min(kRows, part_.height - y)});
  }
  // Neighbours are joined where that adds the fewest pixels: boxes one above another stay apart.
  const auto joined = [](const PixelArea& low, const PixelArea& high) -> PixelArea {
    const int x = std::min(low.x, high.x);
    return {x, low.y, std::max(low.x + low.width, high.x + high.width) - x, high.y + high.height - low.y};
  };
  const auto area = [](const PixelArea& box) { return static_cast<double>(box.width) * box.height; };
  while (boxes.size() > kMostBoxes) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
      const double added = area(joined(boxes[i], boxes[i + 1])) - area(boxes[i]) - area(boxes[i + 1]);
      if (added >= least) continue;
      least = added;
      best = i;
    }
    boxes[best] = joined(boxes[best], boxes[best + 1]);
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  }
  for (PixelArea& box : boxes) {
    box.x += part_.x;
    box.y += part_.y;
  }
  return boxes;
}

Cover cover_of(const DrawList& list, const Viewpoint& at, const PixelArea& viewport) {
  Cover cover(viewport);
  const Projected projected(at, viewport);
  for (const Tube& tube : list.tubes) add_tube(tube, projected, cover);
  for (const Arrow& arrow : list.arrows)
    if (const auto parts = parts_of(arrow)) {
      add_tube(parts->shaft, projected, cover);
      add_swept_ball(parts->head.base, parts->head.tip, parts->head.radius, projected, cover);
    }
  for (const Ball& ball : list.balls) add_swept_ball(ball.center, ball.center, ball.radius, projected, cover);
  for (const Mesh& mesh : list.meshes) add_mesh(mesh, projected, cover);
  for (const GlassEllipsoid& e : list.ellipsoids) add_glass(e, at, projected, cover);
  return cover;
}

}  // namespace polhode
