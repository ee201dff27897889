// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

namespace polhode {

void draw_settings(Desk& desk) {
  Companion& companion = desk.companion;
  heading("Text size");
  if (ImGui::Button("smaller")) companion.change_text_scale(-1);
  tooltip_of_last(told(Command::smaller_text));
  ImGui::SameLine();
  if (ImGui::Button("larger")) companion.change_text_scale(1);
  tooltip_of_last(told(Command::larger_text));
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("{:.0f} %", 100 * companion.preferences.text_scale).c_str());
  heading("Theme");
  Theme& theme = companion.preferences.theme;
  if (radio_button("paper", theme == Theme::paper)) theme = Theme::paper;
  ImGui::SameLine();
  if (radio_button("dark", theme == Theme::dark)) theme = Theme::dark;
  heading("Motion on the page");
  ImGui::Checkbox("reduced: nothing fades or travels", &companion.preferences.reduced_motion);
  heading("For an audience");
  if (ImGui::Button("Present", {-1, 0})) companion.set_presenting(true);
  tooltip_of_last(told(Command::present) + "; " + told(Command::notes));
  if (ImGui::Button("Full screen", {-1, 0})) desk.wishes.full_screen = true;
  tooltip_of_last(told(Command::full_screen));
}

}  // namespace polhode
