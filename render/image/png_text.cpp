// SPDX-License-Identifier: MIT
#include "render/image/png_text.h"

#include <cstddef>
#include <cstdint>

namespace polhode {
namespace {

// Decodes one character and moves past it; nothing if it is ill-formed (overlong, surrogate, cut off: RFC
// 3629).
std::optional<char32_t> take(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || length > text.size()) return std::nullopt;
  char32_t c = length == 1 ? first : first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return std::nullopt;
    c = (c << 6) | (byte(i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && c < 0x800) || (length == 4 && c < 0x10000);
  if (overlong || c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) return std::nullopt;
  text.remove_prefix(length);
  return c;
}

}  // namespace

std::optional<std::string> keyword_error(std::string_view keyword) {
  if (keyword.empty() || keyword.size() > 79) return "it must have 1 to 79 characters";
  for (const char c : keyword)
    if (c < ' ' || c > '~') return "only printable ASCII characters are allowed";
  if (keyword.front() == ' ' || keyword.back() == ' ' || keyword.find("  ") != keyword.npos)
    return "spaces must stand alone and inside";
  return std::nullopt;
}

std::optional<std::string> latin1_from_utf8(std::string_view text) {
  std::string latin1;
  while (!text.empty()) {
    const std::optional<char32_t> c = take(text);
    const bool printable = c && ((*c >= 0x20 && *c < 0x7F) || (*c >= 0xA0 && *c <= 0xFF) || *c == '\n');
    if (!printable) return std::nullopt;
    latin1 += static_cast<char>(static_cast<std::uint8_t>(*c));
  }
  return latin1;
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (const char raw : text) {
    const auto c = static_cast<std::uint8_t>(raw);
    if (c < 0x80) {
      utf8 += raw;
    } else {
      utf8 += static_cast<char>(static_cast<std::uint8_t>(0xC0u | (c >> 6)));
      utf8 += static_cast<char>(static_cast<std::uint8_t>(0x80u | (c & 0x3Fu)));
    }
  }
  return utf8;
}

bool is_png_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::optional<char32_t> c = take(text);
    if (!c || *c == 0) return false;
  }
  return true;
}

}  // namespace polhode
