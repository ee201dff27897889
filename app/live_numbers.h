// SPDX-License-Identifier: MIT
// The numbers of \live in a formula that is set: where they stand, and what they are.
#pragma once

#include "lessons/live_claims.h"
#include "render/scene/sheet.h"

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

/// The number in its room, three digits; dots where there is no motion, or no value.
PlacedType live_number_in(const LiveRoom& room, const Expression& number, const LiveState* live,
                          const Fonts& fonts);

}  // namespace polhode
