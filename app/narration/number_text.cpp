// SPDX-License-Identifier: MIT
#include "app/narration/number_text.h"

#include "base/words/formula_words.h"
#include "base/words/speech_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

constexpr int kUsualDigits = 3;
constexpr int kMostBeforePoint = 5, kMostZerosBehind = 1;  // without a power of ten
constexpr int kMostZerosHeard = 3;                         // 0.0025 is heard sooner than 2.5 times 10 to …

struct Written {
  bool negative = false;
  std::string digits;  ///< "2.25"
  int power = 0;       ///< of ten
};

Written written(double value, int digits, int most_zeros = kMostZerosBehind) {
  if (value == 0) return {false, "0", 0};
  const int most = digits > 0 ? digits : kUsualDigits;
  const std::string rounded = fmt::format("{:.{}e}", std::abs(value), most - 1);  // "2.25e+04"
  const std::size_t e = rounded.find('e');
  const int exponent = std::stoi(rounded.substr(e + 1));
  if (exponent < -1 - most_zeros || exponent >= std::max(kMostBeforePoint, most))
    return {value < 0, rounded.substr(0, e), exponent};
  return {value < 0, fmt::format("{:.{}f}", std::abs(value), std::max(most - 1 - exponent, 0)), 0};
}

std::string words_of(const Written& number, Language language) {
  const auto signed_words = [language](bool is_negative, std::string words) {
    return is_negative ? words::kMinus.with(language, {words}) : words;
  };
  const std::string text = signed_words(number.negative, with_decimals(number.digits, language));
  if (number.power == 0) return text;
  const std::string power = signed_words(number.power < 0, std::to_string(std::abs(number.power)));
  return words::kTimesTenToThePower.with(language, {text, power});
}

const words::UnitWords* known_unit(const std::string& unit) {
  const auto* known = std::find_if(words::kUnits.begin(), words::kUnits.end(),
                                   [&](const words::UnitWords& words) { return words.unit == unit; });
  return known == words::kUnits.end() ? nullptr : known;
}

}  // namespace

std::string number_tex(double value, int digits) {
  const Written number = written(value, digits);
  std::string text = (number.negative ? "-" : "") + number.digits;
  return number.power == 0 ? text : fmt::format("{}{{\\cdot}}10^{{{}}}", text, number.power);
}

std::string number_words(double value, int digits, Language language) {
  return words_of(written(value, digits), language);
}

std::string short_number_words(double value, int digits, Language language) {
  if (!std::isfinite(value)) return std::string(words::kNotDefined.in(language));
  Written number = written(value, digits, kMostZerosHeard);
  std::string& text = number.digits;
  if (text.find('.') != std::string::npos) {
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
  }
  number.negative = number.negative && text != "0";
  return words_of(number, language);
}

std::string unit_in_words(const std::string& unit, Language language) {
  const words::UnitWords* known = known_unit(unit);
  return known ? std::string(known->words.in(language)) : unit;
}

std::string with_unit(const std::string& number, const std::string& unit, Language language) {
  if (unit.empty()) return number;
  const words::UnitWords* known = number == "1" ? known_unit(unit) : nullptr;
  return number + ' ' + (known ? std::string(known->one.in(language)) : unit_in_words(unit, language));
}

}  // namespace polhode
