// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

namespace polhode {

namespace {

/// What the desktop wishes is known to the window, which follows it.
constexpr const char* kOfDesktop = "as the desktop";

void choose_theme(Preferences& preferences) {
  if (radio_button(kOfDesktop, !preferences.own_theme)) preferences.own_theme = false;
  for (const auto& [words, theme] : {std::pair("paper", Theme::paper), std::pair("dark", Theme::dark)}) {
    ImGui::SameLine();
    if (!radio_button(words, preferences.own_theme && preferences.theme == theme)) continue;
    preferences.theme = theme;
    preferences.own_theme = true;
  }
}

void choose_motion(Preferences& preferences) {
  ImGui::PushID("motion");
  if (radio_button(kOfDesktop, !preferences.own_motion)) preferences.own_motion = false;
  for (const auto& [words, reduced] : {std::pair("full", false), std::pair("reduced", true)}) {
    ImGui::SameLine();
    if (!radio_button(words, preferences.own_motion && preferences.reduced_motion == reduced)) continue;
    preferences.reduced_motion = reduced;
    preferences.own_motion = true;
  }
  quiet_words("Reduced: nothing fades, travels or plays by itself.");
  ImGui::PopID();
}

}  // namespace

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
  choose_theme(session.preferences);
  heading("Motion on the page");
  choose_motion(session.preferences);
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
