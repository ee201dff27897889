// SPDX-License-Identifier: MIT
#include "render/gl/passes/curve_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace polhode {
namespace {

const Vec3 kEye(1.0, 0.5, 4.0);

/// An ellipse in a leaning plane, by its angle.
struct Ellipse {
  Vec3 a, b;
  Vec3 at(double turn) const { return std::cos(turn) * a + std::sin(turn) * b; }
};

Ellipse random_ellipse(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Vec3 a(normal(random), normal(random), normal(random)),
      b(normal(random), normal(random), normal(random));
  return {0.8 * a.normalized(), 0.5 * (b - 0.9 * b.dot(a.normalized()) * a.normalized()).normalized()};
}

Tube tube_of(const Ellipse& ellipse, int points, bool closed) {
  Tube tube{.points = {}, .closed = closed, .radius = 0.01, .color = {}};
  for (int i = 0; i < points; ++i) tube.points.push_back(ellipse.at(2.0 * std::numbers::pi * i / points));
  return tube;
}

std::vector<CurvePiece> pieces_of(const Tube& tube) { return curve_pieces(tube, tangents_of(tube), kEye); }

TEST(CurvePieces, EachSegmentIsInOneAndNeighboursAgreeOnTheirSeam) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial)
    for (const bool closed : {false, true}) {
      const Tube tube = tube_of(random_ellipse(random), 400, closed);
      const std::vector<CurvePiece> pieces = pieces_of(tube);
      std::size_t next = 0;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].first, next);
        next += pieces[i].segments;
        for (const double reach : pieces[i].reach) EXPECT_GE(reach, pieces[i].bow.norm());
        if (i > 0) {
          EXPECT_EQ(pieces[i - 1].reach[1], pieces[i].reach[0]);
        }
      }
      EXPECT_EQ(next, closed ? 400U : 399U);
      if (closed) {
        EXPECT_EQ(pieces.back().reach[1], pieces.front().reach[0]);
      }
      EXPECT_LE(pieces.size(), 250U) << "fewer are the point of it";
    }
}

/// Beside the tangents, which are means of chords, the cubic's bow is that of the curve up to the fourth
/// order.
TEST(CurvePieces, LieOnTheCurve) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 20; ++trial) {
    const Ellipse ellipse = random_ellipse(random);
    const Tube tube = tube_of(ellipse, 300, true);
    for (const CurvePiece& piece : pieces_of(tube)) {
      const Vec3 from = tube.points[piece.first], to = tube.points[(piece.first + piece.segments) % 300];
      for (const double u : {0.25, 0.5, 0.75}) {
        const Vec3 there = (1.0 - u) * from + u * to + 4.0 * u * (1.0 - u) * piece.bow;
        double nearest = 1.0;
        for (int i = 0; i <= 400; ++i) {
          const double turn =
              static_cast<double>(piece.first) + static_cast<double>(piece.segments) * i / 400.0;
          nearest = std::min(nearest, (ellipse.at(2.0 * std::numbers::pi * turn / 300.0) - there).norm());
        }
        const double between_samples = 1e-4;  // half of 2 pi 0.8 / 300 * 10 segments / 400
        EXPECT_LE(nearest, 0.03 * tube.radius + between_samples);
      }
    }
  }
}

TEST(CurvePieces, WhatTurnsSharplyIsStraight) {
  const Tube square{.points = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
                    .closed = true,
                    .radius = 0.01,
                    .color = {}};
  const std::vector<CurvePiece> sides = pieces_of(square);
  ASSERT_EQ(sides.size(), 4U);
  for (const CurvePiece& side : sides) EXPECT_EQ(side.bow, Vec3::Zero());
  for (const CurvePiece& piece : pieces_of(tube_of({Vec3(1, 0, 0), Vec3(0, 1, 0)}, 20, true)))  // by 0.31 rad
    EXPECT_EQ(piece.bow, Vec3::Zero());
}

TEST(CurvePieces, AnOpenTubeHasAPieceForEachEndAndAFadingOneForEachSegment) {
  Tube line{.points = {}, .closed = false, .radius = 0.01, .color = {}};
  for (int i = 0; i < 3; ++i) line.points.emplace_back(0.001 * i, 0.0, 0.0);
  EXPECT_EQ(pieces_of(line).size(), 2U);
  Tube trail = tube_of({Vec3(1, 0, 0), Vec3(0, 1, 0)}, 300, false);
  trail.fade_start = 0.0;
  EXPECT_EQ(pieces_of(trail).size(), 299U);
  EXPECT_TRUE(pieces_of({.points = {Vec3::Zero()}, .color = {}}).empty());
}

TEST(CurvePieces, PointsOnOnePlaceGiveNothingThatIsNotFinite) {
  const Tube still{.points = {5, Vec3(0.1, 0.2, 0.3)}, .closed = true, .radius = 0.01, .color = {}};
  for (const CurvePiece& piece : pieces_of(still)) EXPECT_TRUE(piece.bow.allFinite());
}

}  // namespace
}  // namespace polhode
