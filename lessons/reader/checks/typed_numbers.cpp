// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/typed_numbers.h"

#include "base/numbers.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

struct FoundNumber {
  std::size_t offset = 0, size = 0;  ///< in the text, without the unit
};

/// "5 kJ", "27°" in plain text.
std::vector<FoundNumber> numbers_with_units(const std::string& text) {
  std::vector<FoundNumber> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i])) continue;
    const std::size_t begin = i;
    std::size_t point = text.npos;
    while (i < text.size() && (is_digit(text[i]) || (text[i] == '.' && point == text.npos &&
                                                     i + 1 < text.size() && is_digit(text[i + 1])))) {
      if (text[i] == '.') point = i;
      ++i;
    }
    const bool is_part = begin > 0 && (is_letter(text[begin - 1]) || text[begin - 1] == '.' ||
                                       text[begin - 1] == '^' || text[begin - 1] == '_');
    const auto value = parse_number(text.substr(begin, i - begin));
    if (is_part || !value || unit_behind(std::string_view(text).substr(i)).empty()) continue;
    found.push_back({begin, i - begin});
  }
  return found;
}

}  // namespace

std::vector<TextSpan> with_numbers_apart(const std::vector<TextSpan>& line) {
  std::vector<TextSpan> apart;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].kind == TextSpan::Kind::math) {
      apart.push_back(line[i]);
      continue;
    }
    // A blank that no line breaks at is a stretch of its own.
    std::string words;
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (; i < line.size() && line[i].kind == TextSpan::Kind::text; ++i) {
      places.emplace_back(words.size(), line[i].source.begin);
      words += line[i].code ? std::string(line[i].text.size(), '-') : line[i].text;
      if (line[i].break_after) words += '\n';
    }
    --i;
    std::size_t begin = 0;
    for (const FoundNumber& one : numbers_with_units(words)) {
      const auto next = std::find_if(places.begin(), places.end(),
                                     [&](const auto& place) { return place.first > one.offset; });
      apart.emplace_back().text = words.substr(begin, one.offset - begin);
      TextSpan& number = apart.emplace_back();
      number.kind = TextSpan::Kind::math;
      number.text = words.substr(one.offset, one.size);
      if (auto math = parse_math(number.text)) number.math = std::move(*math);
      number.source.begin =
          static_cast<std::uint32_t>(std::prev(next)->second + one.offset - std::prev(next)->first);
      begin = one.offset + one.size;
    }
    apart.emplace_back().text = words.substr(begin);
  }
  return apart;
}

std::optional<TypedNumber> number_in_cell(const TextTable::Cell& cell) {
  const std::vector<TextSpan> apart = with_numbers_apart(cell);
  std::optional<TypedNumber> number;
  std::string words;
  for (const TextSpan& span : apart) {
    if (span.kind == TextSpan::Kind::text) {
      words += span.text;
    } else if (number || !(number = read_typed(span.math))) {
      return std::nullopt;
    }
  }
  std::string_view unit = without_blanks(words);
  if (number && number->unit.empty()) number->unit = whole_unit(unit);
  return number && (unit.empty() || !whole_unit(unit).empty()) ? number : std::nullopt;
}

}  // namespace polhode
