// SPDX-License-Identifier: MIT
// A question of the type derive in its panel: line after line, each judged as it is entered.
#pragma once

#include "app/window/panels/panel_context.h"

#include <string>

namespace polhode {

/// The goal stays in sight above the lines. `typed` is the line that is being typed.
void ask_for_derivation(PanelContext& context, const Ask& ask, std::string& typed);

/// What to use, how, and the line itself: one after the other, for the step that comes next. At the goal all
/// lines of the lesson's own.
void show_next_step(PanelContext& context, const Ask& ask);

}  // namespace polhode
