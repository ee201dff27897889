// SPDX-License-Identifier: MIT
// Nothing that was made by hand is lost.
#include "app/session/command.h"
#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

using test::example;

/// One change by hand.
void start_with(LessonSession& session, const Vec3& w0_B) {
  session.begin_change();
  SceneEdits edits = session.edits();
  edits.w0_B = w0_B;
  ASSERT_TRUE(session.set_edits(edits));
}

TEST(Undo, TakesBackOneChangeAfterTheOther) {
  LessonSession session(example());
  EXPECT_FALSE(session.can_undo());
  EXPECT_FALSE(session.undo());
  const Vec3 first(1, 0, 0.1), second(0, 1, 0.1);
  start_with(session, first);
  start_with(session, second);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.edits().w0_B, first);
  EXPECT_TRUE(do_command(session, *command_of("Ctrl+Z")));
  EXPECT_TRUE(session.edits().empty());
  EXPECT_FALSE(session.undo());
}

TEST(Redo, MakesAgainWhatWasTakenBackUntilSomethingElseIsDone) {
  LessonSession session(example());
  const Vec3 first(1, 0, 0.1), second(0, 1, 0.1), other(0, 0, 1);
  EXPECT_FALSE(session.redo());
  start_with(session, first);
  start_with(session, second);
  session.scrub_to(0.25);
  const Vec3 shown = session.model()->motion->w_B_at(0.25);
  EXPECT_TRUE(session.undo() && session.undo());
  EXPECT_TRUE(session.edits().empty());
  EXPECT_TRUE(do_command(session, *command_of("Ctrl+Y")));
  EXPECT_EQ(session.edits().w0_B, first);
  EXPECT_TRUE(do_command(session, *command_of("Shift+Ctrl+Z")));
  EXPECT_EQ(session.edits().w0_B, second);
  EXPECT_EQ(session.t_s(), 0.25);
  EXPECT_EQ(session.model()->motion->w_B_at(0.25), shown);
  EXPECT_FALSE(session.can_redo());
  // What is made again can be taken back again.
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.edits().w0_B, first);
  EXPECT_TRUE(session.can_redo());
  start_with(session, other);
  EXPECT_FALSE(session.can_redo());
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.edits().w0_B, first);
}

TEST(Redo, OutlivesAWalkAndAResetIsOneOfTheChanges) {
  LessonSession session(example());
  const StepPlace here = session.place();
  start_with(session, {1, 0, 0.1});
  session.reset_edits();
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 0, 0.1));
  session.go_to({1, 0});
  session.go_to(here);
  EXPECT_TRUE(session.redo());
  EXPECT_TRUE(session.edits().empty());
}

TEST(Redo, LeavesTheCameraThatWasTurnedSince) {
  LessonSession session(example());
  start_with(session, {1, 0, 0.1});
  EXPECT_TRUE(session.undo());
  session.set_camera({.azimuth_rad = 2});
  EXPECT_TRUE(session.can_redo()) << "to look at it from elsewhere changes nothing";
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 0, 0.1));
  EXPECT_NEAR(session.camera().azimuth_rad, 2, 1e-5) << "as it is written";
}

TEST(Undo, ADragIsOneChange) {
  LessonSession session(example());
  start_with(session, {1, 0, 0.1});
  for (const double w : {1.1, 1.2, 1.3}) {
    SceneEdits edits = session.edits();
    edits.w0_B = Vec3(w, 0, 0.1);
    ASSERT_TRUE(session.set_edits(edits));
  }
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.edits().empty());
}

TEST(Undo, GivesBackWhatWasResetAndLeavesTheCamera) {
  LessonSession session(example());
  start_with(session, {1, 0, 0.1});
  session.set_camera({.azimuth_rad = 1});
  session.reset_edits();
  session.set_camera({.azimuth_rad = 2});
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 0, 0.1));
  EXPECT_NEAR(session.camera().azimuth_rad, 2, 1e-5) << "as it is written";
}

TEST(Undo, GivesBackTheTimeAndTheCameraThatAHandChanged) {
  LessonSession session(example());
  session.set_camera({.azimuth_rad = 1});
  session.scrub_to(0.5);
  const double here_s = session.t_s();
  const CameraSpec seen = session.camera();
  session.begin_change();
  for (const double w : {1.0, 1.1}) {  // a hand on ω turns the camera, too, so that the attitude is held
    SceneEdits edits = session.edits();
    edits.w0_B = Vec3(w, 0, 0.1);
    edits.camera = CameraSpec{.azimuth_rad = 2 + w};
    ASSERT_TRUE(session.set_edits(edits));
  }
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.t_s(), here_s);
  EXPECT_EQ(session.camera(), seen);
}

TEST(Undo, WhatWasChangedIsThereAgainWhenOneComesBack) {
  LessonSession session(example());
  const StepPlace here = session.place();
  start_with(session, {1, 0, 0.1});
  session.next_stage();
  session.go_to(here);
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 0, 0.1));
  session.reset_edits();
  session.next_stage();
  session.go_to(here);
  EXPECT_TRUE(session.edits().empty()) << "given back to the lesson";
}

// 2026-11-28: what was changed was there again, and could not be undone.
TEST(Undo, IsKnownWhenOneComesBack) {
  LessonSession session(example());
  const StepPlace here = session.place();
  start_with(session, {1, 0, 0.1});
  start_with(session, {0, 1, 0.1});
  session.next_stage();
  EXPECT_FALSE(session.can_undo()) << "there nothing was changed";
  session.go_to(here);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.edits().w0_B, Vec3(1, 0, 0.1));
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.edits().empty());
  EXPECT_FALSE(session.can_undo());
}

TEST(Undo, ACaptionOfAnotherMotionGoes) {
  LessonSession session(test::loaded_lesson("euler-equations"));
  ASSERT_FALSE(session.model()->scene.caption.empty());
  start_with(session, {1, 2, 3});
  EXPECT_TRUE(session.model()->scene.caption.empty());
  session.undo();
  EXPECT_FALSE(session.model()->scene.caption.empty());
  SceneEdits edits = session.edits();
  for (int i = 0; i < kOverlayCount; ++i)
    if (const auto shown = static_cast<Overlay>(i); session.lesson_scene().show.contains(shown))
      edits.off.insert(shown);
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_TRUE(session.model()->scene.caption.empty()) << "it may speak of what is seen no more";
}

TEST(Undo, KeysGoFromFlipToFlip) {
  LessonSession session(example());
  for (bool more = true; more && session.flips().size() < 2; more = session.next_step()) {
  }
  ASSERT_GE(session.flips().size(), 2U);
  session.scrub_to(session.time_line().from_s);
  for (const double t_s : std::vector<double>(session.flips())) {
    do_command(session, *command_of(">"));
    EXPECT_EQ(session.t_s(), t_s);
  }
  const double last_s = session.t_s();
  do_command(session, *command_of(">"));
  EXPECT_EQ(session.t_s(), last_s) << "there is no other";
  do_command(session, *command_of("<"));
  EXPECT_LT(session.t_s(), last_s);
}

}  // namespace
}  // namespace polhode
