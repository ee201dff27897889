// SPDX-License-Identifier: MIT
// A screen drawn off-screen, and a hand that uses it.
#pragma once

#include "app/window/screen/screen.h"
#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <memory>
#include <stdexcept>

namespace polhode {

inline constexpr Size kSize{1280, 800};

inline const GlContext& context() {
  static const std::unique_ptr<GlContext> kContext = [] {
    auto opened = open_context(ContextKind::any);
    if (!opened) throw std::runtime_error(opened.error());
    return std::move(opened).value();
  }();
  return *kContext;
}

inline const Fonts& fonts() {
  static const Fonts kFonts = Fonts::open().value();
  return kFonts;
}

/// A screen and a hand.
class ScreenTest : public testing::Test {
 protected:
  ScreenTest() {
    auto made = Screen::create(context(), fonts());
    if (!made) throw std::runtime_error(made.error());
    screen = std::move(made).value();
    session.preferences.reduced_motion = true;
  }

  void frame(int count = 1) {
    for (int i = 0; i < count; ++i) {
      ImGui::GetIO().MousePos = {x, y};
      ImGui::GetIO().MouseDown[0] = down;
      const Status drawn = screen->draw(session, {.size = kSize, .scale = 1, .seconds = 0.02});
      ASSERT_TRUE(drawn) << drawn.error();
    }
  }
  void move(double to_x, double to_y) {
    x = static_cast<float>(to_x);
    y = static_cast<float>(to_y);
    frame(2);
  }
  void click(double at_x, double at_y) {
    move(at_x, at_y);
    down = true;
    frame(2);
    down = false;
    frame(3);
  }
  void drag(double from_x, double from_y, double to_x, double to_y) {
    move(from_x, from_y);
    down = true;
    frame(2);
    for (int i = 1; i <= 5; ++i) move(from_x + i * (to_x - from_x) / 5, from_y + i * (to_y - from_y) / 5);
    down = false;
    frame(3);
  }
  /// What press() leaves to a panel.
  void give_to_panel(ImGuiKey key) {
    const auto tell = [&](bool is_down) {
#if IMGUI_VERSION_NUM < 18700
      ImGui::GetIO().KeysDown[key] = is_down;
#else
      ImGui::GetIO().AddKeyEvent(key, is_down);
#endif
      frame(2);
    };
    tell(true);
    tell(false);
  }
  void hold_shift(bool is_held) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeyShift = is_held;
#else
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, is_held);
#endif
  }
  const PixelRect& figure() { return screen->page().insets().front().place; }

  std::unique_ptr<Screen> screen;
  LessonSession session{test::loaded_lesson("euler-equations")};
  float x = -1, y = -1;
  bool down = false;
};

}  // namespace polhode
