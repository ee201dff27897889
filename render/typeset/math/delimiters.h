// SPDX-License-Identifier: MIT
// Glyphs that grow: larger forms of the font, or parts joined with overlap.
#pragma once

#include "render/typeset/math/constants.h"

#include <vector>

namespace polhode {

struct StretchedGlyph {
  struct Part {
    std::uint32_t glyph = 0;
    double offset = 0;  ///< of its lower end (its left end), em, from the lower (left) end of the whole
  };
  std::vector<Part> parts;
  double length = 0;    ///< along the stretch, em
  bool joined = false;  ///< of several parts; else parts[0] is one glyph with its own origin
};

enum class Stretch { vertical, horizontal };

/// The smallest form at least `length` long, em; the largest there is if none is.
StretchedGlyph stretched(const MathFont& font, std::uint32_t glyph, Stretch direction, double length);

/// The largest single form at most `length` long: accents do not stand over their letters' edges.
std::uint32_t widest_form_within(const MathFont& font, std::uint32_t glyph, double length);

}  // namespace polhode
