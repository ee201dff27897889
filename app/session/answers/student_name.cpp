// SPDX-License-Identifier: MIT
#include "app/session/answers/student_name.h"

#include "base/printable.h"
#include "base/utf8.h"
#include "lessons/diagnostics/source_text.h"
#include "render/typeset/normal_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {
namespace {

using Range = std::pair<char32_t, char32_t>;

bool is_within(char32_t character, const auto& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [character](const Range& range) {
    return range.first <= character && character <= range.second;
  });
}

/// White space of Unicode.
bool is_blank_of_any_kind(char32_t character) {
  constexpr std::array<Range, 9> kBlanks{{{0x09, 0x0D},
                                          {0x20, 0x20},
                                          {0x85, 0x85},
                                          {0xA0, 0xA0},
                                          {0x1680, 0x1680},
                                          {0x2000, 0x200A},
                                          {0x2028, 0x2029},
                                          {0x202F, 0x202F},
                                          {0x205F, 0x205F}}};
  return is_within(character, kBlanks) || character == 0x3000;
}

/// What has no width: joiners, soft hyphens, fillers, variants and tags.
bool has_no_width(char32_t character) {
  constexpr std::array<Range, 15> kUnseen{{{0xAD, 0xAD},
                                           {0x34F, 0x34F},
                                           {0x61C, 0x61C},
                                           {0x115F, 0x1160},
                                           {0x17B4, 0x17B5},
                                           {0x180B, 0x180F},
                                           {0x200B, 0x200F},
                                           {0x202A, 0x202E},
                                           {0x2060, 0x206F},
                                           {0x2800, 0x2800},
                                           {0x3164, 0x3164},
                                           {0xFE00, 0xFE0F},
                                           {0xFEFF, 0xFEFF},
                                           {0xFFA0, 0xFFA0},
                                           {0xE0000, 0xE0FFF}}};
  return is_within(character, kUnseen);
}

/// The Latin letter that a letter of another script, or of full width, looks like; itself if there is none.
char32_t as_it_looks(char32_t character) {
  constexpr std::u32string_view kOthers = U"АВЕЗІЈКМНОРЅТУХаеіјоруѕхсСԛԝһαΑΒΕΖΗΙΚΜΝΟΡΤΥΧονρ";
  constexpr std::u32string_view kLatin = U"ABE3IJKMHOPSTYXaeijopysxcCqwhaABEZHIKMNOPTYXovp";
  static_assert(kOthers.size() == kLatin.size());
  const std::size_t at = kOthers.find(character);
  char32_t letter = at != kOthers.npos ? kLatin[at] : character;
  constexpr char32_t kFirstWide = 0xFF01, kLastWide = 0xFF5E, kFirst = 0x21;
  if (letter >= kFirstWide && letter <= kLastWide) letter -= kFirstWide - kFirst;
  return letter == U'I' || letter == U'|' ? U'l' : letter == U'0' ? U'O' : letter;
}

}  // namespace

bool is_unseen(char32_t character) { return is_blank_of_any_kind(character) || has_no_width(character); }

std::string trimmed_name(std::string_view name) {
  std::size_t begin = name.size(), end = 0;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t from = at;
    if (is_blank_of_any_kind(next_character(name, at))) continue;
    begin = std::min(begin, from);
    end = at;
  }
  return end == 0 ? "" : std::string(name.substr(begin, end - begin));
}

std::string fault_of_name(std::string_view name) {
  const std::string text(name);
  if (!is_plain_line(text) || !shows_as_it_is(text))
    return "a name is one line, without characters that control a screen";
  const std::u32string characters = code_points(name);
  if (characters.size() > static_cast<std::size_t>(kMaxStudentCharacters))
    return fmt::format("a name has at most {} characters", kMaxStudentCharacters);
  const auto found = std::find_if(characters.begin(), characters.end(), has_no_width);
  if (found != characters.end())
    return fmt::format("the name has a character that cannot be seen, U+{:04X} behind \"{}\"",
                       static_cast<unsigned>(*found), [&] {
                         std::string before;
                         for (auto at = characters.begin(); at != found; ++at) append_utf8(before, *at);
                         return before;
                       }());
  return "";
}

std::string comparable_name(std::string_view name) {
  std::string text;
  bool was_blank = false;
  for (const char32_t character : code_points(decomposed(trimmed_name(name)))) {
    const bool is_blank = is_blank_of_any_kind(character);
    if (is_blank && !was_blank) text += ' ';
    if (!is_blank) append_utf8(text, as_it_looks(character));
    was_blank = is_blank;
  }
  return text;
}

}  // namespace polhode
