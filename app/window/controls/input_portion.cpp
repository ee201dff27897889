// SPDX-License-Identifier: MIT
#include "app/window/controls/input_portion.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace polhode {

namespace {

bool contains(const std::vector<int>& codes, int code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// Enter, Backspace, arrows ...: no character comes of it.
bool acts(const InputEvent& key) { return key.code >= GLFW_KEY_ESCAPE && key.code < GLFW_KEY_LEFT_SHIFT; }

/// Shift, Ctrl, Alt, Super, left and right.
bool modifies(const InputEvent& key) {
  return key.code >= GLFW_KEY_LEFT_SHIFT && key.code <= GLFW_KEY_RIGHT_SUPER;
}

/// Controls have its character, which comes of its own, and never look at the key: a text that is typed
/// quickly is not slower than its hand. The space bar presses what is chosen.
bool only_types(const InputEvent& key) {
  constexpr int kShortcut = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  return key.code > GLFW_KEY_SPACE && key.code < GLFW_KEY_ESCAPE && (key.modifiers & kShortcut) == 0;
}

}  // namespace

bool InputPortion::takes(const InputEvent& event) const {
  switch (event.kind) {
    case InputEvent::Kind::pointer:
    case InputEvent::Kind::wheel:
      return buttons_.empty();
    case InputEvent::Kind::button:
      return !contains(buttons_, event.code) && !(moved_ && event.action == GLFW_RELEASE);
    case InputEvent::Kind::key:
      if (modifies(event)) return keys_.empty();  // what was pressed with it is seen with it
      return event.action == GLFW_REPEAT || !contains(keys_, event.code);
    case InputEvent::Kind::character:
      return !acted_;
  }
  return true;
}

void InputPortion::add(const InputEvent& event) {
  if (event.kind == InputEvent::Kind::pointer) moved_ = true;
  if (event.kind == InputEvent::Kind::button) buttons_.push_back(event.code);
  if (event.kind != InputEvent::Kind::key) return;
  if (!modifies(event) && !only_types(event)) keys_.push_back(event.code);
  acted_ = acted_ || (event.action != GLFW_RELEASE && acts(event));
}

}  // namespace polhode
