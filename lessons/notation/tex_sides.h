// SPDX-License-Identifier: MIT
// Formulas that are one side alone, such as the name of a curve or the head of a column: a quantity, a unit,
// or a letter that nothing is known of. And numbers that an author typed as the other side of one.
#pragma once

#include "lessons/notation/tex_equation.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

/// A number in a formula as its author typed it.
struct TypedNumber {
  double value = 0;       ///< in the unit
  double last_digit = 1;  ///< what its last digit counts, in the unit
  std::string unit;       ///< as scaled_unit reads it; empty: none stands behind it
};

/// A formula that is one side alone, as an expression; nothing if it cannot be read, or shows a number.
std::optional<Expression> read_side(const Math& math, const EquationNotation& notation);
/// The same as claims read a side: π is no number, and ω without an arrow is not the length of ω.
std::optional<Expression> read_side_of_claim(const Math& math, const EquationNotation& notation);
/// The same as read_side, and why it cannot be read.
Result<Expression, UnreadableEquation> read_one_side(const Math& math, const EquationNotation& notation);

/// The number that a formula is, and nothing else.
std::optional<TypedNumber> read_typed(const Math& math);

/// "T/\text{kJ}": what it is, and the unit; nothing of other formulas.
std::optional<std::pair<Expression, std::string>> read_in_unit(const Math& math,
                                                               const EquationNotation& notation);

/// A unit that a formula prints and nothing else, "\text{kg m}^2/\text{s}"; nothing if it is none.
std::optional<std::string> read_unit_formula(const Math& math);

/// The words of a formula that is words alone, "\text{angular momentum}"; empty of others.
std::string words_of_formula(const Math& math);

/// The letter of a name that is no quantity of the language of claims, as it is printed without its arrow
/// and its index: U'E' of "E_0", U'α'; of "\Delta t" U't'. 0 of all else, among it letters that stand for one
/// number or for an operation: e, i, d, π.
char32_t letter_of_name(const Math& math);

}  // namespace polhode
