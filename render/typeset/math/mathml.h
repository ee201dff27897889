// SPDX-License-Identifier: MIT
// Formulas for browsers and screen readers: the parsed tree as MathML Core (W3C, "MathML Core", 2025), which
// all engines set since 2023. No style attributes, so that a strict Content-Security-Policy keeps them; what
// MathML Core has no words for are classes, which a style sheet gives their look:
//   b i sf tt      the face of a text
//   cancel-up cancel-down cancel-x   struck out by a stroke, or by two
//   box            in a frame
//   vec            an arrow above a letter, which is shorter than one between two
//   left center right   how the cells of a table stand
//   pieces         on `math`: its rows may stand below each other
//   aligned cases matrix small gathered array   on a table: which environment it is
//   line-above line-below line-left line-right  of a cell
#pragma once

#include "render/typeset/math/math.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct MathMlStyle {
  bool display = false;
  const std::vector<MathSymbol>* symbols = nullptr;  ///< looked for; may be null
  /// The class of all that is a symbol of this name, as set_math colours it; empty: none. May be null.
  std::function<std::string(std::string_view symbol)> class_of{};
  /// The address that a reference leads to, from its link (ShownReference::link); empty: nowhere. May be
  /// null.
  std::function<std::string(std::string_view link)> address_of{};
  std::string words{};  ///< what a reader says of all of it (spoken); empty: what the parts say
  std::string tex{};    ///< to copy; empty: there is none
  /// Whether a style sheet may break its line: before relations and sums at its top level, as set_math does,
  /// a row begins, an element of `math` itself, which browsers ask for. `tex` is then the attribute data-tex,
  /// as the element that annotates stands between. A formula without such a place is written as if this were
  /// not asked for.
  bool in_pieces = false;
};

/// One `math` element, well-formed as XML too: nothing of the formula can end it. Without the tag. Numbers
/// that nobody has put in show the room for them. Linear in the formula's length.
std::string mathml(const Math& math, const MathMlStyle& style);

}  // namespace polhode
