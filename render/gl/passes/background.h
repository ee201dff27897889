// SPDX-License-Identifier: MIT
// What is behind a picture.
#pragma once

#include "base/color.h"

#include <optional>
#include <string_view>

namespace polhode {

/// studio: light gradient backdrop; paper (kPaper); white; transparent: true alpha; or one colour.
struct Background {
  enum class Kind { studio, paper, white, transparent, color } kind = Kind::studio;
  Color color;  ///< of Kind::color
};
/// studio | paper | white | transparent | #rrggbb; nothing otherwise.
std::optional<Background> background_from(std::string_view text);

/// Straight alpha; of the studio white.
Color sky_of(const Background& background);

/// Text stays readable on any backdrop: light halo on light, and on transparent, dark on dark.
Color halo_of(const Background& background);

}  // namespace polhode
