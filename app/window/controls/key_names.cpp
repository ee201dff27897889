// SPDX-License-Identifier: MIT
#include "app/window/controls/key_names.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <utility>

namespace polhode {

namespace {

constexpr std::array<std::pair<int, const char*>, 17> kNamed = {{{GLFW_KEY_LEFT, "Left"},
                                                                 {GLFW_KEY_RIGHT, "Right"},
                                                                 {GLFW_KEY_UP, "Up"},
                                                                 {GLFW_KEY_DOWN, "Down"},
                                                                 {GLFW_KEY_PAGE_UP, "PageUp"},
                                                                 {GLFW_KEY_PAGE_DOWN, "PageDown"},
                                                                 {GLFW_KEY_HOME, "Home"},
                                                                 {GLFW_KEY_END, "End"},
                                                                 {GLFW_KEY_SPACE, "Space"},
                                                                 {GLFW_KEY_TAB, "Tab"},
                                                                 {GLFW_KEY_ENTER, "Enter"},
                                                                 {GLFW_KEY_KP_ENTER, "Enter"},
                                                                 {GLFW_KEY_ESCAPE, "Escape"},
                                                                 {GLFW_KEY_BACKSPACE, "Backspace"},
                                                                 {GLFW_KEY_DELETE, "Delete"},
                                                                 {GLFW_KEY_INSERT, "Insert"},
                                                                 {GLFW_KEY_MENU, "Menu"}}};

}  // namespace

std::string key_name(int key, int modifiers, std::string_view letter) {
  const std::string ctrl = (modifiers & GLFW_MOD_CONTROL) != 0 ? "Ctrl+" : "";
  const std::string shift = (modifiers & GLFW_MOD_SHIFT) != 0 ? "Shift+" : "";
  for (const auto& [code, name] : kNamed)
    if (code == key) return shift + ctrl + name;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
    return shift + ctrl + "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  // Where a digit takes Shift its key is called otherwise.
  if (!ctrl.empty() && key >= GLFW_KEY_0 && key <= GLFW_KEY_9)
    return shift + ctrl + static_cast<char>('0' + key - GLFW_KEY_0);
  // Without Ctrl the character comes by itself.
  if (!ctrl.empty() && letter.size() == 1)
    return shift + ctrl + character_name(static_cast<unsigned char>(letter[0]));
  return {};
}

std::string character_name(unsigned code_point) {
  if (code_point <= ' ' || code_point > '~') return {};
  const auto character = static_cast<char>(code_point);
  const bool lower = character >= 'a' && character <= 'z';
  return {lower ? static_cast<char>(character - 'a' + 'A') : character};
}

}  // namespace polhode
