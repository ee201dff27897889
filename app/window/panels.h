// SPDX-License-Identifier: MIT
// What stands in the panel beside the page; panel.cpp says which is where. Each in a file of its own.
#pragma once

#include "app/window/desk.h"

namespace polhode {

void draw_outline(Desk& desk);
void draw_body(Desk& desk);
void draw_method(Desk& desk);
void draw_show(Desk& desk);
void draw_questions(Desk& desk);
void draw_save(Desk& desk);
void draw_settings(Desk& desk);
void draw_help(Desk& desk);

/// What was edited, told in the panel if it could not be.
void set_edits_or_say(Desk& desk, const SceneEdits& edits);

}  // namespace polhode
