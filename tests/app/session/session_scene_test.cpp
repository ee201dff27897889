// SPDX-License-Identifier: MIT
// What is changed of the scene by hand.
#include "app/session/lesson_session.h"
#include "lessons/reader/checks/lesson_check.h"
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

TEST(SessionScene, ModelIsThatOfTheEditedScene) {
  LessonSession session(example());
  const SceneEdits edits{.body = find_body("book"), .w0_B = Vec3(1, 2, 3), .views = {{View::body}}};
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.edits(), edits);
  EXPECT_EQ(session.model()->scene, edited(session.lesson_scene(), edits));
  EXPECT_EQ(session.model()->motion->w_B_at(0), Vec3(1, 2, 3));
  EXPECT_TRUE(session.model()->needs.meters) << "a page has plots too";
}

TEST(SessionScene, RefusesWhatCannotBeAndChangesNothing) {
  LessonSession session(example());
  ASSERT_TRUE(session.set_edits({.body = find_body("book")}));
  session.scrub_to(0.3);
  session.set_playing(true);
  const SceneModel* model = session.model();
  const unsigned number = session.model_number();
  SceneEdits edits = session.edits();
  edits.motion = MotionSpec{.method = Method::symmetric};
  const Status refused = session.set_edits(edits);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error(), HasSubstr("symmetric"));
  EXPECT_EQ(session.model(), model);
  EXPECT_EQ(session.model_number(), number);
  EXPECT_EQ(session.edits(), (SceneEdits{.body = find_body("book")}));
  EXPECT_EQ(session.t_s(), 0.3);
  EXPECT_TRUE(session.is_playing());
}

TEST(SessionScene, HasNothingToEditWithoutAScene) {
  LessonSession session(example());
  session.go_to({1, 0});
  EXPECT_FALSE(session.set_edits({.w0_B = Vec3(1, 2, 3)}).ok());
  session.reset_edits();
  session.set_camera({});
  session.set_following(true);
  session.reset_time();
  session.scrub_to(1);
  session.step_frames(1);
  EXPECT_EQ(session.t_s(), 0);
  EXPECT_FALSE(session.is_following());
}

TEST(SessionScene, AnotherMotionStartsAtZeroAndAnotherMethodGoesOn) {
  LessonSession session(example());
  session.scrub_to(0.3);
  session.set_playing(true);
  SceneEdits edits{.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01, .ghost = true}};
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.t_s(), 0.3);
  edits.on.insert(Overlay::shape);
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.t_s(), 0.3);
  EXPECT_TRUE(session.is_playing());
  edits.w0_B = Vec3(1, 2, 3);
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.t_s(), 0);
  EXPECT_TRUE(session.is_playing()) << "it goes on from there";
}

TEST(SessionScene, TimeStaysWithinWhatTheNewMethodReaches) {
  LessonSession session(example());
  session.scrub_to(1e6);
  ASSERT_TRUE(session.set_edits({.motion = MotionSpec{.method = Method::rk4, .step_s = 1e-3}}));
  EXPECT_EQ(session.t_s(), session.model()->reach_s);
}

TEST(SessionScene, CameraQualityAndHighlightCostNoModel) {
  LessonSession session(example());
  const unsigned number = session.model_number();
  session.set_camera({.azimuth_rad = 1.0, .elevation_rad = 0.2, .distance = 5, .zoom = 2});
  SceneEdits edits = session.edits();
  edits.quality = QualityLevel::draft;
  ASSERT_TRUE(session.set_edits(edits));
  session.light("polhode");
  EXPECT_EQ(session.model_number(), number);
  const Scene& scene = session.model()->scene;
  EXPECT_EQ(scene.camera, session.camera());
  EXPECT_NEAR(scene.camera.azimuth_rad, 1.0, 1e-4 * std::numbers::pi / 180) << "whole 1e-4°";
  EXPECT_EQ(scene.camera.zoom, 2);
  EXPECT_EQ(scene.quality, QualityLevel::draft);
  EXPECT_THAT(scene.highlight, ElementsAre("polhode"));
}

TEST(SessionScene, WhatIsPointedAtIsHighlightedBesideWhatTheLessonHighlights) {
  LessonSession session(example());
  session.go_to({0, 2});
  const auto lights = [&] { return session.model()->scene.highlight; };
  session.light("L");
  EXPECT_THAT(lights(), ElementsAre("omega", "L"));
  session.light("omega");
  EXPECT_THAT(lights(), ElementsAre("omega"));
  session.light("some-term");
  EXPECT_THAT(lights(), ElementsAre("omega"));
  session.light("L");
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  EXPECT_THAT(lights(), ElementsAre("omega", "L")) << "in a model made anew too";
  session.light({});
  EXPECT_THAT(lights(), ElementsAre("omega"));
}

TEST(SessionScene, ResetGivesTheSceneBackToTheLesson) {
  LessonSession session(example());
  SceneEdits edits{.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01}, .views = {{View::body}}};
  ASSERT_TRUE(session.set_edits(edits));
  session.set_following(true);
  session.set_camera({.azimuth_rad = 1.0});
  session.scrub_to(0.3);
  session.reset_edits();
  EXPECT_TRUE(session.edits().empty());
  EXPECT_EQ(session.model()->scene, session.lesson_scene());
  EXPECT_FALSE(session.is_following());
  EXPECT_EQ(session.t_s(), 0.3) << "the motion is the same";
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  session.reset_edits();
  EXPECT_EQ(session.t_s(), 0.5) << "the scene's own time";
}

TEST(SessionScene, EditsLastAsLongAsTheSceneDoes) {
  LessonSession session(example());
  session.set_camera({.azimuth_rad = 1.0});
  SceneEdits edits = session.edits();
  edits.off.insert(Overlay::omega);
  ASSERT_TRUE(session.set_edits(edits));
  const SceneModel* model = session.model();
  session.next_step();
  EXPECT_EQ(session.model(), model) << "the same scene";
  EXPECT_EQ(session.edits(), edits);
  session.next_step();
  EXPECT_EQ(session.edits(), SceneEdits{.camera = edits.camera}) << "the lesson does not turn the camera";
  session.next_step();
  EXPECT_TRUE(session.edits().empty()) << "here it does";
  session.set_camera({.azimuth_rad = 1.0});
  session.next_stage();
  session.previous_stage();
  EXPECT_EQ(session.edits(), edits) << "the scene that it was made of";
}

/// How far the camera, following, turns within a period, and the most in one of its 2000 parts.
struct Turning {
  double whole_rad = 0, largest_step_rad = 0;
};
Turning turning_over_a_period(LessonSession& session) {
  Turning turning;
  const int kParts = 2000;
  const double period_s = session.model()->span_s;
  session.scrub_to(0);
  session.set_following(true);
  double before = session.camera().azimuth_rad;
  for (int i = 1; i <= kParts; ++i) {
    session.scrub_to(period_s * i / kParts);
    const double now = session.camera().azimuth_rad;
    turning.largest_step_rad = std::max(turning.largest_step_rad, turn_between(now, before));
    turning.whole_rad += std::remainder(now - before, 2 * std::numbers::pi);
    before = now;
  }
  return turning;
}

TEST(SessionScene, FollowingKeepsPaceWithTheBodyWithoutAJerk) {
  // Spins about each axis, two of them flipping on either side of the separatrix.
  for (const Vec3& w0_B : {Vec3(0.05, 2, 0.02), Vec3(0.02, 2, 0.05), Vec3(2, 0.1, 0.1), Vec3(0.1, 0.1, 2)}) {
    LessonSession session(example());
    ASSERT_TRUE(session.set_edits({.w0_B = w0_B}));
    const double period_s = session.model()->span_s;
    const Turning turning = turning_over_a_period(session);
    // The body turns by some |ω| t, and no part of a period by more than a few times its share.
    EXPECT_GT(std::abs(turning.whole_rad), 0.5 * w0_B.norm() * period_s) << w0_B.transpose();
    EXPECT_LT(turning.largest_step_rad, 4 * w0_B.norm() * period_s / 2000) << w0_B.transpose();
  }
}

TEST(SessionScene, FollowingBeginsAndEndsWithoutAJump) {
  LessonSession session(example());
  session.scrub_to(0.3);
  const CameraSpec before = session.camera();
  session.set_following(true);
  EXPECT_EQ(session.camera(), before);
  session.scrub_to(0.8);
  const CameraSpec followed = session.camera();
  EXPECT_GT(turn_between(followed.azimuth_rad, before.azimuth_rad), 0.1);
  EXPECT_EQ(session.model()->scene.camera, followed);
  SceneEdits edits = session.edits();
  edits.on.insert(Overlay::shape);
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(session.camera(), followed) << "a change of something else leaves it";
  session.set_camera({.azimuth_rad = 0.5});
  const CameraSpec turned = session.camera();
  EXPECT_NEAR(turned.azimuth_rad, 0.5, 1e-6) << "turned by hand it goes on from there";
  session.scrub_to(0.9);
  const CameraSpec last = session.camera();
  EXPECT_NE(last, turned);
  session.set_following(false);
  EXPECT_EQ(session.camera(), last);
  session.scrub_to(0.1);
  EXPECT_EQ(session.camera(), last);
  session.set_following(true);
  session.next_stage();
  EXPECT_FALSE(session.is_following());
}

std::shared_ptr<const LoadedLesson> lesson_of_scene(const std::string& keys) {
  const std::string text =
      "+++\nformat = 1\nid = 'a'\ntitle = 'A'\n+++\n# S {s}\n\n```scene\n" + keys + "\n```\n";
  LessonReading reading = check_lesson(text, "a.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::make_shared<const LoadedLesson>(LoadedLesson{std::move(*reading.lesson), "a.md", ""});
}

TEST(SessionScene, TurningOneCameraTurnsAllSideBySide) {
  LessonSession session(lesson_of_scene(
      "scenes = [{}, { omega = [0, 0, 1], camera = { azimuth_deg = 90, elevation_deg = 10 } }]"));
  const CameraSpec own = session.lesson_scene().beside.at(0).camera;
  EXPECT_EQ(session.model()->beside.at(0).scene.camera, own);
  const CameraSpec turned = writable({.azimuth_rad = 1, .elevation_rad = 0.5});
  session.set_camera(turned);
  EXPECT_EQ(session.model()->scene.camera, turned);
  EXPECT_EQ(session.model()->beside[0].scene.camera, turned);
  session.set_camera(session.lesson_scene().camera);
  EXPECT_EQ(session.model()->beside[0].scene.camera, own) << "put back";
}

TEST(SessionScene, WhatChangesTheMotionChangesTheFirstAlone) {
  LessonSession session(lesson_of_scene("scenes = [{}, { omega = [0, 0, 1] }]"));
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3), .on = {Overlay::omega}, .views = {{View::body}}}));
  EXPECT_EQ(session.model()->scene.w0_B, Vec3(1, 2, 3));
  const Scene& other = session.model()->beside.at(0).scene;
  EXPECT_EQ(other.w0_B, Vec3(0, 0, 1));
  EXPECT_TRUE(other.show.contains(Overlay::omega));
  EXPECT_THAT(other.views, ElementsAre(View::body));
}

TEST(SessionScene, TheSameMotionSeenInTwoWaysStaysOne) {
  LessonSession session(lesson_of_scene(
      "omega = [1, 2, 3]\nattitude = 'L-down'\nscenes = [{ show = ['shape'] }, { show = ['polhode'] }, "
      "{ motion = { method = 'rk4', step = 0.1 } }]"));
  const Body book = *find_body("book");
  ASSERT_TRUE(session.set_edits({.body = book,
                                 .w0_B = Vec3(0, 4, 0.1),
                                 .motion = MotionSpec{.method = Method::explicit_euler, .step_s = 0.01}}));
  const std::vector<SceneModel>& beside = session.model()->beside;
  for (const SceneModel& other : beside) {
    EXPECT_EQ(other.scene.body, book);
    EXPECT_EQ(other.scene.w0_B, Vec3(0, 4, 0.1));
  }
  EXPECT_EQ(beside.at(0).scene.motion, session.model()->scene.motion);
  EXPECT_EQ(beside.at(1).scene.motion.method, Method::rk4) << "it is there to be compared with";
}

TEST(SessionScene, ANumberIsVariedWhileTimeGoesOn) {
  LessonSession session(lesson_of_scene("omega = [0, 0, 3]\nvary = { omega3 = { from = 1, to = 9 } }"));
  EXPECT_TRUE(session.model()->beside.empty()) << "the slider stands for the filmstrip";
  ASSERT_EQ(session.variations().size(), 1U);
  EXPECT_EQ(session.variations()[0].value, 3);
  session.scrub_to(0.25);
  session.set_playing(true);
  ASSERT_TRUE(session.vary(0, 5));
  EXPECT_EQ(session.model()->motion->w_B_at(0.25), Vec3(0, 0, 5));
  EXPECT_EQ(session.t_s(), 0.25);
  EXPECT_TRUE(session.is_playing());
  ASSERT_TRUE(session.vary(0, 50));
  EXPECT_EQ(session.variations()[0].value, 9) << "not beyond the range";
  EXPECT_FALSE(session.vary(1, 2).ok());
  EXPECT_FALSE(session.vary(0, NAN).ok());
  ASSERT_TRUE(session.vary(0, 3));
  EXPECT_TRUE(session.edits().empty()) << "that of the lesson";
  ASSERT_TRUE(session.vary(0, 4));
  session.reset_edits();
  EXPECT_EQ(session.variations()[0].value, 3);
}

TEST(SessionScene, ANumberThatCannotBeIsRefused) {
  LessonSession session(lesson_of_scene("body = 'textbook'\nvary = { I1 = { from = 0.8, to = 1.2 } }"));
  ASSERT_TRUE(session.vary(0, 1.2)) << "1.2 + 1.75 > 2.5";
  ASSERT_TRUE(session.vary(0, 0.8));
  EXPECT_EQ(session.model()->scene.body.moments, PrincipalMoments(0.8, 1.75, 2.5));
}

}  // namespace
}  // namespace polhode
