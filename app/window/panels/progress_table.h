// SPDX-License-Identifier: MIT
// How far a learner has come, in a panel.
#pragma once

#include "app/window/panels/panel_context.h"

namespace polhode {

/// How many questions of the lesson were answered right, and for each outcome how many of those that test it.
/// Nothing where the lesson asks nothing, and nothing before an audience.
void draw_progress(const PanelContext& context);

/// At the end of the lesson: the one to go on with, that, and the stages with questions that were answered
/// wrongly or passed over, to be clicked; before an audience the lesson alone.
void draw_summary(PanelContext& context);

}  // namespace polhode
