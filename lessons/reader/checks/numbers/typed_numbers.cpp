// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/numbers/typed_numbers.h"

#include "base/ascii.h"
#include "base/numbers.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

struct FoundNumber {
  std::size_t offset = 0, size = 0;  ///< in the text, without the unit
  std::string tex;
};

/// "·10³", "× 10^-3", "e3" behind a number, as TeX; the text is cut by it.
std::string take_power(std::string_view& text) {
  std::string_view rest = text;
  if (rest.size() > 1 && (rest.front() == 'e' || rest.front() == 'E') &&
      (is_digit(rest[1]) || (rest.size() > 2 && rest[1] == '-' && is_digit(rest[2])))) {
    std::size_t end = 2;
    while (end < rest.size() && is_digit(rest[end])) ++end;
    text = rest.substr(end);
    return "\\cdot10^{" + std::string(rest.substr(1, end - 1)) + '}';
  }
  rest = without_blanks(rest);
  const auto take = [&](std::initializer_list<std::string_view> signs) {
    for (const std::string_view sign : signs)
      if (rest.starts_with(sign)) return rest.remove_prefix(sign.size()), true;
    return false;
  };
  if (!take({"·", "×", "⋅", "*"})) return "";
  rest = without_blanks(rest);
  if (!take({"10"})) return "";
  std::string power = take({"⁻", "^-", "^−"}) ? "-" : "";
  take({"^"});
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  for (bool has_more = true; has_more;) {
    has_more = false;
    for (std::size_t digit = 0; digit < kRaised.size(); ++digit)
      if (rest.starts_with(kRaised[digit]) || (!rest.empty() && rest[0] == static_cast<char>('0' + digit))) {
        rest.remove_prefix(is_digit(rest[0]) ? 1 : kRaised[digit].size());
        power += static_cast<char>('0' + digit);
        has_more = true;
        break;
      }
  }
  if (power.empty() || power == "-") return "";
  text = rest;
  return "\\cdot10^{" + power + '}';
}

/// "−" or "-" directly before a number, and nothing before that but a blank or a bracket.
std::size_t size_of_sign(std::string_view before) {
  for (const std::string_view sign : {"−", "-"}) {
    if (!before.ends_with(sign)) continue;
    const std::string_view rest = before.substr(0, before.size() - sign.size());
    if (rest.empty() || std::string_view(" \n(").find(rest.back()) != rest.npos) return sign.size();
  }
  return 0;
}

/// "is 5." and not "is 5 times": a verb before a number that ends its clause. `is_end`: nothing stands behind
/// the text.
bool is_said_alone(std::string_view before, std::string_view behind, bool is_end) {
  constexpr std::array<std::string_view, 9> kVerbs{"is",    "are",    "was",     "equals", "than",
                                                   "about", "nearly", "exactly", "only"};
  before = without_blanks(before.substr(0, before.size() - size_of_sign(before)));
  const std::string_view word = before.substr(before.find_last_of(" \n") + 1);
  const bool ends = behind.empty() ? is_end
                                   : std::string_view(".,;:!)").find(behind.front()) != behind.npos &&
                                         (behind.size() == 1 || !is_digit(behind[1]));
  return ends && std::find(kVerbs.begin(), kVerbs.end(), word) != kVerbs.end();
}

/// The word before a place, without the blanks between.
std::string_view word_before(std::string_view text) {
  text = without_blanks(text);
  return text.substr(text.find_last_of(" \n") + 1);
}

/// ",000" behind up to three digits.
bool begins_group(std::string_view text, std::size_t digits_before) {
  const auto digit_at = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
  return digits_before <= 3 && text.starts_with(',') && digit_at(1) && digit_at(2) && digit_at(3) &&
         !digit_at(4);
}

/// "5 kJ", "27°", "−2.5·10³ J" in plain text, and "is 5.".
std::vector<FoundNumber> numbers_in(const std::string& text, bool is_end) {
  std::vector<FoundNumber> found;
  const std::string_view all(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i])) continue;
    const std::size_t begin = i;
    std::size_t point = text.npos;
    std::string digits;
    while (i < text.size() && (is_digit(text[i]) || (text[i] == '.' && point == text.npos &&
                                                     i + 1 < text.size() && is_digit(text[i + 1])))) {
      if (text[i] == '.') point = i;
      digits += text[i++];
      if (point == text.npos && begins_group(all.substr(i), i - begin)) ++i;  // 5,000
    }
    const bool is_part = begin > 0 && (is_letter(text[begin - 1]) || text[begin - 1] == '.' ||
                                       text[begin - 1] == '^' || text[begin - 1] == '_');
    std::string_view behind = all.substr(i);
    const std::string power = take_power(behind);
    // "between 2 and 3"
    const std::size_t sign = size_of_sign(all.substr(0, begin));
    const std::string_view before = all.substr(0, begin - sign);
    const bool begins_range = word_before(before) == "between" && without_blanks(behind).starts_with("and ");
    const std::size_t end_of_last = found.empty() ? 0 : found.back().offset + found.back().size;
    const bool ends_range = !found.empty() && word_before(all.substr(0, found.back().offset)) == "between" &&
                            without_blanks(before.substr(std::min(end_of_last, before.size()))) == "and";
    if (is_part || !parse_number(digits) ||
        (unit_behind(behind).empty() && !begins_range && !ends_range &&
         !is_said_alone(all.substr(0, begin), behind, is_end)))
      continue;
    found.push_back(
        {begin - sign, all.size() - behind.size() - begin + sign, (sign > 0 ? "-" : "") + digits + power});
    i = all.size() - behind.size();
    if (i > 0) --i;
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
    for (const FoundNumber& one : numbers_in(words, i + 1 == line.size())) {
      const auto next = std::find_if(places.begin(), places.end(),
                                     [&](const auto& place) { return place.first > one.offset; });
      apart.emplace_back().text = words.substr(begin, one.offset - begin);
      TextSpan& number = apart.emplace_back();
      number.kind = TextSpan::Kind::math;
      number.text = one.tex;
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
  if (cell.size() == 1 && cell.front().kind == TextSpan::Kind::text) {
    const std::string text(without_blanks(cell.front().text));
    if (parse_number(text)) {
      const auto math = parse_math(text);
      return math ? read_typed(*math) : std::nullopt;
    }
  }
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
