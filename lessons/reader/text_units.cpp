// SPDX-License-Identifier: MIT
#include "lessons/reader/text_units.h"

#include "base/ascii.h"
#include "lessons/claims/expressions/dimension.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {
namespace {

constexpr std::array<std::string_view, 5> kBlanks = {" ", "\n", "\u00A0", "\u2009", "\u202F"};

/// "kJ" of "kilojoules"; other words as they are.
std::string unit_in_short(std::string_view word) {
  // "Kilo-Joules"
  std::string plain;
  for (const char c : word)
    if (c != '-') plain += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
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
      if (plain == name || plain == name + 's') return std::string(p) + std::string(u);
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

std::string unit_behind(std::string_view text) {
  while (take_blank(text)) {
  }
  return unit_at_start(text);
}

std::string whole_unit(std::string_view text) {
  std::string unit;
  for (text = without_blanks(text); !text.empty(); text = without_blanks(text)) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    if (word == "per" && !unit.empty())
      unit += '/';
    else
      unit += (unit.empty() || unit.back() == '/' ? "" : " ") + unit_in_short(word);
    text.remove_prefix(end);
  }
  const bool is_unit = (has_letter(unit) || unit.starts_with("°")) && scaled_unit(unit);
  return is_unit ? unit : "";
}

std::string take_unit_at_end(std::string& text) {
  const auto take = [&](std::size_t end_of_words, std::size_t begin, std::size_t end) {
    std::string unit = whole_unit(std::string_view(text).substr(begin, end - begin));
    if (!unit.empty()) text.erase(end_of_words);
    return unit;
  };
  const std::size_t last = text.find_last_not_of(' ');
  if (last == text.npos) return "";
  for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')})
    if (text[last] == close) {
      const std::size_t at = text.rfind(open);
      return at == text.npos ? "" : take(at, at + 1, last);
    }
  for (const std::string_view sign : {", ", " in ", "/ "}) {
    const std::size_t at = text.rfind(sign);
    if (at == text.npos) continue;
    if (std::string unit = take(at, at + sign.size(), last + 1); !unit.empty()) return unit;
  }
  if (text.starts_with("in ")) return take(0, 3, last + 1);
  // "energy/kJ"; the stroke of "rad/s" belongs to the unit.
  const std::size_t stroke = text.find('/');
  if (stroke == text.npos || stroke == 0) return "";
  const std::size_t word = text.find_last_of(" (", stroke - 1);
  const std::size_t begin = word == text.npos ? 0 : word + 1;
  return whole_unit(std::string_view(text).substr(begin, stroke - begin)).empty()
             ? take(stroke, stroke + 1, last + 1)
             : "";
}

std::string unit_said_before(std::string_view text) {
  text = without_blanks(text);
  const std::size_t in = text.rfind("in ");
  if (in == text.npos || (in > 0 && is_letter(text[in - 1]))) return "";
  std::string_view unit = text.substr(in + 3);
  for (const std::string_view verb : {" is about", " is", " are", " was", " comes to", ":"})
    if (unit.ends_with(verb)) {
      unit.remove_suffix(verb.size());
      return whole_unit(unit);
    }
  return "";
}

std::string_view name_said_before(std::string_view text) {
  text = without_blanks(text);
  for (const std::string_view verb :
       {" is now", " is about", " is only", " is", " are", " was", " comes to", " amounts to", " of", ":"})
    if (text.ends_with(verb)) {
      text.remove_suffix(verb.size());
      const std::size_t before = text.find_last_of(".,;:!?(");
      return without_blanks(before == text.npos ? text : text.substr(before + 1));
    }
  return "";
}

std::optional<Relation> relation_said(std::string_view words) {
  words = without_blanks(words);
  for (const std::string_view verb :
       {"is", "was", "equals", "is now", "is only", "comes to", "amounts to", ":"})
    if (words == verb) return Relation::equal;
  for (const std::string_view verb : {"is about", "is nearly"})
    if (words == verb) return Relation::approximate;
  if (words == "is more than" || words == "is greater than") return Relation::greater;
  if (words == "is less than" || words == "is smaller than") return Relation::less;
  return std::nullopt;
}

std::string_view factor_before(std::string_view text) {
  constexpr std::array<std::string_view, 9> kFactors{
      "minus", "negative", "twice", "thrice", "half", "double", "triple", "a third of", "a quarter of"};
  text = without_blanks(text);
  for (const std::string_view factor : kFactors) {
    const bool is_word = text.size() == factor.size() ||
                         (text.size() > factor.size() && !is_letter(text[text.size() - factor.size() - 1]));
    if (is_word && text.ends_with(factor)) return factor;
  }
  // "three times", not "at times".
  if (!text.ends_with(" times")) return "";
  text.remove_suffix(std::string_view(" times").size());
  constexpr std::array<std::string_view, 15> kCounts{"two",   "three", "four",    "five",     "six",
                                                     "seven", "eight", "nine",    "ten",      "hundred",
                                                     "many",  "dozen", "million", "thousand", "billion"};
  const bool is_count = std::any_of(kCounts.begin(), kCounts.end(),
                                    [&](std::string_view count) { return text.ends_with(count); });
  return is_count || (!text.empty() && is_digit(text.back())) ? "times" : "";
}

std::string_view factor_behind(std::string_view text) {
  constexpr std::array<std::string_view, 7> kFactors{"dozen",   "hundred", "thousand", "million",
                                                     "billion", "squared", "cubed"};
  for (const std::string_view factor : kFactors)
    if (text.starts_with(factor)) return factor;
  return "";
}

}  // namespace polhode
