// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "base/angles.h"
#include "physics/body/euler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

namespace polhode {

namespace {

void choose_body(PanelContext& context, const Scene& scene) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##body", scene.body.name.empty() ? "own moments" : scene.body.name.c_str())) return;
  const std::string& of_lesson = context.session.lesson_scene().body.name;
  SceneEdits edits = context.session.edits();
  if (ImGui::Selectable(fmt::format("{} (the lesson's)", of_lesson).c_str(), !edits.body)) {
    edits.body.reset();
    context.requests.edits = edits;
  }
  for (const std::string& name : named_bodies()) {
    if (!ImGui::Selectable(name.c_str(), scene.body.name == name)) continue;
    edits.body = find_body(name);
    context.requests.edits = edits;
  }
  ImGui::EndCombo();
}

/// What cannot be is not set, and says why.
void set_moments(PanelContext& context, const Vec3& moments, std::string& refusal) {
  const auto body = body_with_moments(moments);
  refusal = body ? "" : body.error();
  if (!body) return;
  SceneEdits edits = context.session.edits();
  edits.body = *body;
  context.requests.edits = edits;
}

void show_state(const SceneModel& model, double t_s) {
  const Vec3 w_B = model.motion->w_B_at(t_s);
  const PrincipalMoments& I = model.scene.body.moments;
  const Vec3 L_B = angular_momentum_B(I, w_B);
  value_row("|ω|", fmt::format("{:.4g} rad/s", w_B.norm()));
  value_row("T", fmt::format("{:.5g} J", kinetic_energy(I, w_B)));
  value_row("|L|", fmt::format("{:.5g} kg m²/s", L_B.norm()));
  value_row("angle of ω and L", fmt::format("{:.2f}°", angle_between(w_B, L_B) * kDegreesPerRadian));
}

}  // namespace

void BodyPanel::edit_moments(PanelContext& context, const Scene& scene, std::string& refusal) const {
  static constexpr std::array kNames = {"I1", "I2", "I3"};
  const Vec3 present = scene.body.moments.vector();
  const double high = most_moment_, low = 1e-4 * high;
  for (int i = 0; i < 3; ++i) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6.5F * ImGui::GetFontSize());
    Vec3 moments = present;
    if (ImGui::SliderScalar(fmt::format("{} kg m²", kNames[static_cast<std::size_t>(i)]).c_str(),
                            ImGuiDataType_Double, &moments[i], &low, &high, "%.4g",
                            ImGuiSliderFlags_Logarithmic))
      set_moments(context, moments, refusal);
  }
}

void BodyPanel::set_ranges(const Scene& scene) {
  if (ImGui::IsAnyItemActive()) return;
  most_moment_ = 10 * scene.body.moments.vector().maxCoeff();
  most_omega_ = scene.w0_B.isZero(0) ? 1 : 2 * scene.w0_B.norm();
}

void BodyPanel::edit_omega(PanelContext& context, const Scene& scene) const {
  static constexpr std::array kNames = {"ω1", "ω2", "ω3"};
  const double most = most_omega_, least = -most;
  for (int i = 0; i < 3; ++i) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6.5F * ImGui::GetFontSize());
    double component = scene.w0_B[i];
    if (!ImGui::SliderScalar(fmt::format("{} rad/s", kNames[static_cast<std::size_t>(i)]).c_str(),
                             ImGuiDataType_Double, &component, &least, &most, "%.4f"))
      continue;
    SceneEdits edits = context.session.edits();
    edits.w0_B = scene.w0_B;
    (*edits.w0_B)[i] = component;
    context.requests.edits = edits;
  }
  quiet_words("Body axes, at t = 0. Or take the tip of ω in the figure.");
}

void BodyPanel::draw(PanelContext& context, std::string& refusal) {
  LessonSession& session = context.session;
  if (!session.model()) return quiet_words("This step has no figure.");
  heading("Body");
  set_ranges(session.model()->scene);
  choose_body(context, session.model()->scene);
  edit_moments(context, session.model()->scene, refusal);
  if (!refusal.empty()) warning_words(refusal);
  heading("Angular velocity");
  edit_omega(context, session.model()->scene);
  heading("Now");
  show_state(*session.model(), session.t_s());
  ImGui::Dummy({0, 0.4F * ImGui::GetFontSize()});
  ImGui::BeginDisabled(session.edits().empty());
  if (ImGui::Button("Back to the lesson's scene", {-1, 0})) session.reset_edits();
  ImGui::EndDisabled();
  tooltip_of_last(told(Command::reset_scene));
}

}  // namespace polhode
