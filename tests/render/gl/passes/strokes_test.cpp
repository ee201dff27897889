// SPDX-License-Identifier: MIT
#include "render/gl/passes/strokes.h"

#include "render/gl/passes/viewpoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace polhode {
namespace {

const Vec3 kEye(4, 0, 1);

Vec3 vec(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Tube ring(double radius, double height) {
  Tube tube{.points = {}, .closed = true, .radius = 0.01, .color = {}};
  for (int i = 0; i < 100; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 100;
    tube.points.emplace_back(radius * std::cos(a), radius * std::sin(a), height);
  }
  return tube;
}

/// Middles of the pieces of lines in the order in which they are drawn.
std::vector<Vec3> middles(const Strokes& strokes) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < strokes.lines.indices.size(); i += 6) {
    Vec3 sum = Vec3::Zero();
    const std::uint32_t first = strokes.lines.indices[i];
    for (std::uint32_t k = 0; k < 4; ++k) sum += vec(strokes.lines.vertices[first + k].position);
    places.push_back(sum / 4.0);
  }
  return places;
}

TEST(Strokes, AClosedTubeHasAPieceForEachPointAndNoEnds) {
  DrawList list;
  list.tubes.push_back(ring(1.0, 0.0));
  Strokes strokes = make_strokes(list, kEye);
  EXPECT_EQ(strokes.lines.indices.size(), 100U * 6U);
  for (const StrokeVertex& v : strokes.lines.vertices) {
    EXPECT_NE(v.along[0], 0.0F);
    EXPECT_NE(v.along[0], v.along[1]);
  }
  list.tubes[0].closed = false;
  strokes = make_strokes(list, kEye);
  EXPECT_EQ(strokes.lines.indices.size(), 99U * 6U);
  EXPECT_EQ(strokes.lines.vertices.front().along[0], 0.0F);
  EXPECT_EQ(strokes.lines.vertices.back().along[0], strokes.lines.vertices.back().along[1]);
}

TEST(Strokes, AreDrawnFromFarToNear) {
  DrawList list;
  for (double height : {-0.5, 0.0, 0.5}) list.tubes.push_back(ring(1.0, height));
  list.arrows.push_back({.tail = Vec3::Zero(), .tip = Vec3(0.9, 0.4, 0.2), .color = {}});
  const std::vector<Vec3> places = middles(make_strokes(list, kEye));
  constexpr double kRadii = 0.02 - 0.01;  // of arrow and rings: sorted by their near sides
  for (std::size_t i = 1; i < places.size(); ++i)
    EXPECT_LE((places[i] - kEye).norm(),
              (places[i - 1] - kEye).norm() + kRadii + 1e-6);  // vertices are floats
}

// 22 November 2026: polhode and trail took turns along the way, in stripes.
TEST(Strokes, ATrailIsLaidOverTheCurveThatItLiesOn) {
  DrawList list;
  list.tubes.push_back(ring(1.0, 0.0));
  Tube trail = ring(1.0, 0.0);
  trail.closed = false;
  trail.radius *= 1.15;
  trail.fade_start = 0.0;
  for (Vec3& p : trail.points) p = Eigen::AngleAxisd(0.013, Vec3::UnitZ()) * p;  // cut at other places
  list.tubes.push_back(trail);
  const Strokes strokes = make_strokes(list, kEye);
  const std::vector<Vec3> places = middles(strokes);
  const auto is_trail = [&](std::size_t piece) {
    return strokes.lines.vertices[strokes.lines.indices[6 * piece]].shape[1] > 0.0105F;
  };
  constexpr double kPiece = 2.0 * std::numbers::pi / 100.0;
  int pairs = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = i + 1; k < places.size(); ++k) {
      if ((places[i] - places[k]).norm() > 0.5 * kPiece || is_trail(i) == is_trail(k)) continue;
      EXPECT_TRUE(is_trail(k)) << "drawn after its curve at " << places[k].transpose();
      ++pairs;
    }
  EXPECT_GE(pairs, 90);
}

TEST(Strokes, RunsHaveEachIndexOnce) {
  DrawList list;
  list.tubes.push_back(ring(1.0, 0.0));
  list.balls.push_back({.center = Vec3::Zero(), .radius = 0.1, .color = {}});
  list.arrows.push_back({.tail = Vec3::Zero(), .tip = Vec3(0, 0, -2), .color = {}});
  const Strokes strokes = make_strokes(list, kEye);
  std::size_t lines = 0, solids = 0;
  for (const Strokes::Run& run : strokes.runs) {
    std::size_t& next = is_line(run.kind) ? lines : solids;
    EXPECT_EQ(run.first, next);
    next += run.count;
  }
  EXPECT_EQ(lines, strokes.lines.indices.size());
  EXPECT_EQ(solids, strokes.solids.indices.size());
  EXPECT_EQ(solids, 2U * 6U);  // a ball, and a head
}

/// Whether the way from the eye to a point crosses the surface.
bool hidden(const GlassEllipsoid& e, const Vec3& point) {
  const Mat3 ball = to_ball(e);
  const Vec3 from = ball * (kEye - e.center), along = ball * (point - kEye);
  const double a = along.squaredNorm(), b = from.dot(along), c = from.squaredNorm() - 1.0;
  const double discriminant = b * b - a * c;
  return discriminant > 0.0 && -b - std::sqrt(discriminant) < a * (1.0 - 1e-6);
}

TEST(Strokes, NothingBehindTheGlassIsDrawnAsIfInFrontOfIt) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::size_t front = 0;
  for (int trial = 0; trial < 40; ++trial) {
    DrawList list;
    GlassEllipsoid e;
    e.semi_axes = Vec3(0.7 + 0.3 * uniform(random), 0.7 + 0.3 * uniform(random), 0.7 + 0.3 * uniform(random));
    e.rotation = Quat(uniform(random), uniform(random), uniform(random), 1.2).normalized();
    list.ellipsoids.push_back(e);
    // A curve on the surface, and a straight line through it.
    Tube curve = ring(1.0, 0.0);
    const double height = uniform(random);
    for (Vec3& p : curve.points)
      p = e.rotation * Vec3(e.semi_axes.cwiseProduct(Vec3((p + Vec3(0, 0, height)).normalized())));
    list.tubes.push_back(curve);
    list.tubes.push_back({.points = {Vec3(-1.5, 0, 0), Vec3(1.5, 0.2, 0.1)}, .color = {}});
    const Strokes strokes = make_strokes(list, kEye);
    for (const Strokes::Run& run : strokes.runs)
      for (std::size_t i = run.first; i < run.first + run.count && run.kind == Strokes::Kind::line; ++i) {
        const StrokeVertex& v = strokes.lines.vertices[strokes.lines.indices[i]];
        const Vec3 near =
            vec(v.position) + static_cast<double>(v.shape[1]) * direction(vec(v.position), kEye);
        EXPECT_FALSE(hidden(e, near));
        ++front;
      }
  }
  EXPECT_GT(front, 1000U);
}

TEST(Strokes, DegenerateItemsAddNothingThatIsNotFinite) {
  DrawList list;
  list.tubes.push_back({.points = {Vec3(1, 1, 1)}, .color = {}});
  list.tubes.push_back({.points = {Vec3(1, 1, 1), Vec3(1, 1, 1)}, .color = {}});
  // 22 November 2026: what was left of a trail behind a tip at rest was drawn as a dash in any direction.
  list.tubes.push_back({.points = {Vec3(1, 1, 1), Vec3(1, 1, 1 + 1e-15)}, .color = {}});
  list.tubes.push_back({.points = {Vec3(1, 1, 1), Vec3(HUGE_VAL, 1, 1)}, .color = {}});
  list.arrows.push_back({.tail = Vec3::Ones(), .tip = Vec3::Ones(), .color = {}});
  const Strokes strokes = make_strokes(list, kEye);
  EXPECT_TRUE(strokes.lines.vertices.empty());
  EXPECT_TRUE(make_strokes({}, kEye).runs.empty());
}

}  // namespace
}  // namespace polhode
