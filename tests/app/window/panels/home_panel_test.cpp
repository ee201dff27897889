// SPDX-License-Identifier: MIT
// The list of all lessons, and what stands at the end of one.
#include "tests/app/window/screen_harness.h"

namespace polhode {
namespace {

class HomePanel : public ScreenTest {
 protected:
  HomePanel() {
    screen->set_lessons([&] {
      return std::vector<LessonProgress>{
          {.id = session.lesson().id,
           .title = "This one",
           .outcomes = {"derive", "prove"},
           .next = "symmetric-top"},
          {.id = "symmetric-top", .title = "The next one", .stages = 3, .outcomes = {"solve"}, .at = 2}};
    });
  }
  void go_to_end() {
    const std::vector<Stage>& stages = session.lesson().stages;
    session.go_to({stages.size() - 1, stages.back().steps.size() - 1});
    frame(3);
  }
};

TEST_F(HomePanel, OpensAnotherLessonByKeys) {
  frame(3);
  ASSERT_TRUE(screen->press(session, "Ctrl+L"));
  frame(4);
  EXPECT_EQ(session.panel, Panel::lessons);
  give_to_panel(ImGuiKey_Enter);
  EXPECT_EQ(session.panel, Panel::none) << "the keyboard is on the lesson where one is";
  EXPECT_EQ(screen->requests().open_lesson, "");
  ASSERT_TRUE(screen->press(session, "Ctrl+L"));
  frame(4);
  EXPECT_TRUE(screen->press(session, "Tab"));
  frame(4);
  give_to_panel(ImGuiKey_Enter);
  EXPECT_EQ(screen->requests().open_lesson, "symmetric-top");
}

TEST_F(HomePanel, MovesNothingOfThePage) {
  session.preferences.theme = Theme::dark;
  frame(3);
  const Image before = screen->read();
  screen->press(session, "Ctrl+L");
  frame(4);
  EXPECT_NE(screen->read().rgba, before.rgba);
  EXPECT_TRUE(screen->press(session, "Escape"));
  frame(4);
  EXPECT_TRUE(screen->read().rgba == before.rgba);
}

TEST_F(HomePanel, StandsBehindTheEndWithTheNextLessonFirst) {
  go_to_end();
  ASSERT_TRUE(screen->press(session, "Right"));
  frame(4);
  ASSERT_EQ(session.panel, Panel::lessons);
  give_to_panel(ImGuiKey_Enter);
  EXPECT_EQ(screen->requests().open_lesson, "symmetric-top");
  screen->requests().open_lesson.clear();
  session.previous_step();
  frame(4);
  EXPECT_EQ(session.panel, Panel::none) << "it would hide where one has gone";
}

// 2026-11-28: whoever had just opened the lesson for the first time was told to go on, one stage seen.
TEST_F(HomePanel, ALessonThatWasOpenedAloneIsNotBegun) {
  session.panel = Panel::lessons;
  frame(4);
  const Image fresh = screen->read();
  LessonSession begun(test::loaded_lesson("euler-equations"));
  begun.preferences = session.preferences;
  begun.next_step();
  begun.previous_step();
  begun.panel = Panel::lessons;
  const auto draw = [&](LessonSession& shown) {
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(screen->draw(shown, {.size = kSize, .scale = 1, .seconds = 0.02}));
  };
  draw(begun);
  EXPECT_TRUE(screen->read().rgba == fresh.rgba) << "where it began, with nothing else seen";
  begun.next_stage();
  begun.panel = Panel::lessons;
  draw(begun);
  begun.panel = Panel::lessons;
  draw(begun);
  EXPECT_FALSE(screen->read().rgba == fresh.rgba);
}

}  // namespace
}  // namespace polhode
