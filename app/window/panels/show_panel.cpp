// SPDX-License-Identifier: MIT
#include "app/session/camera_moves.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "base/words/speech_words.h"
#include "base/words/window_words.h"
#include "render/figure/omega_tip.h"
#include "render/scene/model/scene_needs.h"

#include <imgui.h>

#include <algorithm>

namespace polhode {

namespace {

/// As alternative texts call it, in English without the article.
std::string words_of(Overlay overlay, Language language) {
  if (overlay == Overlay::labels) return std::string(words::kNamesAtArrows.in(language));
  std::string words(facts_of(overlay).words.in(language));
  if (language != Language::en) return words;
  for (const std::string_view article : {"the ", "a ", "an "})
    if (words.starts_with(article)) words.erase(0, article.size());
  return words;
}

/// On as many lines as the words take, which Dear ImGui's own does not.
bool wrapped_checkbox(const std::string& words, bool& is_on) {
  const bool changed = ImGui::Checkbox(("##" + words).c_str(), &is_on);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::PushTextWrapPos(0);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
  const bool is_clicked = ImGui::IsItemClicked();
  if (is_clicked) is_on = !is_on;
  return changed || is_clicked;
}

void choose_views(LessonSession& session, PanelContext& context) {
  const std::vector<View>& views = session.model()->scene.views;
  const auto offer = [&](const Phrase& words, const std::vector<View>& offered) {
    if (!radio_button(context.said(words).c_str(), views == offered)) return;
    SceneEdits edits = session.edits();
    edits.views = offered;
    context.requests.edits = edits;
  };
  offer(words::kSpace, {View::space});
  ImGui::SameLine();
  offer(words::kFromBody, {View::body});
  ImGui::SameLine();
  offer(words::kBoth, {View::space, View::body});
}

const Phrase& words_of_camera(std::string_view preset) {
  if (preset == "front") return words::kFromFront;
  if (preset == "side") return words::kFromSide;
  if (preset == "top") return words::kFromTop;
  return preset == "below" ? words::kFromBelow : words::kFromThreeQuarter;
}

void choose_camera(LessonSession& session, const PanelContext& context) {
  bool following = session.is_following();
  if (ImGui::Checkbox(context.said(words::kFollowBody).c_str(), &following)) session.set_following(following);
  tooltip_of_last(told(Command::follow));
  bool first = true;
  for (const CameraPreset& preset : camera_presets()) {
    const std::string name = context.said(words_of_camera(preset.name));
    const float width = ImGui::CalcTextSize(name.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (!first && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <
                      ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
      ImGui::SameLine();
    first = false;
    if (ImGui::Button(name.c_str())) session.set_camera(preset.camera);
  }
  if (ImGui::Button(context.said(words::kLessonsCamera).c_str(), {-1, 0}))
    session.set_camera(session.lesson_scene().camera);
  tooltip_of_last(context.said(words::kOrDoubleClick));
}

void offer_overlay(PanelContext& context, Overlay overlay) {
  LessonSession& session = context.session;
  const SceneModel& model = *session.model();
  const bool is_lessons =
      !model.scene.show.contains(overlay) && model.needs.marks && has_arrow_along(model.scene, overlay);
  bool shown = is_lessons || model.scene.show.contains(overlay);
  const std::string unseen = what_is_unseen(overlay, model.scene);
  // Of what would not be seen there is no picture.
  constexpr float kPicture = 2.7F;  // em, in height
  const float before = ImGui::GetCursorPosY(), left = ImGui::GetCursorPosX(),
              height = kPicture * context.sizes.em;
  if (unseen.empty())
    context.pictures.show(overlay, model.scene, session.preferences.theme, height, !session.is_moving());
  const float below = ImGui::GetCursorPosY();
  ImGui::SetCursorPos({left + height * 4 / 3 + ImGui::GetStyle().ItemSpacing.x, before});
  ImGui::BeginDisabled(is_lessons);
  const bool is_changed = wrapped_checkbox(words_of(overlay, context.language()), shown) && !is_lessons;
  ImGui::EndDisabled();
  if (is_changed) {
    SceneEdits edits = session.edits();
    set_shown(edits, session.lesson_scene(), overlay, shown);
    context.requests.edits = edits;
  }
  if (const std::string note = is_lessons ? context.said(words::kDrawnByLesson) : unseen; !note.empty()) {
    const float indent = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + height * 4 / 3 +
                         ImGui::GetStyle().ItemSpacing.x;
    ImGui::Indent(indent);
    quiet_words(note);
    ImGui::Unindent(indent);
  }
  if (unseen.empty()) ImGui::SetCursorPosY(std::max(below, ImGui::GetCursorPosY()));
}

}  // namespace

void ShowPanel::draw(PanelContext& context, const std::string& refusal) {
  LessonSession& session = context.session;
  if (!session.model()) return quiet_words(context.said(words::kStepHasNoFigure));
  heading(context.said(words::kSeenFrom).c_str());
  choose_views(session, context);
  heading(context.said(words::kCamera).c_str());
  choose_camera(session, context);
  heading(context.said(words::kInSpace).c_str());
  if (!refusal.empty()) warning_words(refusal);
  const auto offer_all = [&](bool diagrams) {
    for (int i = 0; i < kOverlayCount; ++i)
      if (const auto overlay = static_cast<Overlay>(i); is_diagram(overlay) == diagrams)
        offer_overlay(context, overlay);
  };
  offer_all(false);
  heading(context.said(words::kDiagrams).c_str());
  offer_all(true);
}

}  // namespace polhode
