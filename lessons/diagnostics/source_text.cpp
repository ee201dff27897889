// SPDX-License-Identifier: MIT
#include "lessons/diagnostics/source_text.h"

#include "base/utf8.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

std::string hex_byte(unsigned char byte) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  return {'0', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
}

bool is_forbidden_control(std::string_view bytes, std::size_t i) {
  const auto byte = static_cast<unsigned char>(bytes[i]);
  if (byte == '\r') return i + 1 >= bytes.size() || bytes[i + 1] != '\n';
  const bool is_c1 =
      byte == 0xC2U && i + 1 < bytes.size() && static_cast<unsigned char>(bytes[i + 1]) < 0xA0U;
  return (byte < 0x20U && byte != '\n' && byte != '\t') || byte == 0x7FU || is_c1;
}

}  // namespace

SourceText::SourceText(std::string_view text) : text_(text), begins_{0} {
  begins_.reserve(1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
  for (std::size_t end = 0; (end = text.find('\n', end)) != text.npos;) begins_.push_back(++end);
}

std::string_view SourceText::line(int line) const { return lines(line, line); }

std::string_view SourceText::lines(int first, int last) const {
  if (last < first) return text_.substr(first > line_count() ? text_.size() : begin_of(first), 0);
  const std::size_t begin = begin_of(first);
  std::size_t end = last < line_count() ? begin_of(last + 1) - 1 : text_.size();
  if (end > begin && text_[end - 1] == '\r') --end;
  return text_.substr(begin, end - begin);
}

int SourceText::line_of(std::size_t offset) const {
  return static_cast<int>(std::upper_bound(begins_.begin(), begins_.end(), offset) - begins_.begin());
}

SourcePlace SourceText::place_of(std::size_t offset) const {
  const int line = line_of(offset);
  return {line, 1 + count_characters(text_.substr(begin_of(line), offset - begin_of(line)))};
}

std::size_t SourceText::offset_of(SourcePlace place) const {
  if (place.line < 1) return 0;
  const int number = std::min(place.line, line_count());
  const std::string_view text = line(number);
  if (place.line > number) return begin_of(number) + text.size();
  std::size_t at = 0;
  for (int column = 1; column < place.column && at < text.size(); ++column) {
    ++at;
    while (at < text.size() && !starts_character(text[at])) ++at;
  }
  return begin_of(number) + at;
}

SourcePlace SourceText::clamp(SourcePlace place) const {
  if (place.line < 1) return {1, 1};
  const int last = std::min(place.line, line_count());
  const int width = count_characters(line(last)) + 1;
  return {last, place.line > line_count() ? width : std::clamp(place.column, 1, width)};
}

SourcePlace advanced(SourcePlace start, std::string_view line, std::size_t offset) {
  return {start.line, start.column + count_characters(line.substr(0, offset))};
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return text.substr(0, 0);
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

std::optional<NotText> why_not_text(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    if ((bytes[i] >= ' ' && bytes[i] < 0x7F) || bytes[i] == '\n') {  // nearly all of a text
      ++i;
      continue;
    }
    const std::size_t begin = i;
    const char32_t character = next_character(bytes, i);
    const auto byte = [&] { return hex_byte(static_cast<unsigned char>(bytes[begin])); };
    if (character == kMalformed) {
      return NotText{begin, "this is not UTF-8 text: no character starts with the byte " + byte() + " here",
                     "save the lesson as UTF-8"};
    }
    if (is_forbidden_control(bytes, begin)) {
      const std::string code = character < 0x80 ? byte() : hex_byte(static_cast<unsigned char>(character));
      return NotText{begin, "this is not a text file: control character " + code,
                     "a lesson is UTF-8 text with tabs and line feeds only"};
    }
  }
  return std::nullopt;
}

bool is_plain_line(std::string_view utf8) {
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = [&](std::size_t ahead) {
      return i + ahead < utf8.size() ? static_cast<unsigned char>(utf8[i + ahead]) : 0U;
    };
    if (byte(0) < 0x20 || byte(0) == 0x7F) return false;
    if (byte(0) == 0xC2 && byte(1) < 0xA0) return false;
    if (byte(0) != 0xE2) continue;
    if (byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) return false;
    if (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9) return false;
  }
  return true;
}

}  // namespace polhode
