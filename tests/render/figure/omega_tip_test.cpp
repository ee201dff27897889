// SPDX-License-Identifier: MIT
#include "render/figure/omega_tip.h"

#include "render/figure/builders/builders.h"
#include "render/figure/make_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using O = Overlay;

Scene scene_with(OverlaySet show, std::vector<View> views = {View::space, View::body}) {
  Scene scene;
  scene.w0_B = Vec3(0.9, 0.4, 1.0);
  scene.show = show;
  scene.views = std::move(views);
  return scene;
}

std::vector<Scene> scenes() {
  std::vector<Scene> scenes = {scene_with({O::omega, O::energy_ellipsoid, O::plane, O::L, O::polhode}),
                               scene_with({O::omega, O::shape, O::axes_space, O::labels}),
                               scene_with({O::omega, O::momentum_ellipsoid, O::L}, {View::body}),
                               scene_with({O::omega, O::shape, O::L, O::v, O::p}, {View::space})};
  scenes[1].attitude = Quat(0.9, 0.3, -0.2, 0.1).normalized();
  scenes[3].v0_S = Vec3(1, 0, 0.5);
  scenes.push_back(scenes[0]);  // only its motion knows where it can come
  scenes.back().motion = {.method = Method::explicit_euler, .step_s = 0.05};
  return scenes;
}

/// Whether an arrow of the pane ends there.
bool has_tip(const Pane& pane, const Vec3& tip_V) {
  return std::any_of(pane.list.arrows.begin(), pane.list.arrows.end(),
                     [&](const Arrow& arrow) { return (arrow.tip - tip_V).norm() < 1e-12; });
}

void expect_same(const Camera& a, const Camera& b) {
  EXPECT_LT((a.eye - b.eye).norm(), 1e-12);
  EXPECT_LT((a.target - b.target).norm(), 1e-12);
  EXPECT_EQ(a.fov_y_rad, b.fov_y_rad);
}

TEST(OmegaTip, IsThatOfTheArrowInTheFigure) {
  constexpr double kAspect = 1.3;
  for (const Scene& scene : scenes()) {
    const SceneModel model = make_model(scene);
    for (const double t_s : {0.0, 1.7}) {
      const Figure figure = make_figure(model, t_s, kAspect);
      for (std::size_t pane = 0; pane < scene.views.size(); ++pane) {
        const auto drawn = drawn_omega(model, t_s, pane, kAspect);
        ASSERT_TRUE(drawn);
        EXPECT_TRUE(has_tip(figure.panes[pane], drawn->tip_V));
        expect_same(drawn->camera, figure.panes[pane].camera);
      }
    }
  }
}

TEST(OmegaTip, OfATrialIsThatOfTheModel) {
  constexpr double kAspect = 0.8;
  const Vec3 other(-0.3, 1.1, 0.6);
  const AttitudeSpec turned = Quat(0.2, 0.7, -0.4, 0.5).normalized();
  for (const Scene& scene : scenes())
    for (const auto& attitude : {std::optional<AttitudeSpec>(), std::optional<AttitudeSpec>(turned)}) {
      Scene changed = scene;
      changed.w0_B = other;
      changed.camera = held_by_hand(scene);  // the frame stays while a hand has ω
      if (attitude) changed.attitude = attitude;
      const SceneModel model = make_model(scene), remade = make_model(changed);
      for (std::size_t pane = 0; pane < scene.views.size(); ++pane) {
        TrialOmega trial(model, pane, kAspect, attitude);
        trial.at(Vec3(0.1, 0.2, -0.7));  // leaves nothing behind
        const auto tried = trial.at(other), made = drawn_omega(remade, 0.0, pane, kAspect);
        ASSERT_TRUE(tried && made);
        EXPECT_LT((tried->tip_V - made->tip_V).norm(), 1e-12);
        expect_same(tried->camera, made->camera);
      }
    }
}

// A file may say that a frame is kept from an ω that the scene's method cannot serve.
TEST(OmegaTip, OfATrialWhoseKeptOmegaCannotBeHasTheFrameOfTheScene) {
  Scene scene = scene_with({O::omega, O::shape}, {View::space});
  scene.w0_B = Vec3(0, 0, 2);
  scene.motion = {.method = Method::uniform};
  scene.camera.holds_still = true;
  scene.camera.fitted = CameraFit{0.6, 0.35, Vec3(1, 2, 4)};
  const SceneModel model = make_model(scene);
  EXPECT_EQ(model.framed, nullptr);
  EXPECT_TRUE(TrialOmega(model, 0, 1.0).at(Vec3(0, 1, 1)));
}

// 2026-11-28: while ω was pulled, the arrow of L grew although |L| had become smaller.
TEST(OmegaTip, AHandThatTakesOmegaLeavesTheScaleOfL) {
  for (const OverlaySet& show :
       {OverlaySet{O::omega, O::L}, OverlaySet{O::omega, O::L, O::energy_ellipsoid, O::plane}}) {
    Scene scene = scene_with(show, {View::space});
    const auto length_per_L = [](const Scene& drawn) {
      const SceneModel model = make_model(drawn);
      const builders::Snapshot m = builders::snapshot_at(model, 0, View::space);
      return m.L_drawn_B(m.L_B).norm() / m.L_B.norm();
    };
    const double before = length_per_L(scene);
    scene.camera.fitted = CameraFit{scene.camera.azimuth_rad, scene.camera.elevation_rad, scene.w0_B};
    scene.w0_B = Vec3(0.4, 0.3, 0.2);
    EXPECT_NEAR(length_per_L(scene), before, 1e-12 * before);
  }
}

TEST(OmegaTip, IsNotWhereNoOmegaIsDrawn) {
  const SceneModel model = make_model(scene_with({O::omega}, {View::body}));
  EXPECT_FALSE(drawn_omega(model, 0, 1, 1.0));
  EXPECT_FALSE(drawn_omega(make_model(scene_with({O::L})), 0, 0, 1.0));
  Scene rest = scene_with({O::omega, O::shape});
  rest.w0_B.setZero();
  EXPECT_FALSE(drawn_omega(make_model(rest), 0, 0, 1.0));
  EXPECT_FALSE(TrialOmega(model, 0, 1.0).at(Vec3::Zero()));
}

TEST(OmegaTip, AnArrowFromTheCentreLiesWhereTheOverlayWould) {
  Scene scene = scene_with({O::shape});
  MarkVector omega;
  omega.overlay = O::omega;
  EXPECT_FALSE(has_arrow_along(scene, O::omega));
  scene.marks.arrows = {{.of = omega, .at = omega}};
  EXPECT_FALSE(has_arrow_along(scene, O::omega));
  scene.marks.arrows = {{.of = omega, .length = 0.9}};
  EXPECT_TRUE(has_arrow_along(scene, O::omega));
  EXPECT_FALSE(has_arrow_along(scene, O::L));
}

}  // namespace
}  // namespace polhode
