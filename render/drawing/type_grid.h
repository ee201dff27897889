// SPDX-License-Identifier: MIT
// Where placed type stands on the grid of pixels: glyphs in quarters of a pixel, rules as boxes. A renderer
// and a file of outlines place it alike.
#pragma once

#include "render/drawing/sheet.h"

#include <cstdint>

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

/// Type stands still on whole rows; rows of a line are then the same distance apart wherever it stands.
/// @param y of the list, px
double row_of(double y, const PlacedType& type);

/// px: so far around the ink of a type reaches its halo.
double halo_radius(const DisplayList& list);

}  // namespace polhode
