// SPDX-License-Identifier: MIT
#include "app/session/camera_moves.h"

#include "base/vectors.h"
#include "render/figure/camera.h"
#include "render/figure/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace polhode {
namespace {

TEST(Orbit, GoesWithTheHand) {
  const CameraSpec start;
  const auto x_of = [&](const CameraSpec& spec) {  // of what is in front
    const Camera from = orbit(start, Vec3::Zero(), 1.0);
    return *project(orbit(spec, Vec3::Zero(), 1.0), 0.5 * from.eye.normalized(), 800, 600);
  };
  EXPECT_GT(x_of(orbited(start, 10, 0, 600)).x(), x_of(start).x());
  EXPECT_GT(x_of(orbited(start, 0, 10, 600)).y(), x_of(start).y());
  EXPECT_EQ(orbited(start, 0, 0, 600), start);
  const CameraSpec half = orbited(start, 600, 0, 600);
  EXPECT_NEAR(std::abs(std::remainder(half.azimuth_rad - start.azimuth_rad, 2 * std::numbers::pi)),
              std::numbers::pi, 1e-12);
  for (const double dy : {-1e6, 1e6})
    EXPECT_NEAR(std::abs(orbited(start, 0, dy, 600).elevation_rad), 89 * std::numbers::pi / 180, 1e-12);
  EXPECT_EQ(orbited(start, 5, 5, 0), start);
}

TEST(Orbit, KeepsTheScaleThatThePictureHadBefore) {
  const CameraSpec start{.azimuth_rad = 0.3, .elevation_rad = 0.2};
  const CameraSpec turned = orbited(orbited(start, 50, 10, 600), -20, 30, 600);
  ASSERT_TRUE(turned.fitted);
  EXPECT_EQ(*turned.fitted, (CameraFit{start.azimuth_rad, start.elevation_rad}));
  EXPECT_EQ(zoomed(turned, 2).fitted, turned.fitted);
}

TEST(Zoom, IsATenthForANotchAndHasEnds) {
  const CameraSpec start;
  EXPECT_NEAR(zoomed(start, 1).zoom, 1.1, 1e-12);
  EXPECT_NEAR(zoomed(zoomed(start, 3), -3).zoom, 1.0, 1e-12);
  EXPECT_EQ(zoomed(start, 1000).zoom, 8.0);
  EXPECT_EQ(zoomed(start, -1000).zoom, 0.25);
}

TEST(CameraPresets, LookFromWhereTheirNamesSay) {
  const auto direction = [](const std::string& name) {
    for (const CameraPreset& preset : camera_presets())
      if (preset.name == name) return Vec3(orbit(preset.camera, Vec3::Zero(), 1.0).eye.normalized());
    throw std::runtime_error(name);
  };
  constexpr double kNear = 0.9997;  // cosine of 1.4°: the camera stays clear of the poles
  EXPECT_GT(direction("front").x(), kNear);
  EXPECT_GT(direction("side").y(), kNear);
  EXPECT_GT(direction("top").z(), kNear);
  EXPECT_LT(direction("below").z(), -kNear);
  EXPECT_EQ(camera_presets().front().camera, CameraSpec{}) << "three-quarter, as scenes begin";
}

}  // namespace
}  // namespace polhode
