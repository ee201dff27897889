// SPDX-License-Identifier: MIT
// Which pixels placed type falls on: glyphs in quarters of a pixel, rules as boxes. No GL calls; internal to
// render/gl/.
#pragma once

#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"

#include <cstdint>
#include <vector>

namespace polhode {

/// A glyph whose origin lies in pixel (x, y), quarters of a pixel from its upper left corner.
struct GridGlyph {
  int x = 0, y = 0;
  int quarter_x = 0, quarter_y = 0;
  int size_64 = 0;  ///< em, 1/64 px
  Face face = Face::serif;
  std::uint32_t id = 0;

  /// The same for all glyphs with the same mask.
  std::uint64_t mask_name() const {
    return (static_cast<std::uint64_t>(id) << 40) | (static_cast<std::uint64_t>(size_64) << 12) |
           (static_cast<std::uint64_t>(face) << 4) | static_cast<std::uint64_t>(quarter_x << 2 | quarter_y);
  }
};

/// Across to every quarter of a pixel; down too if the type moves, else to whole pixels.
GridGlyph on_grid(const Glyph& glyph, const PlacedType& type);
GlyphMask mask_of(const GridGlyph& glyph, const Fonts& fonts);

/// A box turned by an angle: px from the picture's upper left corner.
struct RuleBox {
  Vec2 middle{0, 0};
  Vec2 along{1, 0};  ///< unit
  Vec2 half{0, 0};   ///< length and thickness

  /// The part of a pixel around `p` that is covered: exact for boxes along the axes, by their distance from
  /// the edges for others.
  double coverage(const Vec2& p) const;
};

/// Horizontal and vertical rules of still type fill whole pixels: rows or columns as the thickness says, at
/// least one, so that all of one thickness look alike; and all that they touch lengthwise, so that those that
/// meet do.
RuleBox on_grid(const Rule& rule, const PlacedType& type);

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
