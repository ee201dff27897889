// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

namespace polhode {

void draw_settings(PanelContext& context) {
  LessonSession& session = context.session;
  heading("Text size");
  if (ImGui::Button("smaller")) session.change_text_scale(-1);
  tooltip_of_last(told(Command::smaller_text));
  ImGui::SameLine();
  if (ImGui::Button("larger")) session.change_text_scale(1);
  tooltip_of_last(told(Command::larger_text));
  ImGui::SameLine();
  ImGui::BeginDisabled(session.preferences.text_scale == 1);
  if (ImGui::Button("100 %")) session.preferences.text_scale = 1;
  ImGui::EndDisabled();
  tooltip_of_last(told(Command::normal_text));
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("now {:.0f} %", 100 * session.preferences.text_scale).c_str());
  heading("Theme");
  Theme& theme = session.preferences.theme;
  if (radio_button("paper", theme == Theme::paper)) theme = Theme::paper;
  ImGui::SameLine();
  if (radio_button("dark", theme == Theme::dark)) theme = Theme::dark;
  heading("Motion on the page");
  ImGui::Checkbox("reduced: nothing fades or travels", &session.preferences.reduced_motion);
  heading("Keys");
  ImGui::Checkbox("letters are commands", &session.preferences.letter_keys);
  quiet_words(
      "Without it only arrows, Space and keys with Ctrl or F1 to F12 do something; the buttons below the "
      "page "
      "do the rest.");
  heading("For an audience");
  if (ImGui::Button("Present", {-1, 0})) session.set_presenting(true);
  tooltip_of_last(told(Command::present) + "; " + told(Command::notes));
  if (ImGui::Button("Full screen", {-1, 0})) context.requests.full_screen = true;
  tooltip_of_last(told(Command::full_screen));
}

}  // namespace polhode
