// SPDX-License-Identifier: MIT
// How far a learner has come, in a panel.
#pragma once

#include "app/window/panels/panel_context.h"

namespace polhode {

/// How many questions of the lesson were answered right, and for each outcome how many of those that test it.
/// Nothing where the lesson asks nothing.
void draw_progress(const PanelContext& context);

/// At the end of the lesson: that, the stages with questions that were not answered right, to be clicked, and
/// the lesson to go on with.
void draw_summary(PanelContext& context);

}  // namespace polhode
