// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <algorithm>
#include <array>

namespace polhode {

char32_t next_character(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  const std::size_t begin = at++;
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  if (first < 0xC2 || first > 0xF4) return kMalformed;
  if (begin + static_cast<std::size_t>(more) >= text.size()) return kMalformed;
  char32_t c = first & (0x3FU >> more);
  for (int i = 1; i <= more; ++i) {
    const unsigned next = byte(begin + static_cast<std::size_t>(i));
    if ((next & 0xC0U) != 0x80U) return kMalformed;
    c = (c << 6) | (next & 0x3FU);
  }
  constexpr std::array<char32_t, 4> kSmallest = {0, 0x80, 0x800, 0x10000};
  const bool surrogate = 0xD800 <= c && c <= 0xDFFF;
  if (c < kSmallest[static_cast<std::size_t>(more)] || c > 0x10FFFF || surrogate) return kMalformed;
  at = begin + 1 + static_cast<std::size_t>(more);
  return c;
}

void append_utf8(std::string& text, char32_t c) {
  const auto put = [&text](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xC0 | (c >> 6));
  } else {
    if (c < 0x10000) {
      put(0xE0 | (c >> 12));
    } else {
      put(0xF0 | (c >> 18));
      put(0x80 | ((c >> 12) & 0x3F));
    }
    put(0x80 | ((c >> 6) & 0x3F));
  }
  put(0x80 | (c & 0x3F));
}

int count_characters(std::string_view utf8) {
  return static_cast<int>(std::count_if(utf8.begin(), utf8.end(), starts_character));
}

std::u32string code_points(std::string_view utf8) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::u32string text;
  for (std::size_t i = 0; i < utf8.size();) {
    const char32_t character = next_character(utf8, i);
    text += character == kMalformed ? kReplacement : character;
  }
  return text;
}

}  // namespace polhode
