// SPDX-License-Identifier: MIT
#include "app/window/speaker_notes.h"

#include "app/narration/step_notes.h"
#include "app/window/controls/widgets.h"

#include <imgui.h>

#include <cmath>

namespace polhode {

Region preview_region(const Region& page, Size window) {
  const float gap = std::round(0.02F * static_cast<float>(window.width));
  const float width = static_cast<float>(window.width) - page.width - 2 * gap;
  return {page.width + gap, 3 * gap, width, std::round(width * 0.625F)};
}

void draw_notes(PanelContext& context, const Region& page, Size window) {
  LessonSession& session = context.session;
  const Region picture = preview_region(page, window);
  const float width = static_cast<float>(window.width) - page.width,
              height = static_cast<float>(window.height);
  const bool last = !session.next_place();
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::SetNextWindowPos({page.width, 0});
  ImGui::SetNextWindowSize({width, picture.y});
  ImGui::Begin("next", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
  ImGui::TextUnformatted(last ? "This is the last step" : "Next");
  ImGui::End();
  const float below = last ? picture.y : picture.y + picture.height;
  ImGui::SetNextWindowPos({page.width, below});
  ImGui::SetNextWindowSize({width, height - below});
  ImGui::Begin("notes", nullptr, kFixed);
  ImGui::PushTextWrapPos(0);
  const int step = static_cast<int>(session.place().step) + 1;
  for (const StepNote& note : notes_of(context.speech, session.stage(), step, step)) {
    ImGui::TextUnformatted(note.text.c_str());
    ImGui::Spacing();
  }
  ImGui::PopTextWrapPos();
  ImGui::End();
}

}  // namespace polhode
