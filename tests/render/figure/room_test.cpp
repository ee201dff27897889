// SPDX-License-Identifier: MIT
// Floor and walls, as data: at rest in S, round all that is drawn, and of no weight for the camera.
#include "render/figure/make_figure.h"
#include "render/scene/model/scene_needs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using O = Overlay;

constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr double kAspect = 16.0 / 9.0;

Scene book(OverlaySet show, View view = View::space) {
  Scene scene;
  scene.body = find_body("book").value();
  scene.w0_B = Vec3(0.9, 2.0, 0.5);
  scene.views = {view};
  scene.show = show;
  scene.show.insert(O::room);
  return scene;
}

Pane pane_of(const Scene& scene, double t_s) {
  return make_figure(make_model(scene), t_s, kAspect).panes.at(0);
}
std::vector<Wall> walls_of(const Scene& scene, double t_s) { return pane_of(scene, t_s).list.walls; }
Vec3 inwards(const Wall& wall) { return wall.right.cross(wall.up).normalized(); }

constexpr std::size_t kOpenings = 4;  // a door, one window, and two

TEST(Room, HasSixWallsThatFaceTheBodyAndAFloorMoreToned) {
  const std::vector<Wall> walls = walls_of(book({O::shape}), 0.3);
  ASSERT_EQ(walls.size(), 6U + kOpenings);
  for (const Wall& wall : walls) {
    EXPECT_LT(inwards(wall).dot(wall.center), 0.0) << "the body's centre is on the side that is seen";
    EXPECT_NEAR(wall.right.dot(wall.up), 0.0, kRounding);
    if (inwards(wall).z() > 0.9) continue;
    const auto floor =
        std::find_if(walls.begin(), walls.end(), [](const Wall& w) { return inwards(w).z() > 0.9; });
    EXPECT_GT(floor->ground.a, 1.3F * wall.ground.a);
  }
}

TEST(Room, RestsInSpaceAndTurnsTheOtherWayInTheBody) {
  const Scene in_S = book({O::shape}), in_B = book({O::shape}, View::body);
  const SceneModel model = make_model(in_B);
  const std::vector<Wall> first = walls_of(in_S, 0.0);
  for (const double t_s : {0.4, 1.9}) {
    const std::vector<Wall> later = walls_of(in_S, t_s), turned = walls_of(in_B, t_s);
    const Quat q_BS = model.motion->at(t_s).q_SB.conjugate();
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(later[i].center, first[i].center);
      EXPECT_LT((turned[i].center - q_BS * first[i].center).norm(), kRounding);
      EXPECT_LT((turned[i].up - q_BS * first[i].up).norm(), kRounding);
    }
  }
}

// Turned by a right angle about z, it would else look as it did.
TEST(Room, LooksOtherThanTurnedByARightAngle) {
  const std::vector<Wall> walls = walls_of(book({O::shape}), 0.0);
  for (int quarter = 1; quarter < 4; ++quarter) {
    const Quat turn(Eigen::AngleAxisd(0.5 * std::numbers::pi * quarter, Vec3::UnitZ()));
    const auto stays = [&](const Wall& wall) {
      return std::any_of(walls.begin(), walls.end(),
                         [&](const Wall& w) { return (w.center - turn * wall.center).norm() < kRounding; });
    };
    EXPECT_FALSE(std::all_of(walls.begin(), walls.end(), stays)) << quarter;
  }
}

TEST(Room, HoldsTheTriadsAndTheArrowOfL) {
  const Scene scene = book({O::shape, O::axes_space, O::axes_body, O::L});
  const Pane pane = pane_of(scene, 0.7);
  for (const Wall& wall : pane.list.walls)
    for (const Arrow& arrow : pane.list.arrows) EXPECT_GT(inwards(wall).dot(arrow.tip - wall.center), 0.0);
}

TEST(Room, StandsOnTheInvariablePlane) {
  const Pane pane = pane_of(book({O::energy_ellipsoid, O::plane}), 0.3);
  ASSERT_EQ(pane.list.floors.size(), 1U);
  ASSERT_EQ(pane.list.walls.size(), 5U + kOpenings) << "the plane is its floor";
  int standing = 0;
  for (const Wall& wall : pane.list.walls) {
    const double lowest = wall.center.z() - std::abs(wall.right.z()) - std::abs(wall.up.z());
    EXPECT_GE(lowest, pane.list.floors[0].z - kRounding);
    standing += lowest < pane.list.floors[0].z + kRounding ? 1 : 0;
  }
  EXPECT_EQ(standing, 5) << "four walls and a door";
}

TEST(Room, HoldsThePathOfABodyThatFlies) {
  Scene scene = book({O::shape});
  scene.v0_S = Vec3(0.3, 1.3, 2.2);
  scene.F_S = Vec3(0.0, 0.0, -7.85);
  scene.duration_s = 0.4;
  const std::vector<Wall> first = walls_of(scene, 0.0);
  for (const double t_s : {0.0, 0.2, 0.4}) {
    const std::vector<Wall> walls = walls_of(scene, t_s);
    ASSERT_EQ(walls.size(), 6U + kOpenings);
    for (const Wall& wall : walls)  // the body is at the origin of what is drawn
      EXPECT_GT(-inwards(wall).dot(wall.center), 1.0) << t_s;
  }
  EXPECT_GT((walls_of(scene, 0.2)[0].center - first[0].center).norm(), 0.1) << "it passes the walls";
}

TEST(Room, LeavesTheCameraAndAllElseAsTheyAre) {
  for (const View view : {View::space, View::body})
    for (const bool holds_still : {false, true}) {
      Scene with = book({O::shape, O::L, O::labels}, view);
      with.camera.holds_still = holds_still;
      Scene without = with;
      without.show.erase(O::room);
      const Pane a = pane_of(with, 0.6), b = pane_of(without, 0.6);
      EXPECT_EQ(a.camera.eye, b.camera.eye);
      EXPECT_EQ(a.camera.target, b.camera.target);
      EXPECT_EQ(a.camera.fov_y_rad, b.camera.fov_y_rad);
      EXPECT_TRUE(b.list.walls.empty());
      EXPECT_EQ(a.list.arrows.size(), b.list.arrows.size());
      EXPECT_EQ(a.list.tubes.size(), b.list.tubes.size());
      EXPECT_EQ(a.list.labels.size(), b.list.labels.size());
    }
}

TEST(Room, NeedsTheAttitudeInTheBodyAlone) {
  EXPECT_TRUE(requirements(book({}, View::body)).attitude);
  EXPECT_FALSE(requirements(book({})).attitude);
}

}  // namespace
}  // namespace polhode
