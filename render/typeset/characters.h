// SPDX-License-Identifier: MIT
// What typesetting asks of characters: which of them part words, and which cannot be set.
#pragma once

#include "base/utf8.h"

#include <string>
#include <string_view>

namespace polhode {

/// Blank, tab and ends of lines: what parts words of a source.
constexpr bool is_space(char32_t c) { return c == U' ' || c == U'\t' || c == U'\n' || c == U'\r'; }

/// Letters of scripts written from right to left, and marks that turn the direction.
bool is_right_to_left(char32_t character);

/// Neither ink nor space: controls, zero-width characters, byte order marks.
bool is_invisible(char32_t character);

/// A small character above or below the line, as it stands on the line: 6 of ⁶, the minus sign of ⁻. Fonts
/// have ¹²³ at most.
struct Script {
  char32_t character = 0;  ///< 0: it is none
  bool raised = false;
};
Script script_of(char32_t character);

/// A straight quotation mark as it is set: it opens after a space, a bracket, a dash or a mark that opens,
/// and closes after anything else. What is no such mark stays.
char32_t curled(char32_t mark, char32_t before);
/// All of a text, which begins a line.
std::string curled(std::string_view text);

/// "U+05D0"
std::string code_point_name(char32_t character);

}  // namespace polhode
