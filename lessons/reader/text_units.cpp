// SPDX-License-Identifier: MIT
#include "lessons/reader/text_units.h"

#include "lessons/claims/dimension.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {
namespace {

constexpr std::array<std::string_view, 5> kBlanks = {" ", "\n", "\u00A0", "\u2009", "\u202F"};

/// "kJ" of "kilojoules"; other words as they are.
std::string unit_in_short(std::string_view word) {
  using Names = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Names, 10> kUnits{{{"joule", "J"},
                                          {"watt", "W"},
                                          {"newton", "N"},
                                          {"metre", "m"},
                                          {"meter", "m"},
                                          {"second", "s"},
                                          {"gram", "g"},
                                          {"degree", "deg"},
                                          {"radian", "rad"},
                                          {"hertz", "Hz"}}};
  constexpr std::array<Names, 6> kPrefixes{
      {{"", ""}, {"kilo", "k"}, {"milli", "m"}, {"mega", "M"}, {"micro", "µ"}, {"centi", "c"}}};
  for (const auto& [prefix, p] : kPrefixes)
    for (const auto& [unit, u] : kUnits) {
      const std::string name = std::string(prefix) + std::string(unit);
      if (word == name || word == name + 's') return std::string(p) + std::string(u);
    }
  return std::string(word);
}

bool has_letter(std::string_view text) { return std::any_of(text.begin(), text.end(), is_letter); }

}  // namespace

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> signs) {
  return std::any_of(signs.begin(), signs.end(), [&](std::string_view s) { return text.starts_with(s); });
}
bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> signs) {
  return std::any_of(signs.begin(), signs.end(), [&](std::string_view s) { return text.ends_with(s); });
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool take_blank(std::string_view& text) {
  for (const std::string_view blank : kBlanks)
    if (text.starts_with(blank)) return text.remove_prefix(blank.size()), true;
  return false;
}
bool take_last_blank(std::string_view& text) {
  for (const std::string_view blank : kBlanks)
    if (text.ends_with(blank)) return text.remove_suffix(blank.size()), true;
  return false;
}

std::string_view without_blanks(std::string_view text) {
  while (take_blank(text)) {
  }
  while (take_last_blank(text)) {
  }
  return text;
}

std::string unit_at_start(std::string_view text) {
  std::string unit, found;
  for (int words = 0; words < 4 && !text.empty(); ++words) {
    std::size_t end = 0;
    const auto is_blank_at = [&](std::size_t at) {
      std::string_view rest = text.substr(at);
      return take_blank(rest);
    };
    while (end < text.size() && !is_blank_at(end)) ++end;
    std::string_view word = text.substr(0, end);
    bool is_last = false;
    while (!word.empty() && std::string_view(",.;:!?)]\"'").find(word.back()) != std::string_view::npos) {
      word.remove_suffix(1);
      is_last = true;
    }
    if (word == "per" && !unit.empty())
      unit += '/';
    else
      unit += (unit.empty() || unit.back() == '/' ? "" : " ") + unit_in_short(word);
    const bool has_sign =
        std::any_of(unit.begin(), unit.end(), [](char c) { return is_letter(c); }) || unit.starts_with("°");
    if (has_sign && !word.empty() && scaled_unit(unit)) found = unit;
    text.remove_prefix(end);
    if (is_last || !take_blank(text)) break;
  }
  return found;
}

std::string take_unit_at_end(std::string& text) {
  const std::string_view whole = without_blanks(text);
  const auto take = [&](std::size_t end_of_words, std::string_view unit) -> std::string {
    unit = without_blanks(unit);
    if (!has_letter(unit) && unit != "°") return "";
    const std::string read = unit_at_start(unit);
    if (read.empty() || (!scaled_unit(unit) && unit.find(' ') != unit.npos && read.find(' ') == read.npos &&
                         read.find('/') == read.npos))
      return "";
    std::string found = read;
    text.erase(end_of_words);
    return found;
  };
  const auto offset_of = [&](std::size_t at) {
    return static_cast<std::size_t>(whole.data() - text.data()) + at;
  };
  for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')})
    if (!whole.empty() && whole.back() == close) {
      const std::size_t at = whole.rfind(open);
      return at == whole.npos ? "" : take(offset_of(at), whole.substr(at + 1, whole.size() - at - 2));
    }
  for (const std::string_view sign : {", ", " in ", "/ "}) {
    const std::size_t at = whole.rfind(sign);
    if (at == whole.npos) continue;
    if (std::string unit = take(offset_of(at), whole.substr(at + sign.size())); !unit.empty()) return unit;
  }
  // "energy/kJ"; of "rad/s" the stroke is its own.
  const std::size_t stroke = whole.find('/');
  if (stroke != whole.npos && stroke > 0)
    return take(offset_of(stroke), whole.substr(stroke + 1));
  return "";
}

std::string unit_said_before(std::string_view text) {
  const std::size_t in = text.rfind("in ");
  if (in == text.npos || (in > 0 && is_letter(text[in - 1]))) return "";
  const std::string_view behind = text.substr(in + 3);
  const std::string unit = unit_at_start(behind);
  if (unit.empty()) return "";
  // Behind the unit there is a verb, or a colon.
  std::string_view rest = behind.substr(std::min(behind.find_first_of(" :,"), behind.size()));
  const std::string_view last = without_blanks(rest);
  if (last == ":" || last == "," || last.empty()) return last == "," ? "" : unit;
  return ends_with_any(last, {" is", " are", " was", " of", "is", ":", "about", "comes to"}) &&
                 std::count(last.begin(), last.end(), ' ') < 3
             ? unit
             : "";
}

std::string_view factor_before(std::string_view text) {
  constexpr std::array<std::string_view, 12> kFactors{"minus",  "plus", "twice",  "thrice", "half",     "double",
                                                      "triple", "times", "negative", "half of", "a third of",
                                                      "a quarter of"};
  text = without_blanks(text);
  for (const std::string_view factor : kFactors)
    if (text.ends_with(factor) &&
        (text.size() == factor.size() || !is_letter(text[text.size() - factor.size() - 1])))
      return factor;
  return "";
}

std::string_view factor_behind(std::string_view text) {
  constexpr std::array<std::string_view, 8> kFactors{"dozen",   "hundred", "thousand", "million",
                                                     "billion", "squared", "cubed",    "times "};
  for (const std::string_view factor : kFactors)
    if (text.starts_with(factor)) return factor;
  return "";
}

}  // namespace polhode
