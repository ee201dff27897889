// SPDX-License-Identifier: MIT
// The outlines of glyphs, for files that have curves instead of pixels.
#pragma once

#include "base/vectors.h"
#include "render/typeset/fonts.h"

#include <array>
#include <vector>

namespace polhode {

/// A step of a pen that goes along closed outlines: what lies inside of them, by the rule of nonzero winding,
/// is ink.
struct OutlineStep {
  enum class Kind : std::uint8_t { move, line, cubic, close } kind = Kind::move;
  std::array<Vec2, 3> to{};  ///< the last one is where it leads; the others are those of a cubic curve
};

/// Of a glyph, relative to the em, y up; empty for one without ink. As the font has it: nothing is rounded.
std::vector<OutlineStep> outline_of(const Fonts& fonts, Face face, std::uint32_t glyph);

}  // namespace polhode
