// SPDX-License-Identifier: MIT
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode::window_test {
namespace {

const std::string kLecture = "euler-equations";

class Walk : public WindowTest {};

TitlePlace after(const TitlePlace& now) {
  if (now.step < now.steps) return {now.stage_title, now.stage, now.stages, now.step + 1, now.steps};
  return {"", now.stage + 1, now.stages, 1, 0};
}

bool is_last(const TitlePlace& now) { return now.stage == now.stages && now.step == now.steps; }

TEST_F(Walk, TheKeyboardAloneGoesThroughTheLectureAndBack) {
  PlayedLesson lesson(display(), home(), {kLecture});
  ASSERT_EQ(lesson.place().stage, 1);
  ASSERT_EQ(lesson.place().step, 1);
  ASSERT_GT(lesson.place().stages, 20);

  std::vector<TitlePlace> way = {lesson.place()};
  while (!is_last(way.back())) {
    const TitlePlace next = after(way.back());
    lesson.press({"Right"});
    ASSERT_TRUE(lesson.comes_to(next.stage, next.step)) << "from " << way.back().stage_title;
    way.push_back(lesson.place());
    ASSERT_FALSE(lesson.process().code());
  }
  EXPECT_GT(way.size(), 60u);
  EXPECT_FALSE(is_blank(lesson.picture_at_rest()));

  lesson.press({"Right"});  // there is nothing further
  for (int stage = way.back().stage; stage >= 1; --stage) {
    const auto first = std::ranges::find(way, stage, &TitlePlace::stage);
    lesson.press(std::vector<std::string>(static_cast<std::size_t>(first->steps - 1), "Left"));
    ASSERT_TRUE(lesson.comes_to(stage, 1)) << "back to " << first->stage_title;
    ASSERT_EQ(lesson.place(), *first);
    lesson.press({"Left"});  // to the last step of the stage before, if there is one
  }
  EXPECT_EQ(lesson.said(), "");
}

TEST_F(Walk, KeysGoFromStageToStage) {
  PlayedLesson lesson(display(), home(), {kLecture});
  const int last = lesson.place().stages;
  lesson.press({"End"});
  EXPECT_TRUE(lesson.comes_to(last, 1));
  lesson.press({"Right", "Up"});  // first to the beginning of this stage
  EXPECT_TRUE(lesson.comes_to(last, 1));
  lesson.press({"Up"});
  EXPECT_TRUE(lesson.comes_to(last - 1, 1));
  lesson.press({"Home", "Down", "ctrl+Next", "shift+Next"});
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

TEST_F(Walk, TheMouseAloneGoesThroughTheLectureAndBack) {
  PlayedLesson lesson(display(), home(), {kLecture});
  int steps = 0;
  for (TitlePlace now = lesson.place(); !is_last(now); now = lesson.place(), ++steps) {
    const TitlePlace next = after(now);
    lesson.click(kNextStep);
    ASSERT_TRUE(lesson.comes_to(next.stage, next.step)) << "from " << now.stage_title;
  }
  EXPECT_GT(steps, 60);
  lesson.click(kPreviousStep);
  EXPECT_TRUE(eventually([&] { return !is_last(lesson.place()); }));
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
    lesson.press({"Down", "Down", "Right"});
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
