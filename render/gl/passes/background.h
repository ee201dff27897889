// SPDX-License-Identifier: MIT
// What is behind a picture.
#pragma once

#include "base/color.h"
#include "render/figure/figure.h"

#include <optional>
#include <string_view>

namespace polhode {

/// studio: light gradient backdrop; paper (kPaper); white; transparent: true alpha, to be laid over something
/// light or dark; or one colour.
struct Background {
  enum class Kind { studio, paper, white, transparent, color } kind = Kind::studio;
  Color color;           ///< of Kind::color
  bool on_dark = false;  ///< of Kind::transparent
};
/// studio | paper | white | transparent | transparent-dark | #rrggbb; nothing otherwise.
std::optional<Background> background_from(std::string_view text);

/// Straight alpha; of the studio white.
Color sky_of(const Background& background);

/// Text stays readable on any backdrop: light halo on light, dark on dark.
Color halo_of(const Background& background);

/// The figure with lines, arrows, balls and translucent surfaces in colours that are seen on dark ground
/// (paint_on_dark); bodies and glass stay as they are.
Figure on_dark_ground(Figure figure);

}  // namespace polhode
