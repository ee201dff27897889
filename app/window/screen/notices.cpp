// SPDX-License-Identifier: MIT
#include "app/window/screen/notices.h"

#include <imgui.h>

namespace polhode {

namespace {

constexpr double kSeconds = 6;

}  // namespace

void Notices::tell(const std::string& text, double clock_s) {
  text_ = text;
  told_s_ = clock_s;
  until_s_ = clock_s + kSeconds;
}

std::optional<double> Notices::seconds_left(double clock_s) const {
  if (text_.empty() || clock_s >= until_s_) return std::nullopt;
  return until_s_ - clock_s;
}

void Notices::draw(const Region& page, Theme theme, float padding, double clock_s) const {
  std::string text = page_error_.empty() ? lesson_errors_ : page_error_;
  if (seconds_left(clock_s)) text += (text.empty() ? "" : "\n\n") + text_;
  if (text.empty()) return;
  const bool is_error = !page_error_.empty() || !lesson_errors_.empty();
  const Color accent = colors_of(theme).accent;
  const float most = page.width - 2 * padding;
  ImGui::SetNextWindowPos({page.x + padding, page.y + page.height - padding}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {most, 0.6F * page.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_Border, is_error ? ImVec4{accent.r, accent.g, accent.b, 1}
                                                  : ImGui::GetStyleColorVec4(ImGuiCol_Border));
  ImGui::Begin("strip", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PushTextWrapPos(most - 3 * padding);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace polhode
