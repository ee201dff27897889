// SPDX-License-Identifier: MIT
#include "app/window/controls/control_input.h"

#include "app/window/controls/key_names.h"
#include "render/image/image.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <cfloat>

namespace polhode {

namespace {

Input& input_of(GLFWwindow* window) {
  Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
  input.settling = kSettlingFrames;
  return input;
}

// From version 1.87 on Dear ImGui is told of events, which it adopts in the order of their telling, and what
// is written into its io is overruled by the back end's. Until then its io is what it looks at.
#if IMGUI_VERSION_NUM < 18700

void tell_mouse(const ImVec2& pointer, const std::array<bool, 5>& buttons) {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = pointer;
  std::copy(buttons.begin(), buttons.end(), io.MouseDown);
}

/// The back end has them from the keys it was told of.
void tell_modifiers(const InputEvent&) {}

#else

void tell_mouse(const ImVec2& pointer, const std::array<bool, 5>& buttons) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddMousePosEvent(pointer.x, pointer.y);
  for (std::size_t i = 0; i < buttons.size(); ++i) io.AddMouseButtonEvent(static_cast<int>(i), buttons[i]);
}

/// The back end asks which of Shift and the like are held now; what counts is which were when the key was
/// pressed. Of one of them itself the event says what was held before.
void tell_modifiers(const InputEvent& key) {
  struct Modifier {
    int mask, left, right;
    ImGuiKey name;
  };
  static constexpr std::array<Modifier, 4> kModifiers = {
      {{GLFW_MOD_CONTROL, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, ImGuiMod_Ctrl},
       {GLFW_MOD_SHIFT, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, ImGuiMod_Shift},
       {GLFW_MOD_ALT, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, ImGuiMod_Alt},
       {GLFW_MOD_SUPER, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER, ImGuiMod_Super}}};
  for (const Modifier& modifier : kModifiers) {
    const bool itself = key.code == modifier.left || key.code == modifier.right;
    ImGui::GetIO().AddKeyEvent(modifier.name,
                               itself ? key.action != GLFW_RELEASE : (key.modifiers & modifier.mask) != 0);
  }
}

#endif

/// From a control into its field, or to the next.
bool leads_on(const InputEvent& event) {
  return event.kind == InputEvent::Kind::key && event.action == GLFW_PRESS &&
         (event.code == GLFW_KEY_ENTER || event.code == GLFW_KEY_KP_ENTER || event.code == GLFW_KEY_TAB);
}

/// It goes to a place or a time: no focus changes by it.
bool walks(const InputEvent& event) {
  return event.kind == InputEvent::Kind::key && event.code >= GLFW_KEY_RIGHT && event.code <= GLFW_KEY_END;
}

}  // namespace

void listen(GLFWwindow* window, Input& input) {
  glfwSetWindowUserPointer(window, &input);
  using Kind = InputEvent::Kind;
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    std::deque<InputEvent>& waiting = input_of(w).waiting;
    // A key that is held goes on as quickly as pictures are drawn, and ends where it is let go.
    const bool waits_already = action == GLFW_REPEAT && !waiting.empty() &&
                               waiting.back().kind == Kind::key && waiting.back().code == key &&
                               waiting.back().action == GLFW_REPEAT;
    if (!waits_already) waiting.push_back({Kind::key, key, scancode, action, modifiers});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code_point) {
    input_of(w).waiting.push_back({Kind::character, static_cast<int>(code_point)});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    input_of(w).waiting.push_back({Kind::button, button, 0, action, modifiers});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    input_of(w).waiting.push_back({.kind = Kind::wheel, .x = x, .y = y});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    input_of(w).waiting.push_back({.kind = Kind::pointer, .x = x, .y = y});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (!entered) input_of(w).waiting.push_back({.kind = Kind::pointer, .x = -FLT_MAX, .y = -FLT_MAX});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    ImGui::SetCurrentContext(input_of(w).imgui);
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { input_of(w); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { input_of(w); });
}

/// What a command, a click, Enter or Tab opens has the keyboard a few frames later: what is typed behind it
/// waits.
void ControlInput::feed(std::deque<InputEvent>& waiting) {
  InputPortion portion;
  while (wait_ == 0 && !waiting.empty() && portion.takes(waiting.front())) {
    const InputEvent event = waiting.front();
    waiting.pop_front();
    if (is_command(event)) {
      wait_ = walks(event) ? 1 : kSettlingFrames;
      break;
    }
    portion.add(event);
    give(event);
    if (event.kind == InputEvent::Kind::button || leads_on(event)) wait_ = kSettlingFrames;
  }
  wait_ = std::max(0, wait_ - 1);
  tell_mouse(pointer_in_pixels(), buttons_);
}

bool ControlInput::is_command(const InputEvent& event) {
  std::string name;
  if (event.kind == InputEvent::Kind::character) name = character_name(static_cast<unsigned>(event.code));
  if (event.kind == InputEvent::Kind::key && event.action != GLFW_RELEASE) {
    is_repeated_ = event.action == GLFW_REPEAT;  // of its character too, which comes next
    const char* letter = glfwGetKeyName(event.code, event.scancode);
    name = key_name(event.code, event.modifiers, letter ? letter : "");
  }
  return !name.empty() && press_(name, is_repeated_);
}

void ControlInput::give(const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::pointer:
      move_to(static_cast<float>(event.x), static_cast<float>(event.y));
      break;
    case InputEvent::Kind::wheel:
      ImGui_ImplGlfw_ScrollCallback(window_, event.x, event.y);
      break;
    case InputEvent::Kind::button:
      if (event.code >= 0 && event.code < static_cast<int>(buttons_.size()))
        buttons_[static_cast<std::size_t>(event.code)] = event.action == GLFW_PRESS;
      break;
    case InputEvent::Kind::key:
      ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode, event.action, event.modifiers);
      tell_modifiers(event);
      break;
    case InputEvent::Kind::character:
      ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned>(event.code));
      break;
  }
}

/// A hand that holds something does not let go of it where the window ends.
void ControlInput::move_to(float x, float y) {
  const bool is_out = x == -FLT_MAX;
  const bool holds = std::find(buttons_.begin(), buttons_.end(), true) != buttons_.end();
  if (!is_out || !holds) pointer_ = {x, y};
}

ImVec2 ControlInput::pointer_in_pixels() const {
  Size pixels, units;
  glfwGetFramebufferSize(window_, &pixels.width, &pixels.height);
  glfwGetWindowSize(window_, &units.width, &units.height);
  if (!ImGui::IsMousePosValid(&pointer_) || units.width <= 0 || units.height <= 0) return pointer_;
  return {pointer_.x * static_cast<float>(pixels.width) / static_cast<float>(units.width),
          pointer_.y * static_cast<float>(pixels.height) / static_cast<float>(units.height)};
}

}  // namespace polhode
