// SPDX-License-Identifier: MIT
// What keyboard and mouse do, on its way from GLFW to commands and controls.
#pragma once

#include "app/window/controls/input_portion.h"

#include <imgui.h>

#include <array>
#include <cfloat>
#include <deque>
#include <functional>
#include <string_view>
#include <utility>

struct GLFWwindow;

namespace polhode {

/// Dear ImGui answers some input one or two frames later.
inline constexpr int kSettlingFrames = 3;

/// What the callbacks reach by the window's user pointer.
struct Input {
  std::deque<InputEvent> waiting{};
  int settling = kSettlingFrames;  ///< frames still to be drawn
  ImGuiContext* imgui = nullptr;   ///< whose window it is
};

/// From now on the window's events wait in `input`, which outlives the window's use.
void listen(GLFWwindow* window, Input& input);

/// Keyboard and mouse as the controls are told of them: as much as they can see in one frame.
class ControlInput {
 public:
  /// A key, by its name, and whether it repeats while it is held; false: it is for the controls.
  using Press = std::function<bool(std::string_view key, bool is_repeated)>;
  ControlInput(GLFWwindow* window, Press press) : window_(window), press_(std::move(press)) {}

  /// With its ImGui context the current one, after the back end has told what it knows, which is where they
  /// are by now.
  void feed(std::deque<InputEvent>& waiting);

 private:
  bool is_command(const InputEvent& event);
  void give(const InputEvent& event);
  void move_to(float x, float y);
  ImVec2 pointer_in_pixels() const;

  GLFWwindow* window_;
  Press press_;
  int wait_ = 0;  ///< frames
  bool is_repeated_ = false;
  ImVec2 pointer_{-FLT_MAX, -FLT_MAX};  // in the window's units, which need not be pixels
  std::array<bool, 5> buttons_{};       // as many as Dear ImGui knows
};

}  // namespace polhode
