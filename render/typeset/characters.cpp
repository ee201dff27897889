// SPDX-License-Identifier: MIT
#include "render/typeset/characters.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

struct Range {
  char32_t first, last;
};

template <std::size_t N>
bool in_any(char32_t c, const std::array<Range, N>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [c](const Range& r) { return r.first <= c && c <= r.last; });
}

}  // namespace

bool is_right_to_left(char32_t c) {
  static constexpr std::array<Range, 9> kRanges = {{{0x0590, 0x08FF},
                                                    {0x200F, 0x200F},
                                                    {0x202B, 0x202B},
                                                    {0x202E, 0x202E},
                                                    {0x2067, 0x2067},
                                                    {0xFB1D, 0xFDFF},
                                                    {0xFE70, 0xFEFE},
                                                    {0x10800, 0x10FFF},
                                                    {0x1E800, 0x1EFFF}}};
  return in_any(c, kRanges);
}

bool is_invisible(char32_t c) {
  static constexpr std::array<Range, 8> kRanges = {{{0x00, 0x08},
                                                    {0x0B, 0x0C},
                                                    {0x0E, 0x1F},
                                                    {0x7F, 0x9F},
                                                    {0xAD, 0xAD},
                                                    {0x200B, 0x200E},
                                                    {0x2028, 0x206F},
                                                    {0xFEFF, 0xFEFF}}};
  return in_any(c, kRanges) && c != 0x202F && c != 0x205F && !is_right_to_left(c);
}

Script script_of(char32_t c) {
  if (0x2080 <= c && c <= 0x2089) return {U'0' + (c - 0x2080), false};
  if (c == 0x2070 || (0x2074 <= c && c <= 0x2079)) return {U'0' + (c - 0x2070), true};
  if (c == 0x00B2 || c == 0x00B3) return {U'2' + (c - 0x00B2), true};
  if (c == 0x00B9) return {U'1', true};
  if (c == 0x207A || c == 0x208A) return {U'+', c == 0x207A};
  if (c == 0x207B || c == 0x208B) return {0x2212, c == 0x207B};
  return {};
}

char32_t curled(char32_t mark, char32_t before) {
  if (mark != U'\'' && mark != U'"') return mark;
  constexpr std::u32string_view kBeforeOpening = U" \n([{\u2013\u2014\u2018\u201C";
  const bool opens = kBeforeOpening.find(before) != std::u32string_view::npos;
  if (mark == U'"') return opens ? 0x201C : 0x201D;
  return opens ? 0x2018 : 0x2019;
}

std::string curled(std::string_view text) {
  std::string set;
  char32_t last = U' ';
  for (std::size_t at = 0; at < text.size();) append_utf8(set, last = curled(next_character(text, at), last));
  return set;
}

std::string code_point_name(char32_t c) {
  std::string digits;
  for (; c > 0 || digits.size() < 4; c >>= 4) digits.insert(digits.begin(), "0123456789ABCDEF"[c & 0xF]);
  return "U+" + digits;
}

}  // namespace polhode
