// SPDX-License-Identifier: MIT
#include "render/figure/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

constexpr double kTolerance = 1e-9;  // px; a picture has 1e3 px and the matrices a few roundings of 1e-16

TEST(Camera, TargetIsInTheMiddle) {
  const Camera camera =
      orbit({.azimuth_rad = 1.0, .elevation_rad = -0.4, .distance = 5.0}, Vec3(0.1, 0.2, 0.3), 2.0);
  const auto p = project(camera, Vec3(0.1, 0.2, 0.3), 1920, 1080);
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->x(), 960.0, kTolerance);
  EXPECT_NEAR(p->y(), 540.0, kTolerance);
}

TEST(Camera, AzimuthZeroLooksFromXAndSeesYToTheRightAndZUp) {
  const Camera camera = orbit({.azimuth_rad = 0.0, .elevation_rad = 0.0, .distance = 4.0}, Vec3::Zero(), 1.0);
  EXPECT_LT((camera.eye - Vec3(4, 0, 0)).norm(), 1e-15);
  const double px_per_unit = 0.5 * 1000 / std::tan(0.5 * camera.fov_y_rad) / 4.0;
  const auto y = project(camera, Vec3(0, 0.5, 0), 1000, 1000),
             z = project(camera, Vec3(0, 0, 0.5), 1000, 1000);
  ASSERT_TRUE(y && z);
  EXPECT_NEAR(y->x(), 500 + 0.5 * px_per_unit, kTolerance);
  EXPECT_NEAR(y->y(), 500, kTolerance);
  EXPECT_NEAR(z->y(), 500 - 0.5 * px_per_unit, kTolerance);
}

TEST(Camera, WhatLiesBehindIsNotProjected) {
  const Camera camera = orbit({.azimuth_rad = 0.0, .elevation_rad = 0.0, .distance = 4.0}, Vec3::Zero(), 1.0);
  EXPECT_FALSE(project(camera, Vec3(5, 0, 0), 100, 100));
}

TEST(Camera, StraightDownIsStillDefined) {
  const Camera camera =
      orbit({.azimuth_rad = 0.3, .elevation_rad = 10.0, .distance = 4.0}, Vec3::Zero(), 1.0);
  EXPECT_TRUE(camera.view().allFinite());
}

TEST(Camera, ZoomNarrowsTheField) {
  const Camera wide = orbit({.zoom = 1.0}, Vec3::Zero(), 1.0),
               narrow = orbit({.zoom = 2.0}, Vec3::Zero(), 1.0);
  EXPECT_NEAR(std::tan(0.5 * wide.fov_y_rad), 2.0 * std::tan(0.5 * narrow.fov_y_rad), 1e-15);
}

}  // namespace
}  // namespace polhode
