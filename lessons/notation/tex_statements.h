// SPDX-License-Identifier: MIT
// What a formula states, as far as each of its statements can be read by itself, whether or not all of it
// can: "T = 5\,\text{J}" in a line of prose, or beside other things in a display.
#pragma once

#include "lessons/notation/tex_sides.h"

#include <string>
#include <utility>
#include <vector>

namespace polhode {

/// A side that is read.
struct StatedSide {
  std::optional<Expression> is;      ///< of a number with its unit that of SI; nothing: it is the time, t
  std::optional<TypedNumber> typed;  ///< of a number that stands alone
  std::optional<double> at_s{};      ///< of "T(2)", "T(t = 2\\,\\text{s})": when; of "T_0" 0

  bool is_time() const { return !is; }
};

/// Two neighbours in a chain. "a ∥ b" is a × b = 0 and "a ⊥ b" a·b = 0; "a = const" says that its rate is 0.
struct StatedLink {
  StatedSide left, right;
  Relation relation = Relation::equal;
  bool is_denied = false;        ///< ≠: equal they are not
  bool is_of_all_times = false;  ///< "= const": at one instant it says nothing
  SourceSpan source;             ///< of both, in the TeX
  bool ends_formula = false;     ///< what stands behind the formula stands behind it
  bool is_in_words = false;      ///< "vanishes": to a few per cent of what it is at other times

  bool is_of_a_time() const { return left.at_s || right.at_s; }
};

/// "\vec\omega = (0.5, 3, 0.7)": on which axes is left open. Of "(T, \omega_1) = (9, 1)" each pair is a link.
struct StatedComponents {
  std::vector<StatedLink> on_body, on_space;  ///< three each
};

inline constexpr char kRelationMark = '\x01';

struct Statements {
  std::vector<StatedLink> links;
  std::vector<StatedComponents> components;
  std::vector<std::pair<Expression, SourceSpan>> sides;  ///< all that are read, of links or not
  /// Those that stand among them, and kRelationMark for each sign of relation: of "T = 0 if N = 0" the
  /// words are "if" between two marks.
  std::string words;
  bool is_condition = false;  ///< an arrow, or a condition in brackets, makes of them what is not stated
};

/// Links with a side that is not read are left out, and so are all of a formula that is nothing but signs.
Statements stated_in(const Math& math, const EquationNotation& notation);

/// "\omega_3 = 5\,\text{rad/s}": what the number is said to be of.
struct TypedStatement {
  std::optional<Expression> of;  ///< a scalar; nothing: it is the time, t
  Relation relation = Relation::equal;
  TypedNumber number;
};
/// Those of a formula's statements that can be told: sides that are read, or t, beside a number.
std::vector<TypedStatement> typed_statements(const Math& math, const EquationNotation& notation);

}  // namespace polhode
