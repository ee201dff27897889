// SPDX-License-Identifier: MIT
// Sliders for the numbers of a scene that its lesson lets readers vary.
#pragma once

#include "app/window/panels/panel_context.h"

#include <string>

namespace polhode {

struct SlidersUsed {
  bool is_held = false;   ///< one of them is being moved
  std::string refusal{};  ///< why a value was not taken; empty: it was
};

/// In the upper left corner of the figure, the region; nothing where the scene varies no number. A double
/// click gives back the lesson's value.
SlidersUsed draw_number_sliders(LessonSession& session, const Region& figure, const ControlSizes& sizes);

}  // namespace polhode
