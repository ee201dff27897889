// SPDX-License-Identifier: MIT
#include "app/session/command.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <imgui.h>

namespace polhode {

void draw_help(PanelContext&) {
  std::string_view group;
  for (const CommandFacts& facts : all_commands()) {
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
      "In a panel that a key has opened arrows go from control to control. Space presses a button, and takes "
      "a "
      "slider, which arrows then move; Enter types a number into it. F6 goes back to the page. After a click "
      "in "
      "a panel arrows and Space are the page's.");
  heading("Mouse");
  quiet_words(
      "Rest on a symbol for its meaning and value. Drag the figure to turn it, the wheel zooms, a double "
      "click puts it back; take the tip of ω to start another motion. The wheel over the text scrolls it. "
      "Rest on a plot for its values, click or drag there for the time.");
}

}  // namespace polhode
