// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/number_answer.h"

#include "base/angles.h"
#include "base/ascii.h"
#include "base/numbers.h"
#include "base/utf8.h"
#include "base/words/answer_words.h"
#include "lessons/claims/answers/answers.h"
#include "lessons/claims/answers/told_in_language.h"
#include "lessons/claims/answers/typed_unit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace polhode {
namespace {

/// Nobody types more digits and letters of a unit than this.
constexpr std::size_t kMostBytes = 100;
/// Decimals that are typed and halved come out a few bits off.
constexpr double kRounding = 1e-12;

AnswerJudgement judged(AnswerJudgement::Mark mark, std::string reason, std::string hint = {},
                       int column = 0) {
  AnswerJudgement judgement;
  judgement.mark = mark;
  judgement.reason = std::move(reason);
  judgement.hint = std::move(hint);
  judgement.column = column;
  return judgement;
}
/// The reason, and the word by which it is counted (reason_tags.h).
struct Slip {
  const char* tag;
  std::string words;
};
AnswerJudgement wrong(Slip slip) {
  AnswerJudgement judgement = judged(AnswerJudgement::Mark::wrong, std::move(slip.words));
  judgement.tag = slip.tag;
  return judgement;
}

/// That of the question; "" and "1" are those of a number alone.
TypedUnit unit_asked(const std::string& unit) {
  constexpr TypedUnit kAlone{{kNumber, 1}};
  return unit.empty() || unit == "1" ? kAlone : typed_unit(unit).value_or(kAlone);
}

/// A number as it is typed.
struct TypedNumber {
  double value = 0;
  double last_digit = 1;  ///< what one more in its last digit is
  std::string unit;       ///< empty: none
};

/// Takes one of these off the front; false if none is there.
bool take(std::string_view& text, std::initializer_list<std::string_view> ones) {
  for (const std::string_view one : ones)
    if (text.starts_with(one)) {
      text.remove_prefix(one.size());
      return true;
    }
  return false;
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t end = text.find_last_not_of(" \t");
  return end == text.npos ? std::string_view() : text.substr(begin, end + 1 - begin);
}

/// Whether exactly three digits stand behind a blank, as in 1 024; they and the blank are taken.
bool take_group(std::string_view& text, std::string& number) {
  std::string_view rest = text;
  if (!take(rest, {" ", "\u00a0", "\u2009", "\u202f"})) return false;
  const auto is_digit_at = [&](std::size_t i) { return i < rest.size() && is_digit(rest[i]); };
  if (!is_digit_at(0) || !is_digit_at(1) || !is_digit_at(2) || is_digit_at(3)) return false;
  number += rest.substr(0, 3);
  text = rest.substr(3);
  return true;
}

/// [+-] digits [. digits]; what follows stays.
std::string take_decimal(std::string_view& text) {
  std::string number;
  if (take(text, {"-", "−", "–"}))
    number = "-";
  else
    take(text, {"+"});
  const auto take_digits = [&] {
    while (!text.empty() && is_digit(text.front())) {
      number += text.front();
      text.remove_prefix(1);
    }
  };
  take_digits();
  const std::size_t sign = number.starts_with('-') ? 1 : 0;
  if (number.size() > sign && number.size() <= sign + 3)
    while (take_group(text, number)) {
    }
  if (!text.empty() && text.front() == '.') {
    number += '.';
    text.remove_prefix(1);
    take_digits();
  }
  return std::any_of(number.begin(), number.end(), is_digit) ? number : "";
}

/// "⁴", "⁻³": the power; nothing if the text does not begin with one.
std::optional<int> take_raised(std::string_view& text) {
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string_view rest = text;
  const bool is_negative = take(rest, {"⁻"});
  std::string digits;
  while (digits.size() < 3) {
    const auto found =
        std::find_if(kRaised.begin(), kRaised.end(), [&](std::string_view one) { return take(rest, {one}); });
    if (found == kRaised.end()) break;
    digits += static_cast<char>('0' + (found - kRaised.begin()));
  }
  if (digits.empty()) return std::nullopt;
  text = rest;
  return (is_negative ? -1 : 1) * std::stoi(digits);
}

/// "e3", "·10^3", "x 10^-3", "× 10⁴": the power; nothing, and the text as it was, where there is none.
std::optional<int> take_power(std::string_view& text) {
  std::string_view rest = text;
  const bool is_e = take(rest, {"e", "E"});
  if (!is_e) {
    rest = without_blanks(rest);
    if (!take(rest, {"·", "⋅", "×", "*", "x"})) return std::nullopt;
    rest = without_blanks(rest);
    if (!take(rest, {"10"})) return std::nullopt;
    if (const auto power = take_raised(rest)) {
      text = rest;
      return power;
    }
    if (!take(rest, {"^", "**"})) return std::nullopt;
  }
  const bool has_brackets = !is_e && take(rest, {"(", "{"});
  const bool is_negative = take(rest, {"-", "−"});
  if (!is_negative) take(rest, {"+"});
  constexpr int kMostPower = 9999;
  int power = 0;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), power);
  if (read.ec != std::errc() || power < 0 || power > kMostPower) return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
  if (has_brackets && !take(rest, {")", "}"})) return std::nullopt;
  text = rest;
  return is_negative ? -power : power;
}

/// "^10", "**-2", "¹⁰" behind a number: what it is raised to; nothing, and the text as it was, if it is not.
std::optional<int> take_exponent(std::string_view& text) {
  if (const auto raised = take_raised(text)) return raised;
  std::string_view rest = text;
  if (!take(rest, {"^", "**"})) return std::nullopt;
  const bool has_brackets = take(rest, {"("});
  const bool is_negative = take(rest, {"-", "−", "–"});
  int power = 0;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), power);
  if (read.ec != std::errc() || power < 0) return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
  if (has_brackets && !take(rest, {")"})) return std::nullopt;
  text = rest;
  return is_negative ? -power : power;
}

using Unreadable = AnswerJudgement;
struct Reading {
  std::optional<TypedNumber> number;
  Unreadable why;
};

/// In another language than the readers' errors say them in.
std::string unit_names(Language language) {
  const std::string_view english = words::kWithPowers.in(Language::en);
  const std::size_t names = kUnitNames.find(english);
  if (names == kUnitNames.npos) return std::string(kUnitNames);
  return std::string(kUnitNames.substr(0, names)) + std::string(words::kWithPowers.in(language));
}

Reading read_typed(std::string_view whole, Language language) {
  std::string_view text = without_blanks(whole);
  const auto in_words = [language](const Phrase& phrase) { return std::string(phrase.in(language)); };
  const auto refuse = [](std::string reason, std::string hint = {}, int column = 0) -> Reading {
    return {std::nullopt,
            judged(AnswerJudgement::Mark::unreadable, std::move(reason), std::move(hint), column)};
  };
  const auto column = [&] {
    return 1 + count_characters(whole.substr(0, static_cast<std::size_t>(text.data() - whole.data())));
  };
  if (text.empty()) return refuse(in_words(words::kNumberIsAsked), in_words(words::kNumberForm));
  if (text.size() > kMostBytes) return refuse(in_words(words::kTooLong));
  while (take(text, {"≈", "≃", "~", "=", " "})) {
  }
  if (const std::size_t equals = std::min(text.find('='), text.find("≈")); equals != text.npos)
    return refuse(in_words(words::kNumberAlone), in_words(words::kBehindEquals), column());
  const std::string digits = take_decimal(text);
  if (!text.empty() && text.front() == ',')
    return refuse(in_words(words::kNoComma), in_words(words::kInsteadOfComma), column());
  if (digits.empty()) return refuse(in_words(words::kNoNumber), in_words(words::kWriteANumber), column());
  const std::optional<int> exponent = take_exponent(text);
  const int power = take_power(text).value_or(0);
  const std::size_t point = digits.find('.');
  const auto decimals = point == digits.npos ? 0 : static_cast<int>(digits.size() - point) - 1;
  TypedNumber number;
  const auto value = parse_number(digits + 'e' + std::to_string(power));
  if (!value || !std::isfinite(*value))
    return refuse(in_words(power > 0 ? words::kNumberTooLarge : words::kNumberTooSmall));
  number.value = *value;
  number.last_digit = std::pow(10.0, power - decimals);
  if (exponent) {
    const double base = parse_number(digits).value_or(0);
    number.value = std::pow(base, *exponent) * std::pow(10.0, power);
    number.last_digit = 0;  // it is exact
    if (!std::isfinite(number.value)) return refuse(in_words(words::kNumberTooLarge));
    if (number.value == 0 && base != 0) return refuse(in_words(words::kNumberTooSmall));
  }
  text = without_blanks(text);
  if (text.ends_with('.')) text = without_blanks(text.substr(0, text.size() - 1));  // it ends a sentence
  if (!text.empty() && !typed_unit(text)) {
    const bool computes =
        is_digit(text.front()) || std::string_view("+-*/^=().").find(text.front()) != std::string_view::npos;
    if (computes) return refuse(in_words(words::kOneNumber), in_words(words::kTypeTheResult), column());
    return refuse(words::kUnknownUnit.with(language, {text}),
                  words::kUnitsAre.with(language, {unit_names(language)}), column());
  }
  number.unit = text;
  return {number, {}};
}

class NumberJudge {
 public:
  NumberJudge(const NumberAnswer& answer, const TypedNumber& typed, Language language)
      : answer_(answer),
        typed_(typed),
        language_(language),
        asked_(unit_asked(answer.unit)),
        right_(*answer.value),
        within_(tolerance_of(answer)) {}

  AnswerJudgement judge() const {
    double size = 1;
    if (!typed_.unit.empty()) {
      const TypedUnit unit = *typed_unit(typed_.unit);
      if (const std::string why = why_not(unit); !why.empty()) return wrong({"unit", why});
      size = unit.scaled.size / answer_.unit_si;
      if (asked_.cycles == 1 && unit.angles == 1) size /= kRadiansPerTurn;  // rpm where Hz is asked for
    }
    const double value = typed_.value * size;
    if (is_right(value)) return judged(AnswerJudgement::Mark::right, {});
    return wrong(slip(value, typed_.last_digit * size));
  }

 private:
  /// Of a unit that cannot be that of the answer.
  std::string why_not(const TypedUnit& unit) const {
    const bool is_alone = answer_.unit.empty() || answer_.unit == "1";
    const std::string in =
        is_alone ? said(words::kAskedWithoutUnit) : words::kAskedInUnit.with(language_, {answer_.unit});
    std::string of_another_kind = words::kOtherKindOfUnit.with(language_, {in, typed_.unit});
    if (unit.scaled.dimension != asked_.scaled.dimension) return of_another_kind;
    if (unit.is_percent && !is_alone) return of_another_kind;
    if (unit.cycles == 1 && asked_.angles == 1) return words::kCountsTurns.with(language_, {typed_.unit, in});
    const bool counts_turns_too = typed_.unit.starts_with("rpm") || typed_.unit.starts_with("rev");
    if (unit.angles == 1 && asked_.cycles == 1)
      return counts_turns_too ? "" : words::kCountsAngles.with(language_, {typed_.unit, in});
    // An angle may be left out, as in 1/s for rad/s. Where none is asked for none belongs, but in a rate.
    const bool is_of_rate = asked_.scaled.dimension == kRate && unit.angles == 1;
    if (unit.angles != asked_.angles && unit.angles != 0 && !is_of_rate) return of_another_kind;
    return "";
  }

  bool is_right(double value) const {
    return std::abs(value - right_) <= within_ + kRounding * std::abs(right_);
  }
  bool is_right_times(double value, double factor) const { return is_right(value / factor); }

  bool is_angular() const { return asked_.angles == 1; }
  bool is_in_degrees() const {
    return answer_.unit.find("deg") != std::string::npos || answer_.unit.find("°") != std::string::npos;
  }
  /// What is counted in radians or in turns, and the time that one of them takes.
  bool has_cycles() const {
    return is_angular() || asked_.scaled.dimension == kRate || asked_.scaled.dimension == kTime;
  }

  Slip slip(double value, double last_digit) const {
    if (is_right(-value)) return {"signs", said(words::kWrongSign)};
    if (value != 0 && std::abs(value - right_) <= 0.5 * last_digit)
      return {"rounding", words::kTooCoarse.with(language_, {with_decimals(answer_.within_text, language_)})};
    if (is_angular()) {
      if (!is_in_degrees() && is_right_times(value, 1 / kRadiansPerDegree))
        return {"degrees", said(words::kAreDegrees)};
      if (is_in_degrees() && is_right_times(value, kRadiansPerDegree))
        return {"degrees", said(words::kAreRadians)};
    }
    if (has_cycles()) {
      if (is_right_times(value, kRadiansPerTurn)) return {"turns", said(words::kTurnsTooLarge)};
      if (is_right_times(value, 1 / kRadiansPerTurn)) return {"turns", said(words::kTurnsTooSmall)};
    }
    for (int power = 1; power <= 12; ++power) {
      const double factor = std::pow(10.0, power);
      if (is_right_times(value, factor))
        return {"power-of-ten", words::kTooLargeByFactor.with(language_, {power_of_ten(power)})};
      if (is_right_times(value, 1 / factor))
        return {"power-of-ten", words::kTooSmallByFactor.with(language_, {power_of_ten(power)})};
    }
    if (is_right_times(value, 2)) return {"factor", said(words::kTwice)};
    if (is_right_times(value, 0.5)) return {"factor", said(words::kHalf)};
    if (value == 0) return {"other", said(words::kIsNotZero)};
    return {"other", said(value * right_ < 0                   ? words::kNeitherSignNorSize
                          : std::abs(value) > std::abs(right_) ? words::kNumberIsTooLarge
                                                               : words::kNumberIsTooSmall)};
  }

  std::string said(const Phrase& phrase) const { return std::string(phrase.in(language_)); }

  static std::string power_of_ten(int power) {
    return power <= 3 ? '1' + std::string(static_cast<std::size_t>(power), '0')
                      : "10^" + std::to_string(power);
  }

  const NumberAnswer& answer_;
  const TypedNumber& typed_;
  Language language_;
  TypedUnit asked_;
  double right_, within_;
};

}  // namespace

double tolerance_of(const NumberAnswer& answer) {
  return answer.is_relative ? answer.within * std::abs(*answer.value) : answer.within;
}

std::string words_of(const NumberAnswer& answer) {
  if (!answer.value) return "";
  // One digit more than the tolerance decides, and all before the point of numbers that are read at a glance.
  const double size = std::abs(*answer.value);
  const double ratio = size / std::max(tolerance_of(answer), 1e-15 * size);
  const auto power_of = [](double x) { return x > 0 ? static_cast<int>(std::floor(std::log10(x))) : 0; };
  const int before_point = size < 1e5 ? 1 + power_of(size) : 0;
  const int shown = std::clamp(2 + power_of(ratio), std::max(2, before_point), 15);
  const std::string number = digits(*answer.value, shown);
  if (answer.unit == "deg" || answer.unit == "°") return number + "°";
  return number + (answer.unit.empty() ? "" : ' ' + answer.unit);
}

namespace {

/// "1.5" for "1,5" where numbers have commas, in as many bytes, so that columns stay. A comma of 1,5,3 is
/// none of a number.
std::string with_point(std::string_view text, Language language) {
  std::string typed(text);
  const std::size_t comma = typed.find(',');
  const auto is_digit_at = [&](std::size_t i) { return i < typed.size() && is_digit(typed[i]); };
  if (decimal_mark(language) == ',' && comma != typed.npos && is_digit_at(comma + 1) &&
      typed.find('.') == typed.npos && typed.find(',', comma + 1) == typed.npos)
    typed[comma] = '.';
  return typed;
}

}  // namespace

AnswerJudgement judge_number_in(Language language, const NumberAnswer& answer, std::string_view text) {
  const Reading reading = read_typed(with_point(text, answer.language), language);
  if (!reading.number) return reading.why;
  if (!answer.value)
    return judged(AnswerJudgement::Mark::unreadable, std::string(words::kHasNoNumber.in(language)));
  return NumberJudge(answer, *reading.number, language).judge();
}

AnswerJudgement judge_number(const NumberAnswer& answer, std::string_view text) {
  return judge_number_in(Language::en, answer, text);
}

}  // namespace polhode
