// SPDX-License-Identifier: MIT
#include "app/narration/number_text.h"

#include "base/words/formula_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

constexpr int kUsualDigits = 3;
constexpr int kMostBeforePoint = 5, kMostZerosBehind = 1;  // without a power of ten

struct Written {
  bool negative = false;
  std::string digits;  ///< "2.25"
  int power = 0;       ///< of ten
};

Written written(double value, int digits) {
  if (value == 0) return {false, "0", 0};
  const int most = digits > 0 ? digits : kUsualDigits;
  const std::string rounded = fmt::format("{:.{}e}", std::abs(value), most - 1);  // "2.25e+04"
  const std::size_t e = rounded.find('e');
  const int exponent = std::stoi(rounded.substr(e + 1));
  if (exponent < -1 - kMostZerosBehind || exponent >= std::max(kMostBeforePoint, most))
    return {value < 0, rounded.substr(0, e), exponent};
  return {value < 0, fmt::format("{:.{}f}", std::abs(value), std::max(most - 1 - exponent, 0)), 0};
}

}  // namespace

std::string number_tex(double value, int digits) {
  const Written number = written(value, digits);
  std::string text = (number.negative ? "-" : "") + number.digits;
  return number.power == 0 ? text : fmt::format("{}{{\\cdot}}10^{{{}}}", text, number.power);
}

std::string number_words(double value, int digits, Language language) {
  const auto signed_words = [language](bool is_negative, std::string words) {
    return is_negative ? words::kMinus.with(language, {words}) : words;
  };
  const Written number = written(value, digits);
  const std::string text = signed_words(number.negative, with_decimals(number.digits, language));
  if (number.power == 0) return text;
  const std::string power = signed_words(number.power < 0, std::to_string(std::abs(number.power)));
  return words::kTimesTenToThePower.with(language, {text, power});
}

}  // namespace polhode
