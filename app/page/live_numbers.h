// SPDX-License-Identifier: MIT
// The numbers of \live in a formula that is set: where they stand, and what they are.
#pragma once

#include "lessons/claims/live_claims.h"
#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// The room of one number in a display list.
struct LiveRoom {
  std::size_t index = 0;  ///< into Math::live and Equation::live
  Vec2 at{0, 0};          ///< left end of its baseline
  double size = 0;        ///< em
  Color color;
};

/// Takes what holds their room out of the list.
std::vector<LiveRoom> take_live_rooms(DisplayList& list);

/// Three digits, or all before the point up to 99,999: "2.47", "0.0123", "22500"; others with a power of ten,
/// as set_line sets it.
std::string live_number_text(double value);

/// The number in its room, smaller where it is too wide; dots where there is none.
PlacedType live_number_in(const LiveRoom& room, std::optional<double> value, const Fonts& fonts);

}  // namespace polhode
