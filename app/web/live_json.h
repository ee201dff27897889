// SPDX-License-Identifier: MIT
// What live_api.h says of a figure, as JSON. Numbers read back as the same doubles; what is not finite is
// null.
#pragma once

#include "app/web/live_figure.h"

#include <string>

namespace polhode {

/// polhode_state(): null without a scene. `message` is the last refusal.
std::string state_json(LiveFigure& figure, const std::string& message);
/// polhode_choices(), polhode_words(): likewise.
std::string choices_json(const LiveFigure& figure);
std::string words_json(LiveFigure& figure);

}  // namespace polhode
