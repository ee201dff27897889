// SPDX-License-Identifier: MIT
// Letters and digits of ASCII, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }
constexpr bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

/// "In part" of "in part": the first letter, if it is one of ASCII.
inline std::string capitalized(std::string_view words) {
  std::string text(words);
  if (!text.empty() && 'a' <= text.front() && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

}  // namespace polhode
