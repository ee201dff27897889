// SPDX-License-Identifier: MIT
// What questions of several types have in their panel: a field for an answer, and what is said of the
// keyboard.
#pragma once

#include "app/session/answers/answer_keys.h"
#include "app/window/panels/panel_context.h"

#include <string>

namespace polhode {

/// A field with room for a button of these words behind it. True if Enter was pressed and there is a text.
/// A panel that was opened by a key begins in its first field.
bool text_field(PanelContext& context, const char* id, const char* form, const char* button,
                std::string& typed);
/// Behind a field: Tab that has reached it goes on into it.
void take_keyboard_by_tab(PanelContext& context);
/// Behind a field that took Enter: it keeps the keyboard for another try, or lets go of it.
void keep_typing(bool is_wanted);
/// Below a field: whether keys go to it, to the panel or to the page. Takes the same room in each case.
void say_who_has_keys(const PanelContext& context);

/// Of a question that was answered right before: by what, and why it is right.
void show_accepted(PanelContext& context, const Ask& ask);

/// A button that puts the body of a counterexample into the figure; nothing where it has none to show.
void show_it_button(PanelContext& context, const Counterexample& counter);

}  // namespace polhode
