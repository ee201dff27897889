// SPDX-License-Identifier: MIT
#include "app/session/scene_edits.h"

#include "render/scene/model/model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using ::testing::HasSubstr;

Scene lesson_scene() {
  Scene scene;
  scene.show = {Overlay::omega, Overlay::L, Overlay::plane};
  scene.torque.clear();
  return scene;
}

TEST(SceneEdits, LeaveTheSceneAsItIsWhereThereAreNone) {
  EXPECT_TRUE(SceneEdits{}.empty());
  EXPECT_EQ(edited(lesson_scene(), {}), lesson_scene());
}

// A body that turns once a day stood still at a book's rate.
TEST(SceneEdits, AnOmegaOfAnotherKindIsShownAtAPaceThatOneSees) {
  Scene scene = lesson_scene();
  scene.w0_B = Vec3(0.1, 12, 0.2);
  scene.rate = 0.3;
  scene.duration_s = 5;
  const Scene slow = edited(scene, {.w0_B = Vec3(0, 7.3e-5, 0)});
  EXPECT_NEAR(*slow.rate * 4, 2 * std::numbers::pi / 7.3e-5, 1);
  EXPECT_GT(*slow.duration_s, *slow.rate);
  const Scene twice = edited(scene, {.w0_B = Vec3(0.2, 24, 0.4)});
  EXPECT_EQ(twice.rate, scene.rate);
  EXPECT_EQ(twice.duration_s, scene.duration_s);
}

TEST(SceneEdits, EachIsInTheScene) {
  const SceneEdits edits{.body = find_body("racket"),
                         .w0_B = Vec3(1, 2, 3),
                         .attitude = Quat(0.6, 0, 0.8, 0),
                         .motion = MotionSpec{.method = Method::rk4, .step_s = 0.1},
                         .on = {Overlay::shape},
                         .off = {Overlay::L},
                         .views = {{View::body}},
                         .camera = CameraSpec{.zoom = 2},
                         .quality = QualityLevel::fine};
  EXPECT_FALSE(edits.empty());
  Scene expected = lesson_scene();
  expected.body = *edits.body;
  expected.w0_B = *edits.w0_B;
  expected.attitude = *edits.attitude;
  expected.motion = *edits.motion;
  expected.show = {Overlay::omega, Overlay::plane, Overlay::shape};
  expected.views = {View::body};
  expected.camera.zoom = 2;
  expected.quality = QualityLevel::fine;
  EXPECT_EQ(edited(lesson_scene(), edits), expected);
}

// 2026-11-26: a caption stayed below another view, other overlays and another method. 2026-11-29: one that
// was true went with all that was shown besides.
TEST(SceneEdits, ACaptionIsOfWhatTheLessonShows) {
  Scene scene = lesson_scene();
  scene.caption = "Seen from space";
  const auto is_kept = [&](const SceneEdits& edits) { return !edited(scene, edits).caption.empty(); };
  EXPECT_TRUE(is_kept({}));
  EXPECT_TRUE(is_kept({.camera = CameraSpec{.zoom = 2}, .quality = QualityLevel::fine}));
  EXPECT_TRUE(is_kept({.motion = scene.motion, .views = scene.views})) << "the lesson's own";
  EXPECT_TRUE(is_kept({.body = scene.body, .w0_B = scene.w0_B})) << "moved, and back";
  EXPECT_FALSE(is_kept({.views = {{View::body}}}));
  EXPECT_TRUE(is_kept({.views = {{View::body, View::space}}})) << "what it speaks of is seen";
  EXPECT_TRUE(is_kept({.on = {Overlay::shape}}));
  EXPECT_FALSE(is_kept({.off = {Overlay::L}}));
  MotionSpec with_ghost = scene.motion;
  with_ghost.ghost = true;
  EXPECT_TRUE(is_kept({.motion = with_ghost}));
  with_ghost.method = Method::rk4;
  with_ghost.step_s = 0.1;
  EXPECT_FALSE(is_kept({.motion = with_ghost}));
  EXPECT_FALSE(is_kept({.motion = MotionSpec{.method = Method::rk4, .step_s = 0.1}}));
  EXPECT_FALSE(is_kept({.w0_B = Vec3(1, 2, 3)}));
  scene.show.erase(Overlay::plane);
  EXPECT_FALSE(is_kept({.on = {Overlay::plane}})) << "the body lies otherwise beside it";
}

TEST(SceneEdits, HidingThePlaneDoesNotTurnTheBodyOver) {
  const Scene scene = lesson_scene();
  const Scene hidden = edited(scene, {.off = {Overlay::plane}});
  EXPECT_EQ(problem_of(hidden).start.q_SB, problem_of(scene).start.q_SB);
}

TEST(SceneEdits, ShowingThePlaneUnderATorqueDoesNotTurnTheBodyOver) {
  Scene scene;
  scene.torque = {SpaceTorque{Vec3(0.0, 0.0, -1.0)}};
  SceneEdits edits;
  edits.on.insert(Overlay::plane);
  EXPECT_EQ(problem_of(edited(scene, edits)).start.q_SB.coeffs(), problem_of(scene).start.q_SB.coeffs());
  scene.torque.clear();  // without one, the plane below the body is the picture of it
  EXPECT_NE(problem_of(edited(scene, edits)).start.q_SB.coeffs(), problem_of(scene).start.q_SB.coeffs());
}

TEST(SceneEdits, KeepNothingOfWhatTheLessonShowsAnyway) {
  const Scene scene = lesson_scene();
  SceneEdits edits;
  set_shown(edits, scene, Overlay::omega, true);
  set_shown(edits, scene, Overlay::shape, false);
  EXPECT_TRUE(edits.empty());
  set_shown(edits, scene, Overlay::omega, false);
  set_shown(edits, scene, Overlay::shape, true);
  EXPECT_EQ(edits.on, OverlaySet{Overlay::shape});
  EXPECT_EQ(edits.off, OverlaySet{Overlay::omega});
  set_shown(edits, scene, Overlay::omega, true);
  set_shown(edits, scene, Overlay::shape, false);
  EXPECT_TRUE(edits.empty());
}

TEST(SceneEdits, ABodyOfImpossibleMomentsIsRefusedByItsInequality) {
  const auto body = body_with_moments({1, 2, 2.5});
  ASSERT_TRUE(body.ok());
  EXPECT_EQ(body->moments, PrincipalMoments(1, 2, 2.5));
  const auto impossible = body_with_moments({1, 2, 4});
  ASSERT_FALSE(impossible.ok());
  EXPECT_EQ(impossible.error(), *why_impossible(1, 2, 4));
  EXPECT_FALSE(body_with_moments({1, std::nan(""), 1}).ok());
}

TEST(SceneEdits, AWritableCameraIsHardlyAnotherAndStaysTheSame) {
  constexpr double kHalfPart = 0.5e-4 * std::numbers::pi / 180 * (1 + 1e-9);
  for (int i = -200; i <= 200; ++i) {
    const CameraSpec camera{
        .azimuth_rad = 0.0153 * i, .elevation_rad = 0.0078 * i, .distance = 3, .zoom = 1.5};
    const CameraSpec written = writable(camera);
    EXPECT_NEAR(written.azimuth_rad, camera.azimuth_rad, kHalfPart);
    EXPECT_NEAR(written.elevation_rad, camera.elevation_rad, kHalfPart);
    EXPECT_EQ(writable(written), written);
  }
  const CameraSpec bounded = writable({.azimuth_rad = 7, .elevation_rad = 2, .distance = 1000, .zoom = 0});
  EXPECT_NEAR(bounded.azimuth_rad, 7 - 2 * std::numbers::pi, kHalfPart);
  EXPECT_EQ(bounded.elevation_rad, 90 * (std::numbers::pi / 180));
  EXPECT_EQ(bounded.distance, 100);
  EXPECT_EQ(bounded.zoom, 0.1);
}

TEST(SceneEdits, ABodyOfAShapeHangsOnTheLessonsPivot) {
  Scene scene = lesson_scene();
  scene.torque = {HeavyTop{0.5, Vec3::UnitY()}};
  const Body book = *find_body("book");
  const double l_m = 0.5 / (book.mass_kg * 9.80665);
  const Vec3 expected = book.moments.vector() + book.mass_kg * l_m * l_m * Vec3(1, 0, 1);
  EXPECT_LT((edited(scene, {.body = book}).body.moments.vector() - expected).norm(), 1e-15);
  scene.torque = {HeavyTop{0.5, Vec3(0.6, 0.8, 0)}};
  EXPECT_THROW(edited(scene, {.body = book}), std::domain_error);
}

}  // namespace
}  // namespace polhode
