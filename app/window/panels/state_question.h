// SPDX-License-Identifier: MIT
// A question of the type state in its panel: goals, how far they are, and controls of just what may be
// changed.
#pragma once

#include "app/window/panels/panel_context.h"

namespace polhode {

/// The answer is given by the button Check: reaching a goal on the way to somewhere else is none. True:
/// it is answered right, by the motion that is shown or before.
bool ask_for_state(PanelContext& context, const Ask& ask);

}  // namespace polhode
