// SPDX-License-Identifier: MIT
// A tube cut into pieces that are drawn as parabolas: few and long, where the pieces of a polyline would have
// to be many and short. No GL calls; internal to render/gl.
#pragma once

#include "render/gl/geometry.h"

#include <array>

namespace polhode {

/// From one point of the tube to a later one.
struct CurvePiece {
  std::size_t first;
  std::size_t segments;  ///< of the tube, at least 1
  Vec3 bow;              ///< from the middle of the chord to that of the curve
  std::array<double, 2>
      reach;  ///< at both ends: no less than the bow, and what the piece that meets it there has
};

/// Each segment is in one piece. Pieces turn by 0.1 rad at most in space and as the eye sees them; a segment
/// that turns more is straight. Those of more than one segment are at most 0.08 long (scene units) and half
/// of an open tube, pass the points between their ends by 2 % of the tube's radius at most, and bow towards
/// the eye or away from it by 10 % of it at most, for their depth is that of the chord. Where the tube fades,
/// a piece is a segment. O(n k) for n segments in pieces of k.
/// @param tangents tangents_of(tube)
std::vector<CurvePiece> curve_pieces(const Tube& tube, const std::vector<SegmentTangents>& tangents,
                                     const Vec3& eye);

}  // namespace polhode
