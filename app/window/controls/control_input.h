// SPDX-License-Identifier: MIT
// What keyboard and mouse do, on its way from GLFW to commands and controls.
#pragma once

#include "app/session/lesson_session.h"
#include "app/window/controls/input_portion.h"
#include "app/window/screen.h"

#include <imgui.h>

#include <array>
#include <cfloat>
#include <deque>

struct GLFWwindow;

namespace polhode {

/// Dear ImGui answers some input one or two frames later.
inline constexpr int kSettlingFrames = 3;

/// What the callbacks reach by the window's user pointer.
struct Input {
  std::deque<InputEvent> waiting{};
  int settling = kSettlingFrames;  ///< frames still to be drawn
};

/// From now on the window's events wait in `input`, which outlives the window's use.
void listen(GLFWwindow* window, Input& input);

/// Keyboard and mouse as the controls are told of them: as much as they can see in one frame.
class ControlInput {
 public:
  ControlInput(GLFWwindow* window, LessonSession& session, Screen& screen)
      : window_(window), session_(session), screen_(screen) {}

  /// After the back end has told what it knows, which is where they are by now.
  void feed(std::deque<InputEvent>& waiting);

 private:
  bool is_command(const InputEvent& event);
  void give(const InputEvent& event);
  void move_to(float x, float y);
  ImVec2 pointer_in_pixels() const;

  GLFWwindow* window_;
  LessonSession& session_;
  Screen& screen_;
  int wait_ = 0;  ///< frames
  bool is_repeated_ = false;
  ImVec2 pointer_{-FLT_MAX, -FLT_MAX};  // in the window's units, which need not be pixels
  std::array<bool, 5> buttons_{};       // as many as Dear ImGui knows
};

}  // namespace polhode
