// SPDX-License-Identifier: MIT
#include "render/gl/passes/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

const Vec3 kEye(4, 0, 1);

TEST(Geometry, AClosedTubeHasASegmentForEachPoint) {
  DrawList list;
  list.tubes.push_back(
      {.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, .closed = true, .color = {}});
  EXPECT_EQ(make_geometry(list, kEye).tubes.indices.size(), 3U * 6U);
  list.tubes[0].closed = false;
  EXPECT_EQ(make_geometry(list, kEye).tubes.indices.size(), 2U * 6U);
}

TEST(Geometry, AnArrowEndsExactlyAtItsTip) {
  DrawList list;
  const Vec3 tip(0.3, -0.4, 1.2);
  list.arrows.push_back({.tail = Vec3::Zero(), .tip = tip, .color = {}});
  const PaneGeometry geometry = make_geometry(list, kEye);
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
  const PaneGeometry geometry = make_geometry(list, kEye);
  for (const TubeVertex& v : geometry.tubes.vertices)
    for (float x : v.tangent) EXPECT_TRUE(std::isfinite(x));
}

}  // namespace
}  // namespace polhode
