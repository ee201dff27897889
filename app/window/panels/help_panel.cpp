// SPDX-License-Identifier: MIT
#include "app/session/command.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "base/words/window_words.h"

#include <imgui.h>

#include <algorithm>

namespace polhode {

namespace {

/// There is nothing to choose here: arrows and Page keys move the text.
void scroll_by_keys() {
  const float line = 3 * ImGui::GetTextLineHeightWithSpacing(), page = 0.85F * ImGui::GetWindowHeight();
#if IMGUI_VERSION_NUM < 18700
  const auto is_pressed = [](ImGuiKey_ key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
#else
  const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key); };
#endif
  float to = ImGui::GetScrollY();
  if (is_pressed(ImGuiKey_DownArrow)) to += line;
  if (is_pressed(ImGuiKey_UpArrow)) to -= line;
  if (is_pressed(ImGuiKey_PageDown)) to += page;
  if (is_pressed(ImGuiKey_PageUp)) to -= page;
  if (is_pressed(ImGuiKey_Home)) to = 0;
  if (is_pressed(ImGuiKey_End)) to = ImGui::GetScrollMaxY();
  if (to != ImGui::GetScrollY()) ImGui::SetScrollY(std::clamp(to, 0.0F, ImGui::GetScrollMaxY()));
}

}  // namespace

void draw_help(PanelContext& context) {
  if (context.has_keys) scroll_by_keys();
  if (!context.session.preferences.letter_keys) quiet_words(context.said(words::kLettersAreNoCommands));
  std::string_view group;
  for (const CommandFacts& facts : all_commands()) {
    // Before an audience its key is that of the black screen.
    if (facts.command == Command::body && context.session.is_presenting()) continue;
    if (facts.group != group) heading(std::string(group = facts.group).c_str());
    const float left = 8.2F * ImGui::GetFontSize();
    ImGui::PushTextWrapPos(left);
    ImGui::TextDisabled("%s", std::string(facts.keys).c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(left);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(std::string(facts.does).c_str());
    ImGui::PopTextWrapPos();
  }
  heading("In a panel");
  quiet_words(
      "In a panel that a key has opened arrows go from control to control; here they scroll. Space presses a "
      "button, and takes a slider, which arrows then move; Enter types a number into it. F6 goes back to the "
      "page. After a click in a panel arrows and Space are the page's.");
  heading("Questions");
  quiet_words(
      "While Answer is open a letter or a digit picks that choice, or begins what is typed. Tab leaves "
      "a field for the next control and comes back to it, Escape leaves it for the page.");
  heading("Lines that turn into others");
  quiet_words("Left and then Right plays the way of a line again.");
  heading("Mouse");
  quiet_words(
      "Rest on a symbol for its meaning and value. Drag the figure to turn it, the wheel zooms, a double "
      "click puts it back; take the tip of ω to start another motion with the same T, with Shift to change "
      "its length. The wheel over the text scrolls it. "
      "Rest on a plot for its values, click or drag there for the time. The right button offers what can be "
      "done with the text or the figure there.");
}

}  // namespace polhode
