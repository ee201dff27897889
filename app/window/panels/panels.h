// SPDX-License-Identifier: MIT
// What stands in the panel beside the page; panel.cpp says which is where. Each in a file of its own.
#pragma once

#include "app/window/panels/panel_context.h"

namespace polhode {

void draw_outline(PanelContext& context);
void draw_body(PanelContext& context);
void draw_method(PanelContext& context);
void draw_show(PanelContext& context);
void draw_questions(PanelContext& context);
void draw_save(PanelContext& context);
void draw_settings(PanelContext& context);
void draw_help(PanelContext& context);

/// Asks for these edits once the panel is drawn: they make another model, and what is being drawn refers to
/// the present one.
void ask_for_edits(PanelContext& context, const SceneEdits& edits);

}  // namespace polhode
