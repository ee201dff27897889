// SPDX-License-Identifier: MIT
#include "render/gl/passes/strokes.h"

#include "render/gl/passes/curve_pieces.h"
#include "render/gl/passes/far_sides.h"
#include "render/gl/passes/floats.h"
#include "render/gl/passes/viewpoint.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr float kFarFromEnds = 1e3F;  // scene units
/// Arrows are long and near one another; pieces of them are sorted as those of curves.
constexpr double kLongestPiece = 0.06;
constexpr double kShortest = 1e-9;  // scene units

/// Four vertices of `lines` or `solids`, two triangles.
struct Piece {
  double distance;  ///< of the near side from the eye
  Strokes::Kind kind;
  std::uint32_t first;
};

class Painter {
 public:
  Painter(const Vec3& eye, const std::vector<GlassEllipsoid>& glasses) : eye_(eye), glasses_(glasses) {}

  void add(const Tube& tube) {
    const Line line = line_of(tube);
    for (const CurvePiece& piece : curve_pieces(line.tube, line.tangents, eye_)) add(line, piece);
  }

  void add(const Arrow& arrow) {
    const auto parts = parts_of(arrow);
    if (!parts) return;
    // The shaft ends just inside of the head: where they are faint, nothing shows through twice.
    const Cone& head = parts->head;
    const Vec3 &base = head.base, &tip = head.tip;
    Tube shaft = parts->shaft;
    // Of arrows along one line the later lies over the earlier, by more than the rounding of depths.
    for (Vec3& p : shaft.points) p += 0.01 * arrows_ * arrow.radius * direction(p, eye_);
    ++arrows_;
    shaft.points.back() = base + 0.04 * (tip - base);
    add(shaft);
    // Sorted by the middle of its bulk: what touches its tip lies over it where that points to the viewer.
    add_solid(Strokes::Kind::cone, base, tip, head.color, head.radius, (tip - base).norm(),
              base + 0.25 * (tip - base));
  }

  /// Sorted by its near side: what starts in it comes out of it.
  void add(const Ball& ball) {
    add_solid(Strokes::Kind::ball, ball.center, ball.center, ball.color, ball.radius, 0.0, ball.center);
  }

  Strokes take() {
    // Stable: of pieces at one distance the later in the list lies over the earlier.
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.distance > b.distance; });
    spare_changes();
    for (const Piece& piece : pieces_) {
      std::vector<std::uint32_t>& indices = is_line(piece.kind) ? made_.lines.indices : made_.solids.indices;
      if (made_.runs.empty() || made_.runs.back().kind != piece.kind)
        made_.runs.push_back({piece.kind, indices.size(), 0});
      for (const std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) indices.push_back(piece.first + k);
      made_.runs.back().count += 6;
    }
    return std::move(made_);
  }

 private:
  struct Line {
    Tube tube;
    std::vector<SegmentTangents> tangents;
    /// Length from the first point to each, and for a closed one to the first again.
    std::vector<float> along;

    const Vec3& point(std::size_t i) const { return tube.points[i % tube.points.size()]; }
  };

  static Line line_of(const Tube& tube) {
    Line line{in_short_pieces(tube), {}, {0.0F}};
    line.tangents = tangents_of(line.tube);
    for (std::size_t i = 0; i < line.tangents.size(); ++i)
      line.along.push_back(line.along.back() +
                           static_cast<float>((line.point(i + 1) - line.point(i)).norm()));
    return line;
  }

  void add(const Line& line, const CurvePiece& piece) {
    const Tube& tube = line.tube;
    const std::array<std::size_t, 2> ends = {piece.first, piece.first + piece.segments};
    const std::array<Vec3, 2> tangents = {line.tangents[ends[0]].start, line.tangents[ends[1] - 1].end};
    const auto first = static_cast<std::uint32_t>(made_.lines.vertices.size());
    const double middle =
        0.5 * static_cast<double>(ends[0] + ends[1]) / static_cast<double>(line.tangents.size());
    const auto color = floats(tube.color, std::lerp(tube.fade_start, 1.0, middle));
    const auto dashes = static_cast<float>(tube.dash > 0.0 ? 1.0 / tube.dash : 0.0);
    for (std::size_t k = 0; k < 2; ++k)
      for (const float side : {-1.0F, 1.0F})
        made_.lines.vertices.push_back(
            {floats(line.point(ends[k])),
             floats(tangents[k]),
             color,
             {side, static_cast<float>(tube.radius), dashes, static_cast<float>(piece.reach[k])},
             tube.closed
                 ? std::array{line.along[ends[k]] + kFarFromEnds, line.along.back() + 2 * kFarFromEnds}
                 : std::array{line.along[ends[k]], line.along.back()},
             floats(piece.bow),
             static_cast<float>(k)});
    // Trails are what a picture is about: no glass is laid over them, and they come after the curve that they
    // lie on, whose pieces are cut elsewhere.
    const bool trail = tube.fade_start < 1.0;
    add_piece(0.5 * (line.point(ends[0]) + line.point(ends[1])), tube.radius + (trail ? kLongestPiece : 0.0),
              trail || in_front(line, piece) ? Strokes::Kind::line : Strokes::Kind::line_in_glass, first);
  }

  /// Another program for a few pieces costs more than it saves: short runs that need no glass join their
  /// neighbours.
  void spare_changes() {
    constexpr std::ptrdiff_t kShort = 8;
    for (auto i = pieces_.begin(); i != pieces_.end();) {
      const Strokes::Kind kind = i->kind;
      const auto end = std::find_if(i, pieces_.end(), [&](const Piece& p) { return p.kind != kind; });
      if (kind == Strokes::Kind::line && end - i < kShort && end != pieces_.end())
        for (auto k = i; k != end; ++k) k->kind = Strokes::Kind::line_in_glass;
      i = end;
    }
  }

  static Tube in_short_pieces(const Tube& tube) {
    if (tube.points.size() != 2) return tube;
    Tube fine = tube;
    const Vec3 a = tube.points[0], b = tube.points[1];
    // Cut at the same lengths from the tail, which arrows share: beside one another they sort alike. At least
    // once, for a piece has one end of its tube at most.
    const double length = (b - a).norm(), piece = std::min(kLongestPiece, 0.5 * length);
    fine.points.clear();
    if (!(length > kShortest && std::isfinite(length))) return fine;  // of rounding there is no direction
    for (int i = 0; i * piece < length - kShortest; ++i)
      fine.points.push_back(a + i * piece * direction(a, b));
    fine.points.push_back(b);
    return fine;
  }

  void add_piece(const Vec3& middle, double radius, Strokes::Kind kind, std::uint32_t first) {
    pieces_.push_back({(middle - eye_).norm() - radius, kind, first});
  }

  bool in_front(const Line& line, const CurvePiece& piece) const {
    for (std::size_t i = piece.first; i < piece.first + piece.segments; ++i)
      if (!in_front(line.point(i), line.tangents[i].start, line.tube.radius) ||
          !in_front(line.point(i + 1), line.tangents[i].end, line.tube.radius))
        return false;
    return true;
  }

  /// Whether nothing of a line of this radius at `p` can lie behind the near side of a glass: the flat side
  /// that the ribbon has towards the eye, made wider by a margin, is outside the ball before the ray enters
  /// it.
  bool in_front(const Vec3& p, const Vec3& tangent, double radius) const {
    constexpr double kMargin = 1.5;
    const Vec3 near = p + radius * direction(p, eye_), side = tangent.cross(direction(p, eye_)).normalized();
    return std::all_of(glasses_.begin(), glasses_.end(), [&](const GlassEllipsoid& e) {
      const Mat3 ball = to_ball(e);
      return std::all_of(kSides.begin(), kSides.end(), [&](double across) {
        const Vec3 edge = near + across * kMargin * radius * side;
        const Vec3 at = ball * (edge - e.center);
        return at.squaredNorm() >= 1.0 && at.dot(ball * (edge - eye_)) < 0.0;
      });
    });
  }
  static constexpr std::array<double, 3> kSides = {-1.0, 0.0, 1.0};

  void add_solid(Strokes::Kind kind, const Vec3& from, const Vec3& to, const Color& color, double radius,
                 double height, const Vec3& sorted_by) {
    const auto first = static_cast<std::uint32_t>(made_.solids.vertices.size());
    for (const float y : {-1.0F, 1.0F})
      for (const float x : {-1.0F, 1.0F})
        made_.solids.vertices.push_back({{x, y},
                                         floats(from),
                                         floats(to),
                                         floats(color),
                                         {static_cast<float>(radius), static_cast<float>(height)}});
    add_piece(sorted_by, kind == Strokes::Kind::ball ? radius : 0.5 * radius, kind, first);
  }

  Vec3 eye_;
  const std::vector<GlassEllipsoid>& glasses_;
  Strokes made_;
  std::vector<Piece> pieces_;
  int arrows_ = 0;
};

}  // namespace

Strokes make_strokes(const DrawList& list, const Vec3& eye) {
  Painter painter(eye, list.ellipsoids);
  for (const Tube& tube : with_faint_far_sides(list, eye)) painter.add(tube);
  for (const Arrow& arrow : list.arrows) painter.add(arrow);
  for (const Ball& ball : list.balls) painter.add(ball);
  return painter.take();
}

}  // namespace polhode
