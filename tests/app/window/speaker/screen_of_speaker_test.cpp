// SPDX-License-Identifier: MIT
// What only the speaker sees.
#include "app/window/speaker/screen_of_speaker.h"

#include "tests/app/window/screen_harness.h"

#include <imgui_internal.h>

#include <cstring>

namespace polhode {
namespace {

std::string lesson_with(const std::string& notes) {
  return "+++\nformat = 1\nid = \"talk\"\ntitle = \"Talk\"\n+++\n# One {one}\nText of one.\n" + notes +
         "\n\n---\nMore of it.\n\n# Two {two}\nText of two.\n\n```scene\nomega = [0, 1, 0.1]\n```\n";
}

class SpeakerTest : public ScreenTest {
 protected:
  SpeakerTest() {
    session.replace_lesson(test::loaded_text(lesson_with("\n> [!notes] Say that $\\omega$ is not $L$.")));
    session.go_to({});
    session.set_speaker(true);
    frame(2);
    speaker = std::move(ScreenOfSpeaker::create(*screen)).value();
  }
  void both(int count = 3) {
    for (int i = 0; i < count; ++i) {
      ImGui::SetCurrentContext(screen->imgui());
      frame();
      ImGui::SetCurrentContext(speaker->imgui());
      ImGui::GetIO().MousePos = {at_x, at_y};
      ImGui::GetIO().MouseDown[0] = pressed;
      const Status drawn = speaker->draw(session, {.size = kSize, .scale = 1, .seconds = 0.02});
      ASSERT_TRUE(drawn) << drawn.error();
    }
  }
  void click_here(float to_x, float to_y) {
    at_x = to_x;
    at_y = to_y;
    both(2);
    pressed = true;
    both(2);
    pressed = false;
    both(3);
  }

  std::unique_ptr<ScreenOfSpeaker> speaker;
  float at_x = -1, at_y = -1;
  bool pressed = false;
};

int differing(const Image& a, const Image& b, int x0, int y0, int x1, int y1) {
  int count = 0;
  for (int row = y0; row < y1; ++row)
    for (int at = x0; at < x1; ++at) count += std::memcmp(a.pixel(at, row), b.pixel(at, row), 4) != 0;
  return count;
}

// Beside the audience's on the only screen it has a half.
TEST_F(SpeakerTest, NothingIsCutInAHalfOfAScreen) {
  both();
  for (const Size size : {Size{683, 768}, Size{640, 1080}, Size{960, 800}, kSize}) {
    ImGui::SetCurrentContext(speaker->imgui());
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(speaker->draw(session, {.size = size, .scale = 1, .seconds = 0.02}));
    const ImGuiWindow* controls = ImGui::FindWindowByName("walk");
    ASSERT_NE(controls, nullptr);
    EXPECT_EQ(controls->ScrollMax.x, 0) << size.width;
    EXPECT_EQ(controls->ScrollMax.y, 0) << size.width;
    EXPECT_LE(controls->ContentSize.x, controls->Size.x) << size.width;
  }
}

// 2026-11-28: in a half of a wide screen the next step could not be read.
TEST_F(SpeakerTest, TheNextStepIsAsLargeAsThePageInAHighWindow) {
  both();
  constexpr Size kHigh{960, 1080};
  ImGui::SetCurrentContext(speaker->imgui());
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(speaker->draw(session, {.size = kHigh, .scale = 1, .seconds = 0.02}));
  const ImGuiWindow* notes = ImGui::FindWindowByName("notes");
  ASSERT_NE(notes, nullptr);
  EXPECT_GE(notes->Size.x, 479);
  EXPECT_GT(notes->Pos.y, 290) << "below a picture that is as wide";
}

TEST_F(SpeakerTest, NotesAreOnTheSpeakersScreenAlone) {
  both();
  const Image audience = screen->read(), with_notes = speaker->read();
  session.replace_lesson(test::loaded_text(lesson_with("")));
  both();
  EXPECT_EQ(screen->read().rgba, audience.rgba);
  const Image without = speaker->read();
  EXPECT_GT(differing(with_notes, without, 780, 355, 1280, 800), 200);
  EXPECT_EQ(differing(with_notes, without, 0, 30, 740, 400), 0) << "the page is the same";
}

TEST_F(SpeakerTest, ShowsThePageTheNextStepAndWhereWeAre) {
  both();
  const Image first = speaker->read();
  ASSERT_TRUE(screen->press_from_afar(session, "Right", false));
  EXPECT_EQ(session.place(), (StepPlace{0, 1}));
  both();
  const Image second = speaker->read();
  EXPECT_GT(differing(first, second, 10, 40, 700, 400), 100) << "the page";
  EXPECT_GT(differing(first, second, 790, 40, 1270, 330), 100) << "what comes next";
  session.go_to({1, 0});
  both();
  EXPECT_GT(differing(second, speaker->read(), 10, 40, 700, 400), 100);
}

TEST_F(SpeakerTest, SeesThePageWhileTheAudienceSeesBlack) {
  both();
  const Image before = speaker->read();
  ASSERT_TRUE(screen->press_from_afar(session, ".", false));
  both();
  EXPECT_TRUE(session.is_black());
  const Image black = screen->read();
  EXPECT_EQ(black.pixel(640, 400)[0] + black.pixel(640, 400)[1] + black.pixel(640, 400)[2], 0);
  const Image now = speaker->read();
  EXPECT_EQ(differing(before, now, 20, 50, 730, 440), 0);
  EXPECT_GT(differing(before, now, 0, 0, 740, 34), 20) << "and is told so";
  EXPECT_GT(differing(before, now, 0, 34, 18, 440), 500) << "by a frame round the page too";
}

TEST_F(SpeakerTest, WalksAndJumpsByTheMouse) {
  both();
  for (float row = 470; row < 560 && session.place() == StepPlace{}; row += 8) click_here(130, row);
  EXPECT_EQ(session.place(), (StepPlace{0, 1})) << "its button Next";
  session.go_to({});
  for (float row = 780; row > 560 && session.place() == StepPlace{}; row -= 8) click_here(120, row);
  EXPECT_EQ(session.place(), (StepPlace{1, 0})) << "the second stage in the outline";
  EXPECT_TRUE(session.has_speaker());
}

TEST_F(SpeakerTest, PointsOnTheAudiencesPage) {
  both();
  const Image before = screen->read();
  ASSERT_TRUE(screen->press_from_afar(session, "L", false));
  at_x = 300;
  at_y = 200;
  both();
  const Image pointed = screen->read();
  // The page is 738 px wide here, and 10 px from the left edge.
  EXPECT_GT(differing(before, pointed, 480, 260, 520, 310), 200);
  EXPECT_EQ(differing(before, pointed, 0, 0, 450, 800), 0);
  at_x = 1000;  // over the notes
  both();
  EXPECT_EQ(screen->read().rgba, before.rgba);
}

TEST_F(SpeakerTest, LooksElsewhereWhileTheAudienceSeesWhatItSaw) {
  both();
  const Image before = screen->read();
  ASSERT_TRUE(screen->press_from_afar(session, "H", false));
  both();
  EXPECT_TRUE(session.is_frozen());
  ASSERT_TRUE(screen->press_from_afar(session, "Right", false));
  both();
  EXPECT_EQ(screen->for_audience().read().rgba, before.rgba);
  EXPECT_NE(screen->read().rgba, before.rgba) << "the speaker sees the step he went to";
  screen->press_from_afar(session, ".", false);
  both();
  const Image black = screen->for_audience().read();
  EXPECT_EQ(black.pixel(640, 400)[0] + black.pixel(640, 400)[1] + black.pixel(640, 400)[2], 0);
  screen->press_from_afar(session, ".", false);
  screen->press_from_afar(session, "H", false);
  both();
  EXPECT_NE(screen->for_audience().read().rgba, before.rgba);
  session.set_frozen(true);
  session.set_speaker(false);
  EXPECT_FALSE(session.is_frozen()) << "nobody could look elsewhere";
}

// 2026-11-29: Alt+F4 in the speaker's window brought the step that he looked at, the answer, before the
// audience.
TEST_F(SpeakerTest, WhatTheAudienceSeesDoesNotGoOnWhenTheWindowIsClosed) {
  for (const bool talk_ends : {false, true}) {
    session.go_to({1, 0});
    session.set_speaker(true);
    both();
    const Image before = screen->for_audience().read();
    const double seen_s = session.t_s();
    ASSERT_TRUE(screen->press_from_afar(session, "H", false));
    both();
    SceneEdits edits = session.edits();
    edits.views = {View::body};
    ASSERT_TRUE(session.set_edits(edits));
    session.scrub_to(seen_s + 1);
    ASSERT_TRUE(screen->press_from_afar(session, "Home", false));
    ASSERT_TRUE(screen->press_from_afar(session, "S", false));
    both();
    EXPECT_NE(session.place(), (StepPlace{1, 0}));
    if (talk_ends)
      session.set_presenting(false);
    else
      session.set_speaker(false);
    ImGui::SetCurrentContext(screen->imgui());
    frame();
    EXPECT_EQ(session.place(), (StepPlace{1, 0}));
    EXPECT_EQ(session.t_s(), seen_s);
    EXPECT_EQ(session.panel, Panel::none);
    EXPECT_TRUE(session.edits().empty());
    EXPECT_EQ(session.is_presenting(), !talk_ends);
    if (!talk_ends) {
      EXPECT_EQ(screen->for_audience().read().rgba, before.rgba);
    }
    screen->press(session, "Left");
    frame();
    EXPECT_EQ(session.place(), (StepPlace{0, 1})) << "until one walks";
  }
}

TEST_F(SpeakerTest, ReleasedThePageGoesOnToWhereTheSpeakerIs) {
  both();
  screen->press_from_afar(session, "H", false);
  both();
  screen->press_from_afar(session, "Right", false);
  both();
  screen->press_from_afar(session, "H", false);
  both();
  session.set_speaker(false);
  ImGui::SetCurrentContext(screen->imgui());
  frame();
  EXPECT_EQ(session.place(), (StepPlace{0, 1}));
}

// 2026-11-28: the audience saw letters half faded in, one above the other, for as long as the page was
// frozen.
TEST_F(SpeakerTest, AStepThatIsComingInComesInBeforeItIsFrozen) {
  session.preferences.reduced_motion = false;
  both();
  ASSERT_TRUE(screen->press_from_afar(session, "Right", false));
  both(1);
  ASSERT_TRUE(screen->press_from_afar(session, "H", false));
  both(1);
  EXPECT_EQ(session.transition(), 1);
  EXPECT_TRUE(session.is_frozen());
  const Image frozen = screen->for_audience().read();
  EXPECT_EQ(frozen.rgba, screen->read().rgba);
  // 2026-11-29: who walked on before the step was in froze the next one.
  ASSERT_TRUE(screen->press_from_afar(session, "Left", false));
  both();
  EXPECT_EQ(screen->for_audience().read().rgba, frozen.rgba);
}

TEST_F(SpeakerTest, CountsWhatIsForThisClass) {
  both();
  const Image all = speaker->read();
  session.leave_out("two", true);
  both();
  EXPECT_GT(differing(all, speaker->read(), 0, 400, 760, 800), 100) << "the count, and the outline";
  EXPECT_EQ(session.next_place(), (StepPlace{0, 1}));
  session.go_to({0, 1});
  EXPECT_EQ(session.next_place(), std::nullopt);
}

TEST_F(SpeakerTest, IsToldWhatTheAudienceIsNot) {
  both();
  const Image audience = screen->read();
  screen->press_from_afar(session, "2", false);
  both();
  EXPECT_EQ(screen->read().rgba, audience.rgba) << "a number that is being typed";
  screen->press_from_afar(session, "Enter", false);
  EXPECT_EQ(session.place(), (StepPlace{1, 0}));
}

// 2026-11-28: what was told lay over the page, and the list of stages had three rows and a half.
TEST_F(SpeakerTest, WhatIsToldLeavesThePageAndTheListHasRows) {
  both();
  screen->press_from_afar(session, "2", false);
  ImGui::SetCurrentContext(screen->imgui());
  frame();
  ImGui::SetCurrentContext(speaker->imgui());
  constexpr float kRows = 8;
  for (const Size size : {Size{1278, 760}, Size{1280, 800}, Size{960, 800}, Size{683, 768}}) {
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(speaker->draw(session, {.size = size, .scale = 1, .seconds = 0.02}));
    const ImGuiWindow *told = ImGui::FindWindowByName("strip"), *walk = ImGui::FindWindowByName("walk"),
                      *list = ImGui::FindWindowByName("outline");
    ASSERT_TRUE(told != nullptr && told->Active && walk != nullptr && list != nullptr);
    EXPECT_GE(told->Rect().Min.y, walk->Rect().Max.y) << size.width;
    const float row = ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
    EXPECT_GE(list->InnerRect.GetHeight(), kRows * row) << size.width;
  }
}

TEST_F(SpeakerTest, CountsTheTime) {
  const double before_s = speaker->elapsed_s();
  both(50);
  EXPECT_NEAR(speaker->elapsed_s() - before_s, 1, 1e-9);
  EXPECT_LE(speaker->seconds_to_wake(), 1);
  EXPECT_GT(speaker->seconds_to_wake(), 0);
}

// 2026-11-28: "changed by hand, undo, back" stood on the audience's page.
TEST_F(SpeakerTest, HasTheChipOfAChangeAndTheAudienceHasNot) {
  const auto is_shown = [](ImGuiContext* imgui) {
    ImGui::SetCurrentContext(imgui);
    const ImGuiWindow* chip = ImGui::FindWindowByName("changed-scene");
    return chip != nullptr && chip->Active;
  };
  for (bool more = true; more && !session.has_scene(); more = session.next_step()) {
  }
  ASSERT_TRUE(session.has_scene());
  both();
  EXPECT_FALSE(is_shown(speaker->imgui()));
  SceneEdits edits = session.edits();
  edits.w0_B = Vec3(1, 2, 3);
  ASSERT_TRUE(session.set_edits(edits));
  both();
  EXPECT_TRUE(is_shown(speaker->imgui()));
  EXPECT_FALSE(is_shown(screen->imgui()));
  session.set_speaker(false);
  ImGui::SetCurrentContext(screen->imgui());
  frame(3);
  EXPECT_FALSE(is_shown(screen->imgui())) << "nor while the page is alone";
  session.set_presenting(false);
  frame(3);
  EXPECT_TRUE(is_shown(screen->imgui()));
}

}  // namespace
}  // namespace polhode
