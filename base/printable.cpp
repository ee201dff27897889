// SPDX-License-Identifier: MIT
#include "base/printable.h"

#include "base/utf8.h"

namespace polhode {
namespace {

/// Controls C0 and C1, DEL, separators of lines, marks and overrides of the writing direction.
bool steers(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return first <= code && code <= last; };
  return code < 0x20 || within(0x7F, 0x9F) || code == 0x061C || within(0x200E, 0x200F) ||
         within(0x2028, 0x202E) || within(0x2066, 0x2069) || code == 0xFEFF;
}

/// "\\u001b", "\\xff"
std::string escape(const char* mark, int digits, char32_t code) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = mark;
  for (int i = digits - 1; i >= 0; --i) text += kDigits[(code >> static_cast<unsigned>(4 * i)) & 0xFU];
  return text;
}

std::string printable(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    const char32_t code = next_character(text, i);
    if (code == kMalformed)
      result += escape("\\x", 2, static_cast<unsigned char>(text[begin]));
    else if (steers(code) && kept.find(text[begin]) == kept.npos)
      result += escape("\\u", 4, code);
    else
      result += text.substr(begin, i - begin);
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return printable(text, "\n"); }

std::string printable_line(std::string_view text) { return printable(text, ""); }

bool shows_as_it_is(const std::string& text) { return printable_line(text) == text; }

}  // namespace polhode
