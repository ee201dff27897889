// SPDX-License-Identifier: MIT
// Lines, arrows and balls of a draw list as pieces in painter's order, from far to near, so that soft edges
// lie over what is behind them. Pieces are sorted by the near side of their middle, trails as if nearer:
// those that cross or touch may come out of order, and a depth buffer then holds them off. No GL calls;
// internal to render/gl/.
#pragma once

#include "render/gl/passes/geometry.h"

#include <vector>

namespace polhode {

/// As stroke.vert reads it.
struct StrokeVertex {
  std::array<float, 3> position;
  std::array<float, 3> tangent;
  std::array<float, 4> color;  ///< the same in all four of a piece
  /// Side (−1 or 1); radius; pairs of dash and gap in a length of 1; how much wider the bow makes the strip.
  std::array<float, 4> shape;
  std::array<float, 2> along;  ///< from the first end to here, and to the last; far from both if closed
  std::array<float, 3> bow;    ///< from the middle of the piece's chord to that of the curve
  float end;                   ///< of the piece: 0 or 1
};

/// As solid.vert reads it.
struct SolidVertex {
  std::array<float, 2> corner;
  std::array<float, 3> from, to;
  std::array<float, 4> color;
  /// Radius; height of a cone: of two cones, where it is less than from `from` to `to`.
  std::array<float, 2> shape;
};

struct Strokes {
  /// A `line` is nowhere behind the near side of a glass.
  enum class Kind { line, line_in_glass, cone, ball };
  /// Indices that follow one another, of one kind.
  struct Run {
    Kind kind;
    std::size_t first, count;
  };
  Geometry<StrokeVertex> lines;
  Geometry<SolidVertex> solids;
  std::vector<Run> runs;  ///< in the order to draw
};

inline bool is_line(Strokes::Kind kind) {
  return kind == Strokes::Kind::line || kind == Strokes::Kind::line_in_glass;
}

/// Meshes are left out. O(n log n) in the pieces; those of Poinsot's scene, some 3800, take about half a
/// millisecond (a hundredth of a 1080p frame).
Strokes make_strokes(const DrawList& list, const Vec3& eye);

}  // namespace polhode
