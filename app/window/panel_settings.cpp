// SPDX-License-Identifier: MIT
#include "app/window/panels.h"
#include "app/window/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace polhode {

void draw_settings(Desk& desk) {
  Companion& companion = desk.companion;
  heading("Text size");
  if (ImGui::Button("smaller")) companion.change_text_scale(-1);
  tooltip_of_last("Smaller type (-)");
  ImGui::SameLine();
  if (ImGui::Button("larger")) companion.change_text_scale(1);
  tooltip_of_last("Larger type (+)");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("{:.0f} %", 100 * companion.preferences.text_scale).c_str());
  heading("Theme");
  Theme& theme = companion.preferences.theme;
  if (ImGui::RadioButton("paper", theme == Theme::paper)) theme = Theme::paper;
  ImGui::SameLine();
  if (ImGui::RadioButton("dark", theme == Theme::dark)) theme = Theme::dark;
  heading("Motion on the page");
  ImGui::Checkbox("reduced: nothing fades or travels", &companion.preferences.reduced_motion);
  heading("For an audience");
  if (ImGui::Button("Present", {-1, 0})) companion.presenting = true;
  tooltip_of_last("The page alone; Esc comes back, N shows what comes next and what to say (P)");
  if (ImGui::Button("Full screen", {-1, 0})) desk.wishes.full_screen = true;
  tooltip_of_last("On and off (F)");
}

}  // namespace polhode
