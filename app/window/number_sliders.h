// SPDX-License-Identifier: MIT
// Sliders for the numbers of a scene that its lesson lets readers vary.
#pragma once

#include "app/window/panels/panel_context.h"

#include <string>

namespace polhode {

/// At the upper edge of the figure, the region; nothing where the scene varies no number. A double click
/// gives back the lesson's value.
/// @return why a value was refused; empty: it was not
std::string draw_number_sliders(LessonSession& session, const Region& figure, const ControlSizes& sizes);

}  // namespace polhode
