// SPDX-License-Identifier: MIT
// Before an audience: the keys of clickers and of those who have given many talks.
#include "tests/app/window/screen_harness.h"

#include <imgui_internal.h>

namespace polhode {
namespace {

class PresentingTest : public ScreenTest {
 protected:
  void SetUp() override {
    screen->press(session, "P");
    frame(3);
    ASSERT_TRUE(session.is_presenting());
  }
  bool is_black() {
    frame(2);
    const Image shown = screen->read();
    for (int row = 0; row < kSize.height; row += 7)
      for (int at = 0; at < kSize.width; at += 7)
        if (shown.pixel(at, row)[0] + shown.pixel(at, row)[1] + shown.pixel(at, row)[2] > 0) return false;
    return true;
  }
};

TEST_F(PresentingTest, TheScreenIsBlackUntilTheNextKey) {
  for (const char* key : {".", "B"}) {
    for (int i = 0; i < 300; ++i) frame();  // what was told is gone
    EXPECT_FALSE(is_black());
    const StepPlace before = session.place();
    screen->press(session, key);
    EXPECT_TRUE(is_black()) << key;
    EXPECT_EQ(session.panel, Panel::none) << key;
    screen->press(session, "Right");
    EXPECT_FALSE(is_black()) << key;
    EXPECT_EQ(session.place(), before) << "nobody has seen what comes next";
    screen->press(session, key);
    screen->press(session, key);
    EXPECT_FALSE(session.is_black());
  }
  screen->press(session, ".");
  screen->press(session, "Escape");
  EXPECT_TRUE(session.is_presenting()) << "Escape leaves the black screen first";
}

TEST_F(PresentingTest, ANumberAndEnterLeadToAStage) {
  for (const char* key : {"1", "2", "Enter"}) EXPECT_TRUE(screen->press(session, key)) << key;
  EXPECT_EQ(session.place(), (StepPlace{11, 0}));
  for (const char* key : {"9", "9", "Enter"}) screen->press(session, key);
  EXPECT_EQ(session.place(), (StepPlace{11, 0}));
  EXPECT_NE(screen->notice().find("There is no stage 99"), std::string::npos) << screen->notice();
  screen->press(session, "3");
  screen->press(session, "Right");  // thinks better of it
  screen->press(session, "Enter");
  EXPECT_EQ(session.place(), (StepPlace{11, 1}));
}

TEST_F(PresentingTest, PanelsAreSeenAndEscapeGoesOneStepBack) {
  for (const char* key : {"O", "M", "S", "Q", "E", "?"}) {
    const Image before = screen->read();
    screen->press(session, key);
    frame(3);
    EXPECT_NE(session.panel, Panel::none) << key;
    EXPECT_NE(screen->read().rgba, before.rgba) << key << ": it is drawn";
    screen->press(session, "Escape");
    frame(3);
    if (ImGui::GetIO().WantTextInput || session.panel != Panel::none) screen->press(session, "Escape");
    frame(2);
    EXPECT_EQ(session.panel, Panel::none) << key;
    EXPECT_TRUE(session.is_presenting()) << key;
  }
  screen->press(session, "Escape");
  EXPECT_FALSE(session.is_presenting());
}

TEST_F(PresentingTest, AClickBesideTheFigureGoesOn) {
  const PixelBox& figure = screen->page().page().figure;
  ASSERT_GT(figure.width(), 0);
  click(0.5 * (figure.x0 + figure.x1), 0.5 * (figure.y0 + figure.y1));
  EXPECT_EQ(session.place(), (StepPlace{0, 0})) << "that is taken hold of";
  click(0.5 * figure.x0, kSize.height - 20);
  EXPECT_EQ(session.place(), (StepPlace{0, 1}));
  screen->press(session, "P");
  frame(3);
  click(0.5 * figure.x0, kSize.height - 120);
  EXPECT_EQ(session.place(), (StepPlace{0, 1})) << "who reads clicks where he likes";
}

TEST_F(PresentingTest, ASpotFollowsTheMouse) {
  for (int i = 0; i < 300; ++i) frame();  // what was told is gone
  move(300, kSize.height - 60);
  const Image without = screen->read();
  screen->press(session, "L");
  EXPECT_TRUE(session.is_pointing());
  frame(2);
  const auto redness = [](const Image& image, int column, int row) {
    return image.pixel(column, row)[0] - image.pixel(column, row)[1];
  };
  const Image with = screen->read();
  EXPECT_GT(redness(with, 300, kSize.height - 60), redness(without, 300, kSize.height - 60) + 80);
  EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_None) << "in place of the cursor";
  move(340, kSize.height - 60);
  EXPECT_GT(redness(screen->read(), 340, kSize.height - 60), 80);
  move(-1, -1);
  EXPECT_EQ(screen->read().rgba, without.rgba) << "it leaves with the mouse";
  screen->press(session, "Escape");
  screen->press(session, "P");
  EXPECT_FALSE(session.is_pointing());
}

// What walks for a remote clicker walks whatever has the keyboard.
TEST_F(PresentingTest, AClickerWalksThoughAPanelIsOpen) {
  for (const char* key : {"M", "E"}) {
    session.go_to({0, 0});
    screen->press(session, key);
    frame(3);
    ASSERT_TRUE(screen->press(session, "PageDown")) << key;
    EXPECT_EQ(session.place(), (StepPlace{0, 1})) << key;
    EXPECT_FALSE(screen->press(session, "Down")) << key << ": that moves in the panel";
    screen->press(session, "Escape");
    frame(2);
  }
}

TEST_F(PresentingTest, APanelThatWasOpenIsClosed) {
  screen->press(session, "Escape");
  screen->press(session, "O");
  frame(2);
  screen->press(session, "P");
  EXPECT_EQ(session.panel, Panel::none);
}

// 2026-11-28: F5, which begins a talk everywhere, ended the one that N had begun.
TEST_F(PresentingTest, F5EndsNoTalkThatHasAWindowOfTheSpeakers) {
  screen->press(session, "N");
  ASSERT_TRUE(session.has_speaker());
  screen->press(session, "F5");
  EXPECT_TRUE(session.has_speaker());
  EXPECT_TRUE(session.is_presenting());
  EXPECT_NE(screen->notice().find("Escape"), std::string::npos) << screen->notice();
  screen->press(session, "Escape");
  EXPECT_FALSE(session.is_presenting());
}

// 2026-11-28: nor one that P had begun.
TEST_F(PresentingTest, F5EndsNoTalk) {
  screen->press(session, "F5");
  EXPECT_TRUE(session.is_presenting());
  EXPECT_NE(screen->notice().find("Escape"), std::string::npos) << screen->notice();
  screen->press(session, "P");
  EXPECT_FALSE(session.is_presenting());
  screen->press(session, "F5");
  EXPECT_TRUE(session.is_presenting());
}

// 2026-11-29: "Enter: go to stage 2" stood on the ordinary window when the talk had ended.
TEST_F(PresentingTest, ANumberIsTakenBack) {
  screen->press(session, "2");
  EXPECT_NE(screen->notice().find("stage 2"), std::string::npos) << screen->notice();
  screen->press(session, "Escape");
  EXPECT_TRUE(session.is_presenting()) << "Escape takes the number back first";
  EXPECT_EQ(screen->notice(), "");
  screen->press(session, "Enter");
  EXPECT_EQ(session.place(), StepPlace{});
  screen->press(session, "2");
  session.set_presenting(false);  // by a button, say
  frame();
  EXPECT_EQ(screen->notice(), "");
  screen->press(session, "P");
  frame();
  screen->press(session, "Enter");
  EXPECT_EQ(session.place(), StepPlace{}) << "a number of the talk before";
  screen->press(session, "2");
  screen->press(session, "T");
  EXPECT_EQ(screen->notice(), "") << "another key ends the number, too";
}

// 2026-11-29
TEST_F(PresentingTest, WhatIsToldGoesWhenItIsNoLongerSo) {
  EXPECT_NE(screen->notice().find("Escape ends"), std::string::npos) << screen->notice();
  screen->press(session, ".");
  EXPECT_TRUE(is_black()) << "a hint is not told on a black screen";
  screen->press(session, ".");
  screen->press(session, "Escape");
  frame();
  EXPECT_EQ(screen->notice(), "") << "Escape ends nothing any more";
  screen->press(session, "F6");
  EXPECT_NE(screen->notice(), "");
  screen->press(session, "O");
  frame();
  EXPECT_EQ(screen->notice(), "") << "a panel is open";
  screen->press(session, "Escape");
  screen->press(session, "R");
  EXPECT_NE(screen->notice(), "") << "the scene is the lesson's";
  screen->press(session, "V");
  frame();
  EXPECT_EQ(screen->notice(), "");
}

// 2026-11-29: who had switched letters off made the screen black with B.
TEST_F(PresentingTest, WithoutLettersOnlyWhatClickersSendIsACommand) {
  session.preferences.letter_keys = false;
  for (const char* key : {"B", "L", "N", "T", "O"}) {
    EXPECT_FALSE(screen->press(session, key)) << key;
    EXPECT_FALSE(session.is_black()) << key;
    EXPECT_FALSE(session.is_pointing()) << key;
    EXPECT_EQ(session.panel, Panel::none) << key;
  }
  screen->press(session, ".");
  EXPECT_TRUE(session.is_black());
  screen->press(session, "L");
  EXPECT_TRUE(session.is_black()) << "it does nothing there either";
  screen->press(session, ".");
  EXPECT_FALSE(session.is_black());
  for (const char* key : {"1", "2", "Enter"}) EXPECT_TRUE(screen->press(session, key)) << key;
  EXPECT_EQ(session.place(), (StepPlace{11, 0}));
}

// 2026-11-29: a number stayed typed when what Enter does with it had gone.
TEST_F(PresentingTest, ANumberIsTypedForAsLongAsItIsShown) {
  const StepPlace before = session.place();
  screen->press(session, "1");
  frame(2);
  ASSERT_NE(screen->notice(), "");
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(screen->draw(session, {.size = kSize, .scale = 1, .seconds = 1}));
  screen->press(session, "Enter");
  EXPECT_EQ(session.place(), before);
}

// 2026-11-29: N did nothing, and nothing else led to the speaker's window.
TEST_F(PresentingTest, ALetterThatIsNoCommandSaysSo) {
  screen->press(session, "P");
  frame();
  session.preferences.letter_keys = false;
  EXPECT_FALSE(screen->press(session, "N"));
  EXPECT_NE(screen->notice().find("F2"), std::string::npos) << screen->notice();
  session.preferences.letter_keys = true;
  frame();
  EXPECT_EQ(screen->notice(), "") << "they are commands again";
}

// 2026-11-29: before the audience stood "changed by hand" with buttons.
TEST_F(PresentingTest, ThatTheSceneWasChangedIsNotOnThePage) {
  SceneEdits edits;
  edits.views = {View::body};
  ASSERT_TRUE(session.set_edits(edits));
  frame(3);
  const ImGuiWindow* chip = ImGui::FindWindowByName("changed-scene");
  EXPECT_TRUE(chip == nullptr || !chip->Active);
  EXPECT_TRUE(screen->press(session, "Ctrl+Z"));
  EXPECT_TRUE(session.edits().empty());
  ASSERT_TRUE(session.set_edits(edits));
  screen->press(session, "P");
  frame(3);
  chip = ImGui::FindWindowByName("changed-scene");
  ASSERT_NE(chip, nullptr) << "one who reads is told";
  EXPECT_TRUE(chip->Active);
}

// 2026-11-29: the outline told an audience how its speaker had answered.
TEST_F(PresentingTest, TheOutlineHasNoScores) {
  const auto has_scores = [this] {
    screen->press(session, "O");
    frame(3);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
      if (window->Active && std::string(window->Name).find("contents") != std::string::npos)
        return ImGui::GetCurrentContext()->Tables.GetMapSize() > 0;
    return false;
  };
  EXPECT_FALSE(has_scores());
  screen->press(session, "Escape");
  screen->press(session, "P");
  EXPECT_TRUE(has_scores()) << "for who reads they are there";
}

// 2026-11-28: "stage 13 of 29" stood before a class for which two stages had been chosen.
TEST_F(PresentingTest, StagesForAClassAreCounted) {
  for (const Stage& stage : session.lesson().stages)
    session.leave_out(stage.id, stage.id != "newton" && stage.id != "poinsot");
  session.go_to({1, 0});
  session.set_left_out(session.left_out());
  frame(3);
  const Image chosen = screen->page().picture().read();
  session.set_left_out({});
  frame(3);
  EXPECT_NE(screen->page().picture().read().rgba, chosen.rgba) << "stage 1 of 2, stage 2 of 29";
  for (const Stage& stage : session.lesson().stages)
    session.leave_out(stage.id, stage.id != "newton" && stage.id != "poinsot");
  for (const char* key : {"2", "Enter"}) EXPECT_TRUE(screen->press(session, key)) << key;
  EXPECT_EQ(session.stage().id, "poinsot") << "as the page counts";
  for (const char* key : {"3", "Enter"}) screen->press(session, key);
  EXPECT_NE(screen->notice().find("There is no stage 3; the last is 2"), std::string::npos)
      << screen->notice();
}

}  // namespace
}  // namespace polhode
