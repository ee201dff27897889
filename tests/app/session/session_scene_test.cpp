// SPDX-License-Identifier: MIT
// What is changed of the scene by hand.
#include "app/session/lesson_session.h"
#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using test::example;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

double turn_between(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2 * std::numbers::pi));
}

TEST(CompanionScene, ModelIsThatOfTheEditedScene) {
  Companion companion(example());
  const SceneEdits edits{.body = find_body("book"), .w0_B = Vec3(1, 2, 3), .views = {{View::body}}};
  ASSERT_TRUE(companion.set_edits(edits));
  EXPECT_EQ(companion.edits(), edits);
  EXPECT_EQ(companion.model()->scene, edited(companion.lesson_scene(), edits));
  EXPECT_EQ(companion.model()->motion->w_B_at(0), Vec3(1, 2, 3));
  EXPECT_TRUE(companion.model()->needs.meters) << "a page has plots too";
}

TEST(CompanionScene, RefusesWhatCannotBeAndChangesNothing) {
  Companion companion(example());
  ASSERT_TRUE(companion.set_edits({.body = find_body("book")}));
  companion.scrub_to(0.3);
  companion.set_playing(true);
  const SceneModel* model = companion.model();
  const unsigned number = companion.model_number();
  SceneEdits edits = companion.edits();
  edits.motion = MotionSpec{.method = Method::symmetric};
  const Status refused = companion.set_edits(edits);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error(), HasSubstr("symmetric"));
  EXPECT_EQ(companion.model(), model);
  EXPECT_EQ(companion.model_number(), number);
  EXPECT_EQ(companion.edits(), (SceneEdits{.body = find_body("book")}));
  EXPECT_EQ(companion.t_s(), 0.3);
  EXPECT_TRUE(companion.is_playing());
}

TEST(CompanionScene, HasNothingToEditWithoutAScene) {
  Companion companion(example());
  companion.go_to({1, 0});
  EXPECT_FALSE(companion.set_edits({.w0_B = Vec3(1, 2, 3)}).ok());
  companion.reset_edits();
  companion.set_camera({});
  companion.set_following(true);
  companion.reset_time();
  companion.scrub_to(1);
  companion.step_frames(1);
  EXPECT_EQ(companion.t_s(), 0);
  EXPECT_FALSE(companion.is_following());
}

TEST(CompanionScene, AnotherMotionStartsAtZeroAndAnotherMethodGoesOn) {
  Companion companion(example());
  companion.scrub_to(0.3);
  companion.set_playing(true);
  SceneEdits edits{.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01, .ghost = true}};
  ASSERT_TRUE(companion.set_edits(edits));
  EXPECT_EQ(companion.t_s(), 0.3);
  edits.on.insert(Overlay::shape);
  ASSERT_TRUE(companion.set_edits(edits));
  EXPECT_EQ(companion.t_s(), 0.3);
  EXPECT_TRUE(companion.is_playing());
  edits.w0_B = Vec3(1, 2, 3);
  ASSERT_TRUE(companion.set_edits(edits));
  EXPECT_EQ(companion.t_s(), 0);
  EXPECT_TRUE(companion.is_playing()) << "it goes on from there";
}

TEST(CompanionScene, TimeStaysWithinWhatTheNewMethodReaches) {
  Companion companion(example());
  companion.scrub_to(1e6);
  ASSERT_TRUE(companion.set_edits({.motion = MotionSpec{.method = Method::rk4, .step_s = 1e-3}}));
  EXPECT_EQ(companion.t_s(), companion.model()->reach_s);
}

TEST(CompanionScene, CameraQualityAndHighlightCostNoModel) {
  Companion companion(example());
  const unsigned number = companion.model_number();
  companion.set_camera({.azimuth_rad = 1.0, .elevation_rad = 0.2, .distance = 5, .zoom = 2});
  SceneEdits edits = companion.edits();
  edits.quality = QualityLevel::draft;
  ASSERT_TRUE(companion.set_edits(edits));
  companion.light("polhode");
  EXPECT_EQ(companion.model_number(), number);
  const Scene& scene = companion.model()->scene;
  EXPECT_EQ(scene.camera, companion.camera());
  EXPECT_NEAR(scene.camera.azimuth_rad, 1.0, 1e-4 * std::numbers::pi / 180) << "whole 1e-4°";
  EXPECT_EQ(scene.camera.zoom, 2);
  EXPECT_EQ(scene.quality, QualityLevel::draft);
  EXPECT_THAT(scene.highlight, ElementsAre("polhode"));
}

TEST(CompanionScene, WhatIsPointedAtIsHighlightedBesideWhatTheLessonHighlights) {
  Companion companion(example());
  companion.go_to({0, 2});
  const auto lights = [&] { return companion.model()->scene.highlight; };
  companion.light("L");
  EXPECT_THAT(lights(), ElementsAre("omega", "L"));
  companion.light("omega");
  EXPECT_THAT(lights(), ElementsAre("omega"));
  companion.light("some-term");
  EXPECT_THAT(lights(), ElementsAre("omega"));
  companion.light("L");
  ASSERT_TRUE(companion.set_edits({.w0_B = Vec3(1, 2, 3)}));
  EXPECT_THAT(lights(), ElementsAre("omega", "L")) << "in a model made anew too";
  companion.light({});
  EXPECT_THAT(lights(), ElementsAre("omega"));
}

TEST(CompanionScene, ResetGivesTheSceneBackToTheLesson) {
  Companion companion(example());
  SceneEdits edits{.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01}, .views = {{View::body}}};
  ASSERT_TRUE(companion.set_edits(edits));
  companion.set_following(true);
  companion.set_camera({.azimuth_rad = 1.0});
  companion.scrub_to(0.3);
  companion.reset_edits();
  EXPECT_TRUE(companion.edits().empty());
  EXPECT_EQ(companion.model()->scene, companion.lesson_scene());
  EXPECT_FALSE(companion.is_following());
  EXPECT_EQ(companion.t_s(), 0.3) << "the motion is the same";
  ASSERT_TRUE(companion.set_edits({.w0_B = Vec3(1, 2, 3)}));
  companion.reset_edits();
  EXPECT_EQ(companion.t_s(), 0.5) << "the scene's own time";
}

TEST(CompanionScene, EditsLastAsLongAsTheSceneDoes) {
  Companion companion(example());
  companion.set_camera({.azimuth_rad = 1.0});
  SceneEdits edits = companion.edits();
  edits.off.insert(Overlay::omega);
  ASSERT_TRUE(companion.set_edits(edits));
  const SceneModel* model = companion.model();
  companion.next_step();
  EXPECT_EQ(companion.model(), model) << "the same scene";
  EXPECT_EQ(companion.edits(), edits);
  companion.next_step();
  EXPECT_EQ(companion.edits(), SceneEdits{.camera = edits.camera}) << "the lesson does not turn the camera";
  companion.next_step();
  EXPECT_TRUE(companion.edits().empty()) << "here it does";
  companion.set_camera({.azimuth_rad = 1.0});
  companion.next_stage();
  companion.previous_stage();
  EXPECT_TRUE(companion.edits().empty());
}

/// How far the camera, following, turns within a period, and the most in one of its 2000 parts.
struct Turning {
  double whole_rad = 0, largest_step_rad = 0;
};
Turning turning_over_a_period(Companion& companion) {
  Turning turning;
  const int kParts = 2000;
  const double period_s = companion.model()->span_s;
  companion.scrub_to(0);
  companion.set_following(true);
  double before = companion.camera().azimuth_rad;
  for (int i = 1; i <= kParts; ++i) {
    companion.scrub_to(period_s * i / kParts);
    const double now = companion.camera().azimuth_rad;
    turning.largest_step_rad = std::max(turning.largest_step_rad, turn_between(now, before));
    turning.whole_rad += std::remainder(now - before, 2 * std::numbers::pi);
    before = now;
  }
  return turning;
}

TEST(CompanionScene, FollowingKeepsPaceWithTheBodyWithoutAJerk) {
  // Spins about each axis, two of them flipping on either side of the separatrix.
  for (const Vec3& w0_B : {Vec3(0.05, 2, 0.02), Vec3(0.02, 2, 0.05), Vec3(2, 0.1, 0.1), Vec3(0.1, 0.1, 2)}) {
    Companion companion(example());
    ASSERT_TRUE(companion.set_edits({.w0_B = w0_B}));
    const double period_s = companion.model()->span_s;
    const Turning turning = turning_over_a_period(companion);
    // The body turns by some |ω| t, and no part of a period by more than a few times its share.
    EXPECT_GT(std::abs(turning.whole_rad), 0.5 * w0_B.norm() * period_s) << w0_B.transpose();
    EXPECT_LT(turning.largest_step_rad, 4 * w0_B.norm() * period_s / 2000) << w0_B.transpose();
  }
}

TEST(CompanionScene, FollowingBeginsAndEndsWithoutAJump) {
  Companion companion(example());
  companion.scrub_to(0.3);
  const CameraSpec before = companion.camera();
  companion.set_following(true);
  EXPECT_EQ(companion.camera(), before);
  companion.scrub_to(0.8);
  const CameraSpec followed = companion.camera();
  EXPECT_GT(turn_between(followed.azimuth_rad, before.azimuth_rad), 0.1);
  EXPECT_EQ(companion.model()->scene.camera, followed);
  SceneEdits edits = companion.edits();
  edits.on.insert(Overlay::shape);
  ASSERT_TRUE(companion.set_edits(edits));
  EXPECT_EQ(companion.camera(), followed) << "a change of something else leaves it";
  companion.set_camera({.azimuth_rad = 0.5});
  const CameraSpec turned = companion.camera();
  EXPECT_NEAR(turned.azimuth_rad, 0.5, 1e-6) << "turned by hand it goes on from there";
  companion.scrub_to(0.9);
  const CameraSpec last = companion.camera();
  EXPECT_NE(last, turned);
  companion.set_following(false);
  EXPECT_EQ(companion.camera(), last);
  companion.scrub_to(0.1);
  EXPECT_EQ(companion.camera(), last);
  companion.set_following(true);
  companion.next_stage();
  EXPECT_FALSE(companion.is_following());
}

}  // namespace
}  // namespace polhode
