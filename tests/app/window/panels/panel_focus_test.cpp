// SPDX-License-Identifier: MIT
// What of a panel has the keyboard when it was opened by a key, and where it goes.
#include "tests/app/window/screen_harness.h"

#include <imgui_internal.h>

#include <set>

namespace polhode {
namespace {

class PanelFocus : public ScreenTest {
 protected:
  static ImGuiID focused() { return ImGui::GetCurrentContext()->NavId; }
  static bool is_ring_seen() { return ImGui::GetIO().NavVisible; }
};

// 2026-11-26: the first focus was not seen, and a panel opened again had it on what closes, so that Space
// closed it.
TEST_F(PanelFocus, BeginsOnAControlThatIsSeenAndClosesNothing) {
  for (const char* key : {"O", "B", "M", "S", "E", "F2"}) {
    for (int times = 0; times < 2; ++times) {
      frame(2);
      screen->press(session, key);
      frame(5);
      const Panel opened = session.panel;
      ASSERT_NE(opened, Panel::none);
      EXPECT_NE(focused(), 0U) << key;
      EXPECT_TRUE(is_ring_seen()) << key;
      if (std::string_view(key) == "B" || std::string_view(key) == "O") {
        give_to_panel(ImGuiKey_Space);
        frame(2);
        EXPECT_EQ(session.panel, opened) << key;
        give_to_panel(ImGuiKey_Escape);  // of what Space opened
        frame(2);
      }
      while (session.panel != Panel::none) {
        screen->press(session, "Escape");
        frame(3);
      }
    }
  }
}

// 2026-11-27: the table of keys could not be read by keys: arrows did nothing, and Space closed it. There is
// nothing to choose in it: what moves scrolls, the other keys are the page's.
TEST_F(PanelFocus, TheTableOfKeysIsScrolledByKeys) {
  session.go_to({1, 0});
  frame(2);
  screen->press(session, "?");
  frame(5);
  ASSERT_EQ(session.panel, Panel::help);
  EXPECT_FALSE(is_ring_seen());
  const Image head = screen->read();
  for (const int key : {int{ImGuiKey_DownArrow}, int{ImGuiKey_PageDown}, int{ImGuiKey_End}}) {
    const Image before = screen->read();
    give_to_panel(static_cast<ImGuiKey>(key));
    EXPECT_NE(screen->read().rgba, before.rgba) << key;
  }
  give_to_panel(ImGuiKey_Home);
  EXPECT_EQ(screen->read().rgba, head.rgba);
  EXPECT_FALSE(is_ring_seen());
  for (const char* key : {"Down", "Up", "PageDown", "PageUp", "Home", "End"})
    EXPECT_FALSE(screen->press(session, key)) << key;
  EXPECT_TRUE(screen->press(session, "Right"));
  EXPECT_EQ(session.place(), (StepPlace{1, 1}));
  EXPECT_TRUE(screen->press(session, "Space"));
  EXPECT_TRUE(session.is_playing());
  EXPECT_EQ(session.panel, Panel::help);
}

TEST_F(PanelFocus, IsShownByTheKeyThatGivesItToThePanel) {
  screen->press(session, "B");
  frame(5);
  click(300, 400);  // on the page
  frame(2);
  screen->press(session, "F6");
  frame(4);
  EXPECT_NE(focused(), 0U);
  EXPECT_TRUE(is_ring_seen());
}

// 2026-11-26: Tab went from the first slider to the second and no further.
TEST_F(PanelFocus, TabGoesThroughAllControlsAsOneReads) {
  screen->press(session, "B");
  frame(5);
  std::vector<ImGuiID> order = {focused()};
  for (int i = 0; i < 6; ++i) {  // the body, three moments, three components of ω
    EXPECT_TRUE(screen->press(session, "Tab"));
    frame(4);
    order.push_back(focused());
  }
  EXPECT_EQ(std::set<ImGuiID>(order.begin(), order.end()).size(), 7U);
  EXPECT_TRUE(session.edits().empty()) << "nothing is changed by it";
  screen->press(session, "Shift+Tab");
  frame(4);
  EXPECT_EQ(focused(), order[5]);
}

// 2026-11-28: both were dead in a field that is typed in.
TEST_F(PanelFocus, TabLeavesAFieldThatIsTypedInAndComesBack) {
  const auto types = [] { return ImGui::GetIO().WantTextInput; };
  const auto expect_round = [&](const std::string& what) {
    frame(5);
    ASSERT_TRUE(types()) << what;
    const ImGuiID field = focused();
    ImGui::GetIO().AddInputCharacter('2');
    frame(2);
    for (const auto& [away, back] : {std::pair("Tab", "Shift+Tab"), std::pair("Shift+Tab", "Tab")}) {
      ASSERT_TRUE(screen->press(session, away)) << what;
      frame(7);
      EXPECT_FALSE(types()) << what << ' ' << away;
      EXPECT_NE(focused(), field) << what << ' ' << away;
      EXPECT_TRUE(is_ring_seen()) << what << ' ' << away;
      if (what == "find" && back == std::string_view("Tab")) break;  // the list below it is endless
      // From the last one Tab goes over the first.
      for (int i = 0; i == 0 || (i < 2 && back == std::string_view("Tab") && focused() != field); ++i) {
        ASSERT_TRUE(screen->press(session, back)) << what;
        frame(7);
      }
      EXPECT_TRUE(types()) << what << ' ' << back;
      EXPECT_EQ(focused(), field) << what << ' ' << back;
    }
    screen->press(session, "Escape");
    frame(3);
    EXPECT_FALSE(types());
    session.panel = Panel::none;
    frame(3);
  };
  screen->press(session, "Ctrl+F");
  expect_round("find");
  for (const Ask::Type type : {Ask::Type::expression, Ask::Type::number, Ask::Type::derive}) {
    const auto& stages = session.lesson().stages;
    bool is_there = false;
    for (std::size_t stage = 0; stage < stages.size() && !is_there; ++stage)
      for (std::size_t step = 0; step < stages[stage].steps.size() && !is_there; ++step) {
        const auto asks = blocks_of<Ask>(stages[stage].steps[step]);
        is_there = asks.size() == 1 && asks.front()->type == type;
        if (is_there) session.go_to({stage, step});
      }
    ASSERT_TRUE(is_there);
    frame(2);
    screen->press(session, "Q");
    expect_round("question " + std::to_string(static_cast<int>(type)));
  }
}

// 2026-11-28: what a panel says of a body that cannot be stayed when the change before was undone.
TEST_F(PanelFocus, AReproachGoesWithWhatItIsAbout) {
  session.go_to({1, 0});
  screen->press(session, "B");
  frame(5);
  screen->press(session, "Tab");
  frame(5);
  screen->press(session, "Tab");  // to the second moment
  frame(5);
  const ImGuiID slider = focused();
  const auto below_sliders = [&] {
    const Image shown = screen->read();
    const int x0 = kSize.width - static_cast<int>(control_sizes(1).panel) + 12;
    std::vector<unsigned char> bytes;
    for (int row = 215; row < 420; ++row)
      bytes.insert(bytes.end(), shown.pixel(x0, row), shown.pixel(x0, row) + 4 * 150);
    return bytes;
  };
  const auto without = below_sliders();
  const Vec3 moments = session.model()->scene.body.moments.vector();
  const auto type = [&](const std::string& text) {
    give_to_panel(ImGuiKey_Enter);
    frame(3);
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frame(3);
    give_to_panel(ImGuiKey_Enter);
    frame(4);
  };
  session.begin_change();
  SceneEdits edits = session.edits();
  edits.body = body_with_moments(Vec3(moments[0], moments[1] * 1.01, moments[2])).value();
  ASSERT_TRUE(session.set_edits(edits));
  frame(3);
  type("99999");
  EXPECT_NE(below_sliders(), without) << "it says why";
  EXPECT_EQ(focused(), slider);
  ASSERT_TRUE(screen->press(session, "Ctrl+Z"));
  frame(4);
  EXPECT_EQ(session.model()->scene.body.moments.vector(), moments);
  EXPECT_EQ(below_sliders(), without);
}

}  // namespace
}  // namespace polhode
