// SPDX-License-Identifier: MIT
// Which pixels placed type falls on, by render/drawing/type_grid.h. No GL calls; internal to render/gl/.
#pragma once

#include "render/drawing/type_grid.h"
#include "render/typeset/fonts.h"

#include <cstdint>
#include <vector>

namespace polhode {

GlyphMask mask_of(const GridGlyph& glyph, const Fonts& fonts);

/// Everything within the halo's radius of a type's ink, with a soft edge. The mask's origin lies in pixel
/// (x, y) of the picture.
struct Halo {
  int x = 0, y = 0;
  double radius = 0;
  std::vector<GridGlyph> glyphs;  ///< from (x, y)
  std::vector<RuleBox> rules;     ///< from (x, y)

  std::vector<std::uint64_t> name() const;
  GlyphMask mask(const Fonts& fonts) const;
};

Halo halo_of(const PlacedType& type);

}  // namespace polhode
