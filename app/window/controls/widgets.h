// SPDX-License-Identifier: MIT
// Small controls that Dear ImGui does not have.
#pragma once

#include "app/session/command.h"
#include "app/window/panels/panel_context.h"

#include <vector>

namespace polhode {

enum class Icon { back, next, play, pause, frame_back, frame_forward, reset, close };

/// "Next step (Right)": what a command does, and its keys.
std::string told(Command command);

/// Behind ImGui::NewFrame(): Enter presses the button that is chosen by keys, as the space bar does. Where a
/// number or a text is chosen it begins to be typed.
void let_enter_press();

/// Of the last item, a text field that is empty: its hint stands at the left, however far a text that was
/// taken from it had been scrolled.
void show_hint_from_left();
/// The field that has the keyboard goes on behind what stands in it, none of which is chosen.
void type_at_end();

/// With words beside the icon, or without; a tooltip says what it does and by which key.
bool icon_button(const char* id, Icon icon, const std::string& words, const std::string& tooltip,
                 float width);

/// A button that stays down, in a frame, while what it stands for is on.
bool toggle_button(const char* words, bool is_on, const std::string& tooltip);
/// The same without a tooltip; width 0: as its words need.
bool button_of_state(const char* words, bool is_on, float width);
/// One of a list, with a bar before the one that is chosen. `flags` are of ImGuiSelectableFlags.
bool choice_row(const char* words, bool is_on, int flags = 0);

/// One of several. Its circle is ours: that of Dear ImGui has other corners in every version.
bool radio_button(const char* words, bool is_on);

/// Behind ImGui::NewFrame(): what the pointer is on has no tooltip in this frame.
void hold_back_tooltips();
/// So long a pointer is on an item before its tooltip comes.
inline constexpr float kTooltipDelay_s = 0.5F;
/// Shown when the pointer rests on the last item.
void tooltip_of_last(const std::string& text);

/// A line of time with a knob, and a mark at each flip. The time that was pointed at while the button is
/// down.
std::optional<double> time_line(const LessonSession::Interval& interval, double t_s,
                                const std::vector<double>& flips, float width, Language language);

/// A slider whose number stands beside its thumb where that would be on it. Enter, or Ctrl and a click, types
/// a number. `format` is that of printf, with a minus sign and the decimal mark of the language in what it
/// makes. True: it was changed.
bool number_slider(const char* id, double& value, double from, double to, const char* format, int flags = 0,
                   Language language = Language::en);

/// A heading within a panel.
void heading(const char* text);
/// Words that wrap; nothing of an empty text.
void plain_words(const std::string& text);
/// Quiet words that wrap.
void quiet_words(const std::string& text);
/// In the colour of what is right.
void right_words(const std::string& text);
/// Words that wrap, in the colour of what is wrong.
void warning_words(const std::string& text);

/// Name and value in two columns; the value is "–" where it is empty.
void value_row(const char* name, const std::string& value);

}  // namespace polhode
