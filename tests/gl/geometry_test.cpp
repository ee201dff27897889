// SPDX-License-Identifier: MIT
#include "render/gl/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace polhode {
namespace {

TEST(Geometry, AClosedTubeHasASegmentForEachPoint) {
  DrawList list;
  list.tubes.push_back(
      {.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, .closed = true, .color = {}});
  EXPECT_EQ(make_geometry(list).tubes.indices.size(), 3U * 6U);
  list.tubes[0].closed = false;
  EXPECT_EQ(make_geometry(list).tubes.indices.size(), 2U * 6U);
}

TEST(Geometry, AnArrowEndsExactlyAtItsTip) {
  DrawList list;
  const Vec3 tip(0.3, -0.4, 1.2);
  list.arrows.push_back({.tail = Vec3::Zero(), .tip = tip, .color = {}});
  const PaneGeometry geometry = make_geometry(list);
  double furthest = 0.0;
  for (const MeshVertex& v : geometry.solid.vertices) {
    const Vec3 p(static_cast<double>(v.position[0]), static_cast<double>(v.position[1]),
                 static_cast<double>(v.position[2]));
    furthest = std::max(furthest, p.dot(tip.normalized()));
  }
  EXPECT_NEAR(furthest, tip.norm(), 1e-6);  // vertices are floats
}

TEST(Geometry, DegenerateItemsAddNothingThatIsNotFinite) {
  DrawList list;
  list.tubes.push_back({.points = {Vec3(1, 1, 1)}, .color = {}});
  list.tubes.push_back({.points = {Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(2, 1, 1)}, .color = {}});
  list.arrows.push_back({.tail = Vec3::Ones(), .tip = Vec3::Ones(), .color = {}});
  const PaneGeometry geometry = make_geometry(list);
  for (const TubeVertex& v : geometry.tubes.vertices)
    for (float x : v.tangent) EXPECT_TRUE(std::isfinite(x));
}

TEST(OutlineBounds, HoldTheProjectedSurfaceAndNoMuchMore) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    GlassEllipsoid e;
    e.center = 0.3 * Vec3(uniform(random), uniform(random), uniform(random));
    e.rotation = Quat(uniform(random), uniform(random), uniform(random), uniform(random) + 1.1).normalized();
    e.semi_axes =
        Vec3(0.55 + 0.4 * uniform(random), 0.55 + 0.4 * uniform(random), 0.55 + 0.4 * uniform(random));
    const Camera camera =
        orbit({.azimuth_rad = 3 * uniform(random), .elevation_rad = uniform(random)}, Vec3::Zero(), 1);
    const Eigen::Matrix4d m = camera.projection(1.5) * camera.view();
    const auto bounds = outline_bounds(e, m);
    double x0 = 1, x1 = -1, y0 = 1, y1 = -1;
    for (int i = 0; i < 200; ++i)
      for (int j = 0; j < 100; ++j) {
        const double a = 2 * std::numbers::pi * i / 200, b = std::numbers::pi * j / 100;
        const Vec3 n(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
        const Eigen::Vector4d c =
            m * (e.center + e.rotation * Vec3(e.semi_axes.cwiseProduct(n))).homogeneous();
        x0 = std::min(x0, c.x() / c.w()), x1 = std::max(x1, c.x() / c.w());
        y0 = std::min(y0, c.y() / c.w()), y1 = std::max(y1, c.y() / c.w());
      }
    constexpr double kMargin = 0.01;  // the bounds' own margin of 0.004, and the coarseness of the sampling
    EXPECT_LE(bounds[0], x0);
    EXPECT_LE(bounds[1], y0);
    EXPECT_GE(bounds[2], x1);
    EXPECT_GE(bounds[3], y1);
    EXPECT_NEAR(bounds[0], x0, kMargin);
    EXPECT_NEAR(bounds[3], y1, kMargin);
  }
}

}  // namespace
}  // namespace polhode
