// SPDX-License-Identifier: MIT
// What a learner types on a keyboard, "dL/dt = I omega' + omega x (I omega)", as TeX: that is set on the
// page, and read as an equation (tex_equation.h), so that what is judged is what is seen.
//
//   line     side = side = …; one that begins with "=" goes on from the line before
//   side     terms with + and − between them
//   term     factors; between them nothing, "*", "x" or "×" (cross product), "." or "·" (dot product)
//   a/b      what stands before it since the last sign, over the one factor behind it: "I1 w1/I2". "1/2 I1"
//            is a half of I1; "a/b c" is refused, for it has two readings
//   factor   a number; a name with its index; (…), (…)_2; |a|; a function; any of them with ^2, ² or ', its
//            rate
//   rate     dL/dt, d(…)/dt, d/dt …, ddt(…) as seen from space; d*L/dt, d*/dt …, star(…) from the body;
//            dw1, w1'
//   function cross(a, b), dot(a, b), norm2(a), norm(a), comp(a, 2), inertia(a)
//   name     omega w ω L N A p v F T m, I (the tensor), e; indices 1 2 3 or x y z behind them, w1, w_1, ω₁;
//            and those of the lesson's symbols
//
// Products without a sign bind more strongly than "x" and ".", as in print. A dot between digits is that of a
// number. Blanks do not matter but around "x" and between names.
#pragma once

#include "lessons/notation/typed/typed_tokens.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polhode {

/// Brackets in brackets: what is deeper is refused.
inline constexpr int kMaxTypedNesting = 16;

struct TypedFormula {
  /// Of the whole line; where there is a fault, of what stands before it and, upright, the rest as it is
  /// typed: it is shown while the line grows.
  std::string tex;
  std::optional<TypedFault> fault;
  bool goes_on = false;  ///< it begins with "="
  /// Bytes of `tex` and of the line that belong together, in their order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> marks;
};

/// Linear in the line; some 10 µs.
TypedFormula typed_formula(std::string_view line, const TypedNames& names);

/// The byte of the line that a byte of the TeX comes from.
std::size_t typed_offset(const TypedFormula& formula, std::size_t tex_offset);

}  // namespace polhode
