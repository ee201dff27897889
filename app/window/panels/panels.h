// SPDX-License-Identifier: MIT
// What stands in the panel beside the page; panel.cpp says which is where. Each in a file of its own.
#pragma once

#include "app/window/panels/panel_context.h"

namespace polhode {

void draw_outline(Desk& desk);
void draw_body(Desk& desk);
void draw_method(Desk& desk);
void draw_show(Desk& desk);
void draw_questions(Desk& desk);
void draw_save(Desk& desk);
void draw_settings(Desk& desk);
void draw_help(Desk& desk);

/// Asks for these edits once the panel is drawn: they make another model, and what is being drawn refers to
/// the present one.
void ask_for_edits(Desk& desk, const SceneEdits& edits);

}  // namespace polhode
