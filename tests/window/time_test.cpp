// SPDX-License-Identifier: MIT
// Time in the window: playing, pausing, going to an instant.
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>

namespace polhode::window_test {
namespace {

class Time : public WindowTest {};

TEST_F(Time, PlaysAndPauses) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture();
  lesson.press({"space"});
  ASSERT_TRUE(lesson.changes_from(start));
  const int frames = lesson.frames();
  ASSERT_TRUE(eventually([&] { return lesson.frames() > frames + 10; }));
  EXPECT_GT(changed_part(start, lesson.picture(), kFigureFrom, kFigureTo), 0.01);

  lesson.press({"space"});
  const Image paused = lesson.picture_at_rest();
  EXPECT_FALSE(lesson.changes_from(paused, std::chrono::milliseconds(500)));
  lesson.press({"0"});  // the time of the lesson
  EXPECT_TRUE(lesson.changes_from(paused));
  EXPECT_EQ(lesson.picture_at_rest().rgba, start.rgba);
}

TEST_F(Time, TheButtonPlaysToo) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const int before = lesson.frames();
  lesson.click(kPlay);
  EXPECT_TRUE(eventually([&] { return lesson.frames() > before + 20; }));
}

// Time is no replay: the same frame again is the same picture, to the last pixel; by rk4 too.
TEST_F(Time, FramesGoForwardAndBack) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  for (const char* to_step : {"Left", "Right"}) {
    lesson.press({to_step});
    Image seen[3] = {lesson.picture_at_rest()};
    for (int i = 1; i < 3; ++i) {
      lesson.press({"shift+Right"});
      ASSERT_TRUE(lesson.changes_from(seen[i - 1]));
      seen[i] = lesson.picture_at_rest();
    }
    for (int i = 2; i-- > 0;) {
      lesson.press({"shift+Left"});
      ASSERT_TRUE(lesson.changes_from(seen[i + 1]));
      EXPECT_EQ(lesson.picture_at_rest().rgba, seen[i].rgba) << i;
    }
  }
}

TEST_F(Time, TheTimeLineScrubsBothWays) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const auto at = [](double part) {
    return Point{int(kTimeLineStart.x + part * (kTimeLineEnd.x - kTimeLineStart.x)), kTimeLineStart.y};
  };
  const auto seen_at = [&](double part) {
    lesson.move_to({1, 1});  // nothing lights up under it
    const Image before = lesson.picture_at_rest();
    lesson.drag({at(0.5), at(part)});
    lesson.move_to({1, 1});
    EXPECT_TRUE(lesson.changes_from(before));
    return lesson.picture_at_rest();
  };
  const Image early = seen_at(0.3), late = seen_at(0.8), early_again = seen_at(0.3);
  EXPECT_GT(changed_part(early, late, kFigureFrom, kFigureTo), 0.01);
  EXPECT_EQ(early.rgba, early_again.rgba);
}

TEST_F(Time, AtRestThereIsNothingToDo) {
  PlayedLesson lesson(display(), home(), {"euler-equations", "--stage", "poinsot"});
  lesson.picture_at_rest();
  const double before_s = lesson.process().cpu_s();
  const int frames = lesson.frames();
  std::this_thread::sleep_for(std::chrono::seconds(3));
  EXPECT_LT(lesson.process().cpu_s() - before_s, 0.1);
  EXPECT_LE(lesson.frames(), frames + 1);
}

}  // namespace
}  // namespace polhode::window_test
