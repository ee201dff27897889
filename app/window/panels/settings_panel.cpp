// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

namespace polhode {

namespace {

/// What the desktop wishes is known to the window, which follows it.
bool follows_desktop(const PanelContext& context, bool is_on) {
  return radio_button(context.said(words::kAsDesktop).c_str(), is_on);
}

void choose_theme(const PanelContext& context, Preferences& preferences) {
  if (follows_desktop(context, !preferences.own_theme)) preferences.own_theme = false;
  for (const auto& [words, theme] :
       {std::pair(words::kPaper, Theme::paper), std::pair(words::kDark, Theme::dark)}) {
    ImGui::SameLine();
    if (!radio_button(context.said(words).c_str(), preferences.own_theme && preferences.theme == theme))
      continue;
    preferences.theme = theme;
    preferences.own_theme = true;
  }
}

void choose_motion(const PanelContext& context, Preferences& preferences) {
  ImGui::PushID("motion");
  if (follows_desktop(context, !preferences.own_motion)) preferences.own_motion = false;
  for (const auto& [words, reduced] : {std::pair(words::kFull, false), std::pair(words::kReduced, true)}) {
    ImGui::SameLine();
    if (!radio_button(context.said(words).c_str(),
                      preferences.own_motion && preferences.reduced_motion == reduced))
      continue;
    preferences.reduced_motion = reduced;
    preferences.own_motion = true;
  }
  quiet_words(context.said(words::kWhatReducedIs));
  ImGui::PopID();
}

}  // namespace

void draw_settings(PanelContext& context) {
  LessonSession& session = context.session;
  heading(context.said(words::kTextSize).c_str());
  if (ImGui::Button(context.said(words::kSmaller).c_str())) session.change_text_scale(-1);
  tooltip_of_last(told(Command::smaller_text));
  ImGui::SameLine();
  if (ImGui::Button(context.said(words::kLarger).c_str())) session.change_text_scale(1);
  tooltip_of_last(told(Command::larger_text));
  ImGui::SameLine();
  ImGui::BeginDisabled(session.preferences.text_scale == 1);
  if (ImGui::Button("100 %")) session.preferences.text_scale = 1;
  ImGui::EndDisabled();
  tooltip_of_last(told(Command::normal_text));
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const std::string percent = fmt::format("{:.0f}", 100 * session.preferences.text_scale);
  ImGui::TextUnformatted(words::kNowPercent.with(context.language(), {percent}).c_str());
  heading(context.said(words::kTheme).c_str());
  choose_theme(context, session.preferences);
  heading(context.said(words::kMotionOnPage).c_str());
  choose_motion(context, session.preferences);
  heading(context.said(words::kKeys).c_str());
  ImGui::Checkbox(context.said(words::kLettersAreCommands).c_str(), &session.preferences.letter_keys);
  quiet_words(context.said(words::kWithoutLetters));
  heading(context.said(words::kForAnAudience).c_str());
  if (ImGui::Button(context.said(words::kPresent).c_str(), {-1, 0})) session.set_presenting(true);
  tooltip_of_last(told(Command::present));
  if (ImGui::Button(context.said(words::kPresentWithWindow).c_str(), {-1, 0})) session.set_speaker(true);
  tooltip_of_last(told(Command::notes));
  if (ImGui::Button(context.said(words::kFullScreen).c_str(), {-1, 0})) context.requests.full_screen = true;
  tooltip_of_last(told(Command::full_screen));
}

}  // namespace polhode
