// SPDX-License-Identifier: MIT
#include "app/window/screen/figure_marks.h"

#include "app/session/omega_drag.h"
#include "app/session/symbol_note.h"
#include "app/window/controls/widgets.h"
#include "lessons/reader/questions/state_task.h"
#include "physics/body/euler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace polhode {

namespace {

bool is_to_be_dragged(const LessonSession& session) {
  const std::vector<const Ask*> asks = session.questions();
  return !session.is_aside() && std::any_of(asks.begin(), asks.end(), [](const Ask* ask) {
    return ask->task && ask->task->change.contains(Steered::omega);
  });
}

std::string words_at_tip(const LessonSession& session, TipHand hand) {
  if (hand == TipHand::away) return "drag";
  if (hand == TipHand::near) return "drag: another ω with the same T; Shift: its length";
  const SceneModel& model = *session.model();
  const Vec3 w = model.motion->w_B_at(session.t_s());
  const std::string omega = fmt::format("ω = ({:.3g}, {:.3g}, {:.3g}) rad/s", w[0], w[1], w[2]);
  if (hand == TipHand::turns) return omega + ", T kept";
  return fmt::format("{}, T = {} J, not kept", omega,
                     readable(kinetic_energy(model.scene.body.moments, w), 3));
}

void label(ImDrawList& list, ImVec2 at, const std::string& words, float pad) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  list.AddRectFilled({at.x - pad, at.y - 0.5F * pad}, {at.x + size.x + pad, at.y + size.y + 0.5F * pad},
                     ImGui::GetColorU32(ImGuiCol_WindowBg), pad);
  list.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
}

/// Whether something else is shown than the lesson's. A camera is turned back by a double click, and numbers
/// that readers may vary have sliders of their own.
bool is_changed(SceneEdits edits) {
  edits.camera.reset();
  edits.numbers.clear();
  return !edits.empty();
}

/// Whether a tip of ω is, with what is written beside it, where the chip stands in the right corner.
bool hides_a_tip(const LessonSession& session, const std::vector<Inset>& insets, const Region& figure,
                 const ControlSizes& sizes) {
  constexpr float kChipHeight = 6, kRoom = 3;  // em
  if (session.model() == nullptr) return false;
  const float left = figure.x + figure.width - std::min(19 * sizes.em, 0.6F * figure.width) - sizes.padding,
              low = figure.y + sizes.padding + kChipHeight * sizes.em, room = kRoom * sizes.em;
  const std::vector<TipOnScreen> tips = omega_tips(*session.model(), session.t_s(), insets);
  return std::any_of(tips.begin(), tips.end(), [&](const TipOnScreen& tip) {
    return tip.x > static_cast<double>(left - room) && tip.y < static_cast<double>(low + room);
  });
}

std::string words_of_chip(const LessonSession& session) {
  const Counterexample* counter = session.counterexample();
  if (counter == nullptr)
    return session.is_aside() ? "a body for which an answer failed, then changed by hand" : "changed by hand";
  return fmt::format("a body for which it fails: {}", counter->state);
}

}  // namespace

void draw_drag_marks(const LessonSession& session, const std::vector<Inset>& insets, TipHand hand,
                     float right, const ControlSizes& sizes) {
  if ((!is_to_be_dragged(session) && hand == TipHand::away) || session.model() == nullptr) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float radius = 0.7F * sizes.em;
  const std::string words = words_at_tip(session, hand);
  for (const TipOnScreen& tip : omega_tips(*session.model(), session.t_s(), insets)) {
    const ImVec2 at{static_cast<float>(tip.x), static_cast<float>(tip.y)};
    list.AddCircle(at, radius, ImGui::GetColorU32(ImGuiCol_WindowBg), 32, 0.3F * sizes.em);
    list.AddCircle(at, radius, ImGui::GetColorU32(ImGuiCol_NavHighlight), 32, 0.13F * sizes.em);
    const float beside = at.x + 1.6F * radius, last = right - ImGui::CalcTextSize(words.c_str()).x - sizes.em;
    // One that has to reach over the ring stands above it.
    label(list, {std::min(beside, last), at.y - (beside > last ? 3.2F : 2.2F) * radius}, words,
          0.4F * sizes.em);
  }
}

void draw_size_chip(LessonSession& session, bool is_too_small, const Region& figure,
                    const ControlSizes& sizes) {
  if (session.is_presenting() || (!session.is_enlarged() && !is_too_small)) return;
  ImGui::SetNextWindowPos({figure.x + figure.width - sizes.padding, figure.y + figure.height - sizes.padding},
                          ImGuiCond_Always, {1, 1});
  ImGui::Begin("size-of-figure", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  if (ImGui::Button(session.is_enlarged() ? "Beside the text" : "Larger"))
    session.set_enlarged(!session.is_enlarged());
  tooltip_of_last(told(Command::enlarge));
  ImGui::End();
}

void draw_scene_chip(LessonSession& session, const std::vector<Inset>& insets, bool is_held,
                     const Region& figure, const ControlSizes& sizes) {
  constexpr float kBothButtons = 18;  // em: on one line
  if (is_held || (!session.is_aside() && !is_changed(session.edits()))) return;
  const bool leftward = hides_a_tip(session, insets, figure, sizes);
  ImGui::SetNextWindowPos({leftward ? figure.x + sizes.padding : figure.x + figure.width - sizes.padding,
                           figure.y + sizes.padding},
                          ImGuiCond_Always, {leftward ? 0.0F : 1.0F, 0});
  ImGui::Begin("changed-scene", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(std::min(19 * sizes.em, 0.6F * figure.width));
  ImGui::TextUnformatted(words_of_chip(session).c_str());
  ImGui::PopTextWrapPos();
  if (session.is_aside()) {
    if (ImGui::Button("Back to what was shown")) session.leave_counterexample();
  } else {
    ImGui::BeginDisabled(!session.can_undo());
    if (ImGui::Button("Undo")) session.undo();
    ImGui::EndDisabled();
    tooltip_of_last(told(Command::undo));
    if (figure.width > kBothButtons * sizes.em) ImGui::SameLine();
    if (ImGui::Button("Back to the lesson's")) session.reset_edits();
    tooltip_of_last(told(Command::reset_scene));
  }
  ImGui::End();
}

}  // namespace polhode
