// SPDX-License-Identifier: MIT
// A sheet as the paths that both kinds of files have. Internal to render/vector/.
#pragma once

#include "render/typeset/glyph_outline.h"
#include "render/vector/vector_picture.h"

#include <string>
#include <vector>

namespace polhode {

/// px from the picture's upper left corner, y down. Filled by nonzero winding, drawn round with round ends
/// and joints, or both.
struct VectorPath {
  std::vector<OutlineStep> steps;
  Color fill{0, 0, 0, 0};    ///< alpha 0: none
  Color stroke{0, 0, 0, 0};  ///< likewise
  double width = 0;          ///< of the stroke
  double dash = 0;           ///< length of a dash and of a gap, between the middles of their ends; 0: solid
};

/// The later over the earlier. Glyphs of one colour that follow each other are one path, and so are rules.
std::vector<VectorPath> paths_of(const Sheet& sheet, const Fonts& fonts);

/// Of a page or picture, points: less than a side of so many pixels by so little that nobody sees it. Where
/// it were more, by rounding, a reader would add a row of pixels.
std::string side_length(double px, double px_per_inch);

/// A thousandth at most, no needless zeros, never "-0".
std::string coordinate(double value);

}  // namespace polhode
