// SPDX-License-Identifier: MIT
// GLFW's keys by the names that app/session/command.h uses.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// "Right", "Shift+Tab", "Ctrl+S"; empty for keys that make a character (that comes as one), and for unknown
/// ones.
/// `letter`: what the keyboard's layout has on the key, for Ctrl with letters.
std::string key_name(int key, int modifiers, std::string_view letter = {});
/// "A" for a and A, "+", "?": as the keyboard has it.
std::string character_name(unsigned code_point);

}  // namespace polhode
