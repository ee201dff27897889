// SPDX-License-Identifier: MIT
// What a formula says of the numbers in it that the program computes, where it is no equation that can be
// read as a whole: a label, a line of prose, a caption, a cell of a table.
//
// A number stands alone on its side of = < > \le \ge \approx, between commas, in a cell of a matrix or in
// brackets, with its unit behind it and nothing else: then it is what it is printed as, and the other sides
// of its chain have to be the same. Or its side can be read, the number for its expression, and so can
// another side of the chain. Or it stands alone as the exponent of e in a formula of nothing else.
//
// Another side is read, as an expression, a number with its unit, a vector or a list; or it is a single name
// of which nothing is known, such as α or Δt, and the number says what it is. All else is refused: a factor,
// a sign, a power or words beside a number would make it another, and what is not read may be anything.
#pragma once

#include "lessons/notation/tex_equation.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// Two sides of a chain, of which one at least shows a number.
struct NumberStatement {
  Equality equality;  ///< of scalars
  Relation relation = Relation::equal;
  /// Of a side that is a number alone: its index in Math::live.
  std::optional<std::size_t> left, right;
};

/// A vector or tensor, and its components as they are printed, some of them numbers: "(1.2, 0.3, 0)". They
/// are those on the axes of the body, or those of space.
struct ComponentsStatement {
  std::vector<Equality> on_body, on_space;
  std::size_t number = 0;  ///< in Math::live, one of them
};

/// A unit that is printed behind a number without one of its own: "kg m²/s", as scaled_unit reads it, or "%".
struct PrintedUnit {
  std::size_t number = 0;  ///< in Math::live
  std::string unit;
};

/// A letter that is nothing known, such as U'E' of "E_0", and the number that it is said to be.
struct NumberName {
  std::size_t number = 0;  ///< in Math::live
  char32_t letter = 0;
};

struct NumbersInFormula {
  std::vector<NumberStatement> statements;
  std::vector<ComponentsStatement> components;
  std::vector<PrintedUnit> units;
  std::vector<NumberName> names;
  /// The number that all of the formula is, or that its last side is; and whether a unit stands behind it.
  std::optional<std::size_t> last;
  bool last_has_unit = false;
  /// The same of the first side: nothing stands before it, or a sign of relation alone.
  std::optional<std::size_t> first;
};

/// A formula that begins with a sign of relation goes on from the last side of the one `above`, if that can
/// be read. Linear in the formula, up to the limits of read_equation.
Result<NumbersInFormula, UnreadableEquation> read_numbers(const Math& math, const EquationNotation& notation,
                                                          const Math* above = nullptr);

}  // namespace polhode
