// SPDX-License-Identifier: MIT
#include "render/gl/passes/viewpoint.h"

#include "render/figure/orbit_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace polhode {
namespace {

using Random = std::mt19937;

double between(double low, double high, Random& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

GlassEllipsoid random_ellipsoid(Random& random) {
  const auto u = [&] { return between(-1.0, 1.0, random); };
  GlassEllipsoid e;
  e.center = 0.3 * Vec3(u(), u(), u());
  e.rotation = Quat(u(), u(), u(), u() + 1.1).normalized();
  e.semi_axes = Vec3(0.55 + 0.4 * u(), 0.55 + 0.4 * u(), 0.55 + 0.4 * u());
  return e;
}

Camera random_camera(Random& random) {
  return orbit({.azimuth_rad = between(-3.0, 3.0, random), .elevation_rad = between(-1.0, 1.0, random)},
               Vec3::Zero(), 1);
}

/// Height of the plane that touches the ellipsoid from below.
double tangent_floor(const GlassEllipsoid& e) {
  const Vec3 down = e.rotation.conjugate() * Vec3(0, 0, -1);
  return e.center.z() - e.semi_axes.cwiseProduct(down).norm();
}

bool holds(const ClipBox& box, double x, double y) {
  return x >= box.x0 && x <= box.x1 && y >= box.y0 && y <= box.y1;
}

/// Places in clip space of points all over the surface.
std::vector<Eigen::Vector2d> projected_surface(const GlassEllipsoid& e,
                                               const Eigen::Matrix4d& view_projection) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 100; ++j) {
      const double a = 2 * std::numbers::pi * i / 200, b = std::numbers::pi * j / 100;
      const Vec3 n(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
      const Vec3 point = e.center + e.rotation * Vec3(e.semi_axes.cwiseProduct(n));
      const Eigen::Vector4d clip = view_projection * point.homogeneous();
      places.emplace_back(clip.x() / clip.w(), clip.y() / clip.w());
    }
  return places;
}

TEST(OutlineBox, HoldsTheProjectedSurfaceAndNoMuchMore) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const GlassEllipsoid e = random_ellipsoid(random);
    const Camera camera = random_camera(random);
    const Eigen::Matrix4d m = camera.projection(1.5) * camera.view();
    const ClipBox box = outline_box(e, m);
    double x0 = 1, x1 = -1, y0 = 1, y1 = -1;
    for (const Eigen::Vector2d& at : projected_surface(e, m)) {
      x0 = std::min(x0, at.x()), x1 = std::max(x1, at.x());
      y0 = std::min(y0, at.y()), y1 = std::max(y1, at.y());
    }
    constexpr double kMargin = 0.01;  // the box's own margin of 0.004, and the coarseness of the sampling
    EXPECT_LE(box.x0, x0);
    EXPECT_LE(box.y0, y0);
    EXPECT_GE(box.x1, x1);
    EXPECT_GE(box.y1, y1);
    EXPECT_NEAR(box.x0, x0, kMargin);
    EXPECT_NEAR(box.y1, y1, kMargin);
  }
}

TEST(OutlineEllipse, HoldsTheProjectedSurfaceAndHardlyMoreThanItNeeds) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 50; ++trial) {
    const GlassEllipsoid e = random_ellipsoid(random);
    const Camera camera = random_camera(random);
    const Eigen::Matrix4d m = camera.projection(1.5) * camera.view();
    const OutlineEllipse outline = outline_ellipse(e, m);
    double furthest = 0.0;  // 1: on the ellipse
    for (const Eigen::Vector2d& at : projected_surface(e, m))
      furthest = std::max(furthest, (outline.axes.inverse() * (at - outline.center)).norm());
    EXPECT_LE(furthest, 1.0);
    EXPECT_GE(furthest, 0.9) << "the soft edge of 0.004 beside half-axes of 0.04 and more";
  }
}

TEST(OutlineEllipse, IsNeverASliver) {
  GlassEllipsoid needle;
  needle.semi_axes = Vec3(1.0, 1e-3, 1e-3);
  const Camera camera = orbit({}, Vec3::Zero(), 1);
  const OutlineEllipse outline = outline_ellipse(needle, camera.projection(1.5) * camera.view());
  const double across = outline.axes.col(0).norm(), along = outline.axes.col(1).norm();
  EXPECT_GE(std::min(across, along), 0.29 * std::max(across, along));
}

// 22 November 2026: of an ellipse of many screens the polygon's triangles had no digits left, and the glass
// kinks.
TEST(OutlineEllipse, IsNeverManyScreensLarge) {
  GlassEllipsoid e;
  e.semi_axes = Vec3(1.0, 0.5, 0.3);
  for (double distance = 0.3; distance < 6.0; distance *= 1.01) {
    const Camera camera =
        orbit({.azimuth_rad = 0.6, .elevation_rad = 0.35, .distance = distance}, Vec3::Zero(), 1);
    const OutlineEllipse outline = outline_ellipse(e, camera.projection(1.5) * camera.view());
    EXPECT_LE(outline.center.norm() + outline.axes.colwise().norm().maxCoeff(), 3.0) << distance;
  }
}

TEST(OutlineEllipse, OfAnEyeInsideHoldsTheScreen) {
  GlassEllipsoid around;
  around.semi_axes = Vec3(50.0, 50.0, 50.0);
  const Camera camera = orbit({}, Vec3::Zero(), 1);
  const OutlineEllipse outline = outline_ellipse(around, camera.projection(1.5) * camera.view());
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      EXPECT_LE((outline.axes.inverse() * (Eigen::Vector2d(x, y) - outline.center)).norm(), 1.0 + 1e-12);
}

TEST(FloorForm, IsTheDistanceInTheSpaceOfTheBall) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 50; ++trial) {
    const GlassEllipsoid e = random_ellipsoid(random);
    const Viewpoint at = viewpoint_of(random_camera(random), 1.5, 720.0);
    const double floor_z = tangent_floor(e), unit = between(0.1, 2.0, random);
    const FloorForm form = floor_form(at, floor_z, e, unit);
    const Mat3 ball = to_ball(e);
    for (int i = 0; i < 20; ++i) {
      const double x = between(-5.0, 5.0, random), y = between(-5.0, 5.0, random);
      const Vec3 p = ball * (Vec3(unit * x, unit * y, floor_z) - e.center);
      const double u = form.u[0] * x + form.u[1] * y + form.u[2], v = form.v[0] * y + form.v[1];
      const double kRounding = 1e-13 * (1.0 + p.squaredNorm());
      EXPECT_NEAR(u * u + v * v + form.v[2], p.squaredNorm(), kRounding);
      EXPECT_NEAR(form.to_light[0] * x + form.to_light[1] * y + form.to_light[2],
                  -p.dot((ball * at.light).normalized()), kRounding);
    }
  }
}

TEST(ClipBoxes, WhatSurroundsAHoleCoversTheRestOnce) {
  Random random(3);
  const auto u = [&] { return between(-1.0, 1.0, random); };
  for (int trial = 0; trial < 200; ++trial) {
    const auto [x0, x1] = std::minmax({u(), u()});
    const auto [y0, y1] = std::minmax({u(), u()});
    const ClipBox hole = trial % 10 == 0 ? ClipBox{0, 0, 0, 0} : ClipBox{x0, y0, x1, y1};
    const ClipBox whole{};
    for (int i = 0; i < 20; ++i) {
      const double x = u(), y = u();
      int covered = !hole.empty() && holds(hole, x, y) ? 1 : 0;
      for (const ClipBox& box : around(hole, whole)) covered += holds(box, x, y) ? 1 : 0;
      EXPECT_EQ(covered, 1) << x << ", " << y;
    }
  }
}

TEST(ClipBoxes, NoneIsMadeOfNothing) {
  EXPECT_EQ(around({-1, -1, 1, 0.5}, {}).size(), 1U);  // the part above
  EXPECT_EQ(around({}, {}).size(), 0U);
  EXPECT_TRUE(common({-1, -1, 0, 0}, {0.5, 0.5, 1, 1}).empty());
}

/// As floor.frag: by how much the ellipsoid darkens a place of the floor, 0…1.
double shade_at(const GlassEllipsoid& e, const Vec3& light, const Vec3& place) {
  const Mat3 ball = to_ball(e);
  const Vec3 p = ball * (place - e.center), l = (ball * light).normalized();
  const double to_light = -p.dot(l), blur = 0.16 + 0.16 * std::max(to_light, 0.0);
  const double miss = std::sqrt(std::max(0.0, p.squaredNorm() - to_light * to_light));
  const double x = std::clamp(0.5 + 0.5 * (1.0 - miss) / blur, 0.0, 1.0);
  return std::min(0.45, 0.30 * x * x * (3.0 - 2.0 * x) + 0.22 / std::pow(p.squaredNorm(), 2));
}

TEST(FloorShading, HoldsAllThatIsSeenAndIsNotTheWholeScreen) {
  Random random(5);
  double area = 0.0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    const GlassEllipsoid e = random_ellipsoid(random);
    const double floor_z = tangent_floor(e);
    Camera camera = random_camera(random);
    camera.eye.z() = std::abs(camera.eye.z());  // from above
    const Viewpoint at = viewpoint_of(camera, 1.5, 600);
    const ClipBox box = floor_shading(at, floor_z, e).shade;
    area += std::max(0.0, box.x1 - box.x0) * std::max(0.0, box.y1 - box.y0) / 4.0 / kTrials;
    for (int i = 0; i < 400; ++i) {
      const Vec3 place(between(-6, 6, random), between(-6, 6, random), floor_z);
      const Eigen::Vector4d clip = at.view_projection * place.homogeneous();
      const double x = clip.x() / clip.w(), y = clip.y() / clip.w();
      if (clip.w() <= 0.0 || !holds({}, x, y) || holds(box, x, y)) continue;
      EXPECT_LT(shade_at(e, at.light, place), 0.5 / 255.0 * 1.01);  // rounding of the limit on contact
    }
  }
  EXPECT_LT(area, 0.75);
}

TEST(FloorBox, EndsWhereTheFloorHasFaded) {
  Random random(9);
  for (int trial = 0; trial < 60; ++trial) {
    const Viewpoint at = viewpoint_of(random_camera(random), 1.5, 600);
    const double floor_z = -1.0;
    const ClipBox box = floor_box(at, floor_z);
    for (int i = 0; i < 200; ++i) {
      const double turn = between(0.0, 2.0 * std::numbers::pi, random),
                   reach = between(0.0, kFloorEnds, random);
      const Vec3 place(reach * std::cos(turn), reach * std::sin(turn), floor_z);
      const Eigen::Vector4d clip = at.view_projection * place.homogeneous();
      const double x = clip.x() / clip.w(), y = clip.y() / clip.w();
      constexpr double kRounding = 1e-9;
      if (clip.w() <= 0.0 || !holds({}, x, y)) continue;
      EXPECT_TRUE(holds({box.x0, box.y0 - kRounding, box.x1, box.y1 + kRounding}, x, y)) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace polhode
