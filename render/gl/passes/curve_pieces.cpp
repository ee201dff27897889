// SPDX-License-Identifier: MIT
#include "render/gl/passes/curve_pieces.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kDeviation = 0.02, kDeepest = 0.1;  // in radii
constexpr double kLongest = 0.03;                    // scene units; longer ones beside one another sort badly
constexpr double kLeastCosine = 0.995;               // of 0.1 rad

class Cutter {
 public:
  Cutter(const Tube& tube, const std::vector<SegmentTangents>& tangents, const Vec3& eye)
      : tube_(tube), tangents_(tangents), eye_(eye) {}

  CurvePiece piece_from(std::size_t first) const {
    CurvePiece piece{first, 1, turns_little(first, 1) ? bow(first, 1) : Vec3(Vec3::Zero()), {}};
    if (tube_.fade_start < 1.0) return piece;
    while (first + piece.segments < tangents_.size()) {
      const CurvePiece longer{first, piece.segments + 1, bow(first, piece.segments + 1), {}};
      if (!possible(longer)) break;
      piece = longer;
    }
    return piece;
  }

 private:
  const Vec3& point(std::size_t i) const { return tube_.points[i % tube_.points.size()]; }

  /// Of the cubic with these ends and tangents, whose speed is the chord's length (Hermite).
  Vec3 bow(std::size_t first, std::size_t segments) const {
    const double chord = (point(first + segments) - point(first)).norm();
    return chord / 8.0 * (tangents_[first].start - tangents_[first + segments - 1].end);
  }

  /// Of the middle.
  Vec3 to_eye(std::size_t first, std::size_t segments) const {
    return direction(0.5 * (point(first) + point(first + segments)), eye_);
  }

  /// In space and on the screen, where what points to the eye turns back within a pixel.
  bool turns_little(std::size_t first, std::size_t segments) const {
    const Vec3 &start = tangents_[first].start, &end = tangents_[first + segments - 1].end;
    const Vec3 sight = to_eye(first, segments);
    return start.dot(end) > kLeastCosine &&
           start.cross(sight).normalized().dot(end.cross(sight).normalized()) > kLeastCosine;
  }

  bool possible(const CurvePiece& piece) const {
    const std::size_t most = tube_.closed ? tangents_.size() : tangents_.size() / 2;
    if (piece.segments > most) return false;
    if ((point(piece.first + piece.segments) - point(piece.first)).norm() > kLongest) return false;
    if (std::abs(piece.bow.dot(to_eye(piece.first, piece.segments))) > kDeepest * tube_.radius) return false;
    if (!turns_little(piece.first, piece.segments)) return false;
    for (std::size_t i = 1; i < piece.segments; ++i)
      if (!passes(piece, point(piece.first + i))) return false;
    return true;
  }

  bool passes(const CurvePiece& piece, const Vec3& p) const {
    const Vec3 from = point(piece.first), chord = point(piece.first + piece.segments) - from;
    const double u = (p - from).dot(chord) / chord.squaredNorm();
    const Vec3 there = from + u * chord + 4.0 * u * (1.0 - u) * piece.bow;
    return (p - there).norm() <= kDeviation * tube_.radius;  // false for a chord without length
  }

  const Tube& tube_;
  const std::vector<SegmentTangents>& tangents_;
  const Vec3& eye_;
};

/// Or the edges of two ribbons that meet would not be the same, and a pixel of their seam might be in
/// neither.
void agree_on_reach(std::vector<CurvePiece>& pieces, bool closed) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool meets = closed || i + 1 < pieces.size();
    CurvePiece &piece = pieces[i], &next = pieces[meets ? (i + 1) % pieces.size() : i];
    piece.reach[1] = std::max(piece.bow.norm(), next.bow.norm());
    if (meets) next.reach[0] = piece.reach[1];
  }
  if (!closed && !pieces.empty()) pieces.front().reach[0] = pieces.front().bow.norm();
}

}  // namespace

std::vector<CurvePiece> curve_pieces(const Tube& tube, const std::vector<SegmentTangents>& tangents,
                                     const Vec3& eye) {
  const Cutter cutter(tube, tangents, eye);
  std::vector<CurvePiece> pieces;
  for (std::size_t at = 0; at < tangents.size(); at += pieces.back().segments)
    pieces.push_back(cutter.piece_from(at));
  agree_on_reach(pieces, tube.closed);
  return pieces;
}

}  // namespace polhode
