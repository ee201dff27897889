// SPDX-License-Identifier: MIT
// UTF-8, and the characters that cannot be set.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

inline constexpr char32_t kMalformed = 0xFFFFFFFF;

/// The character at `at` < text.size(); `at` moves behind it. kMalformed for a byte that begins none
/// (overlong forms and surrogates among them); one byte is passed then.
char32_t next_character(std::string_view text, std::size_t& at);

void append_utf8(std::string& text, char32_t character);

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

/// "U+05D0"
std::string code_point_name(char32_t character);

}  // namespace polhode
