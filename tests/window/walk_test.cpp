// SPDX-License-Identifier: MIT
// From place to place. The whole lecture is walked by keys and by the mouse in whole_lecture_test.cpp.
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>

namespace polhode::window_test {
namespace {

const std::string kLecture = "euler-equations";

class Walk : public WindowTest {};

TEST_F(Walk, KeysGoFromStageToStage) {
  PlayedLesson lesson(display(), home(), {kLecture});
  const int last = lesson.place().stages;
  lesson.press({"End"});
  EXPECT_TRUE(lesson.comes_to(last, 1));
  lesson.press({"Right", "Up"});  // first to the beginning of this stage
  EXPECT_TRUE(lesson.comes_to(last, 1));
  lesson.press({"Up"});
  EXPECT_TRUE(lesson.comes_to(last - 1, 1));
  // At the first step something is to be predicted: it is asked for once.
  lesson.press({"Home", "Down", "Down", "ctrl+Next", "shift+Next"});
  EXPECT_TRUE(lesson.comes_to(4, 1));
  lesson.press({"shift+Prior", "ctrl+Prior"});
  EXPECT_TRUE(lesson.comes_to(2, 1));
}

// The keys of a remote clicker go from step to step, as in the deck; while presenting too.
TEST_F(Walk, AClickerGoesFromStepToStep) {
  PlayedLesson lesson(display(), home(), {kLecture});
  ASSERT_GT(lesson.place().steps, 2);
  lesson.press({"p", "Next", "Next"});
  EXPECT_TRUE(lesson.comes_to(1, 3));
  lesson.press({"Prior"});
  EXPECT_TRUE(lesson.comes_to(1, 2));
}

TEST_F(Walk, TheOutlineLeadsToAStage) {
  PlayedLesson lesson(display(), home(), {kLecture});
  lesson.click(kOutline);
  const Image opened = lesson.picture_at_rest();
  lesson.click(kThirdStage);
  EXPECT_TRUE(lesson.comes_to(3, 1));
  EXPECT_TRUE(lesson.changes_from(opened));
}

TEST_F(Walk, ThePositionIsKeptAndAStageAskedForWins) {
  {
    PlayedLesson lesson(display(), home(), {kLecture});
    lesson.press({"Down", "Down", "Down", "Right"});
    ASSERT_TRUE(lesson.comes_to(3, 2));
    lesson.close();
    EXPECT_EQ(lesson.process().wait(), 0);
  }
  {
    PlayedLesson lesson(display(), home(), {kLecture});
    EXPECT_EQ(lesson.place().stage, 3);
    EXPECT_EQ(lesson.place().step, 2);
    lesson.press({"ctrl+q"});
    EXPECT_EQ(lesson.process().wait(), 0);
  }
  PlayedLesson lesson(display(), home(), {kLecture, "--stage", "newton"});
  EXPECT_EQ(lesson.place().stage, 2);
  EXPECT_EQ(lesson.place().step, 1);
}

}  // namespace
}  // namespace polhode::window_test
