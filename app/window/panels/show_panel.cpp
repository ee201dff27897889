// SPDX-License-Identifier: MIT
#include "app/session/figure_interaction.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <imgui.h>

#include <algorithm>

namespace polhode {

namespace {

std::string words_of(Overlay overlay) {
  if (overlay == Overlay::omega) return "ω";
  std::string words(name_of(overlay));
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

void choose_views(LessonSession& session, PanelContext& context) {
  const std::vector<View>& views = session.model()->scene.views;
  const auto offer = [&](const char* words, const std::vector<View>& offered) {
    if (!radio_button(words, views == offered)) return;
    SceneEdits edits = session.edits();
    edits.views = offered;
    context.requests.edits = edits;
  };
  offer("space", {View::space});
  ImGui::SameLine();
  offer("body", {View::body});
  ImGui::SameLine();
  offer("both", {View::space, View::body});
}

void choose_camera(LessonSession& session) {
  bool following = session.is_following();
  if (ImGui::Checkbox("follow the body", &following)) session.set_following(following);
  tooltip_of_last(told(Command::follow));
  bool first = true;
  for (const CameraPreset& preset : camera_presets()) {
    const float width = ImGui::CalcTextSize(preset.name.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (!first && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <
                      ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
      ImGui::SameLine();
    first = false;
    if (ImGui::Button(preset.name.c_str())) session.set_camera(preset.camera);
  }
  if (ImGui::Button("the lesson's camera", {-1, 0})) session.set_camera(session.lesson_scene().camera);
  tooltip_of_last("Or double-click the figure; drag to turn, wheel to zoom");
}

void offer_overlay(PanelContext& context, Overlay overlay) {
  LessonSession& session = context.session;
  const SceneModel& model = *session.model();
  bool shown = model.scene.show.contains(overlay);
  const bool nothing_to_see = shown && !model.drawn.contains(overlay);
  if (ImGui::Checkbox(words_of(overlay).c_str(), &shown)) {
    SceneEdits edits = session.edits();
    set_shown(edits, session.lesson_scene(), overlay, shown);
    context.requests.edits = edits;
  }
  if (!nothing_to_see) return;
  ImGui::SameLine();
  ImGui::TextDisabled("nothing to see here");
}

}  // namespace

void ShowPanel::draw(PanelContext& context, const std::string& refusal) {
  LessonSession& session = context.session;
  if (!session.model()) return quiet_words("This step has no figure.");
  heading("Seen from");
  choose_views(session, context);
  heading("Camera");
  choose_camera(session);
  heading("In space");
  if (!refusal.empty()) warning_words(refusal);
  const auto offer_all = [&](bool diagrams) {
    for (int i = 0; i < kOverlayCount; ++i)
      if (const auto overlay = static_cast<Overlay>(i); is_diagram(overlay) == diagrams)
        offer_overlay(context, overlay);
  };
  offer_all(false);
  heading("Diagrams");
  offer_all(true);
}

}  // namespace polhode
