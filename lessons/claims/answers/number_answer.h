// SPDX-License-Identifier: MIT
// Answers that are numbers with a unit, and what is to be said of one that is typed.
#pragma once

#include "base/words/language.h"
#include "lessons/claims/expressions/expression.h"

#include <optional>
#include <string>
#include <string_view>

namespace polhode {

struct AnswerJudgement;

/// What is right, and how near to it is near enough.
struct NumberAnswer {
  std::optional<Expression> expression;  ///< its value on the step's motion is right; nothing: it is typed
  std::optional<double> value;           ///< in the unit; nothing: it was not computed, or is not defined
  std::string unit;                      ///< as it is written; empty: the answer is a number alone
  double unit_si = 1;                    ///< of the unit
  double within = 0.02;                  ///< of the value; absolute ones in the unit
  bool is_relative = true;
  std::string within_text = "2 %";   ///< as a question says it
  Language language = Language::en;  ///< whose decimal mark is read besides the point
};

/// More than so much of the value decides nothing: twice and half of it would nearly be right.
inline constexpr double kMostWithin = 0.2;

/// How far off an answer may be, in the unit. Precondition: there is a value.
double tolerance_of(const NumberAnswer& answer);

/// The value with the digits that its tolerance leaves, and its unit: "4.19 rad/s", "35.6°"; "" without a
/// value.
std::string words_of(const NumberAnswer& answer);

/// Reads "4.2", "4.2 J", "4200 mJ", "1.2e3", "1.2·10^3 rpm", "1.2 × 10³", and converts units of the same kind
/// (typed_unit.h). A number without a unit is in that of the question. Radians, degrees and turns belong to
/// angles and rates alone. Slips that are looked for: a unit of another kind, turns for radians, the sign,
/// digits rounded away, degrees for radians, 2π in angles, rates and times, powers of ten, 2 and 1/2.
AnswerJudgement judge_number(const NumberAnswer& answer, std::string_view text);

}  // namespace polhode
