// SPDX-License-Identifier: MIT
// Text of others on a terminal: what would steer it is written out instead.
//
// Names in lessons, file names, arguments and manifests may hold anything. Whatever is echoed of them goes
// through here, so that it can neither colour, move or clear what is on the screen, nor turn its reading
// order.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

namespace printable_detail {

struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool is_valid = false;
};

/// The character that `text`, which is not empty, begins with (RFC 3629: no surrogates, no overlong forms).
inline Character first_character(std::string_view text) {
  constexpr std::array<char32_t, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xC0 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (bytes == 0 || lead >= 0xF8 || bytes > text.size()) return {1, lead, false};
  char32_t code = bytes == 1 ? lead : lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {1, lead, false};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[bytes] || code > 0x10FFFF || is_surrogate) return {1, lead, false};
  return {bytes, code, true};
}

/// Controls C0 and C1, DEL, separators of lines, marks and overrides of the writing direction.
inline bool steers(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return first <= code && code <= last; };
  return code < 0x20 || within(0x7F, 0x9F) || code == 0x061C || within(0x200E, 0x200F) ||
         within(0x2028, 0x202E) || within(0x2066, 0x2069) || code == 0xFEFF;
}

inline std::string escape(const Character& character) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = character.is_valid ? "\\u" : "\\x";
  for (int shift = character.is_valid ? 12 : 4; shift >= 0; shift -= 4)
    text += kDigits[(character.code >> static_cast<unsigned>(shift)) & 0xFU];
  return text;
}

inline std::string printable(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Character character = first_character(text.substr(i));
    const bool is_kept = kept.find(text[i]) != kept.npos;
    if (character.is_valid && (is_kept || !steers(character.code)))
      result += text.substr(i, character.bytes);
    else
      result += escape(character);
    i += character.bytes;
  }
  return result;
}

}  // namespace printable_detail

/// A text of several lines: line feeds stay, other controls become \u001b, bytes that are no UTF-8 \xff. JSON
/// that holds no raw control within its strings is still the same JSON.
inline std::string printable(std::string_view text) { return printable_detail::printable(text, "\n"); }

/// A name, or another text that is to be one line: line feeds are written out too.
inline std::string printable_line(std::string_view text) { return printable_detail::printable(text, ""); }

/// A name that is the same after printable_line: it can be copied from where it is shown.
inline bool shows_as_it_is(const std::string& text) { return printable_line(text) == text; }

}  // namespace polhode
