// SPDX-License-Identifier: MIT
#include "render/image/png_text.h"

#include "base/utf8.h"

#include <cstddef>
#include <cstdint>

namespace polhode {

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
  for (std::size_t i = 0; i < text.size();) {
    const char32_t c = next_character(text, i);
    const bool printable = (c >= 0x20 && c < 0x7F) || (c >= 0xA0 && c <= 0xFF) || c == '\n';
    if (!printable) return std::nullopt;
    latin1 += static_cast<char>(static_cast<std::uint8_t>(c));
  }
  return latin1;
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) append_utf8(utf8, static_cast<std::uint8_t>(c));
  return utf8;
}

bool is_png_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();)
    if (const char32_t c = next_character(text, i); c == kMalformed || c == 0) return false;
  return true;
}

}  // namespace polhode
