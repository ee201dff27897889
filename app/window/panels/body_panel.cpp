// SPDX-License-Identifier: MIT
#include "app/session/scene_edits.h"
#include "app/session/symbol_note.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "base/angles.h"
#include "base/words/answer_words.h"
#include "base/words/window_words.h"
#include "physics/body/euler.h"
#include "render/figure/omega_tip.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace polhode {

namespace {

/// The one body that turns as it does whoever looks on; others are thrown.
constexpr std::string_view kEarth = "earth";
constexpr double kEarthTurns = 7.292115e-5;  // rad/s, in a sidereal day

/// With the body comes an ω that it may have: 12 rad/s are a book's, and would tear the Earth apart.
void choose_omega(SceneEdits& edits, const Scene& scene, const Scene& lessons) {
  const bool was_earth = scene.body.name == kEarth, is_earth = edits.body && edits.body->name == kEarth;
  const double now = scene.w0_B.norm();
  if (is_earth && now > 0) edits.w0_B = Vec3(scene.w0_B * (kEarthTurns / now));
  if (!is_earth && was_earth && lessons.body.name != kEarth) edits.w0_B.reset();
}

/// Where others stand beside it, which of them is changed.
void say_which(const PanelContext& context, const Scene& scene) {
  const bool is_one = std::all_of(scene.beside.begin(), scene.beside.end(),
                                  [&](const Scene& other) { return starts_like(scene, other); });
  if (!is_one)
    quiet_words(words::kOneOfScenes.with(
        context.language(), {std::to_string(scene.before + 1), std::to_string(scene.beside.size() + 1)}));
}

void choose_body(PanelContext& context, const Scene& scene) {
  ImGui::SetNextItemWidth(-1);
  const bool is_named = find_body(scene.body.name).has_value();
  if (!ImGui::BeginCombo("##body",
                         (is_named ? scene.body.name : context.said(words::kMomentsOfItsOwn)).c_str()))
    return;
  const std::string& of_lesson = context.session.lesson_scene().body.name;
  SceneEdits edits = context.session.edits();
  const std::string lessons = find_body(of_lesson) ? words::kOfTheLesson.with(context.language(), {of_lesson})
                                                   : context.said(words::kTheLessons);
  if (choice_row(lessons.c_str(), !edits.body)) {
    edits.body.reset();
    choose_omega(edits, scene, context.session.lesson_scene());
    context.requests.edits = edits;
  }
  for (const std::string& name : named_bodies()) {
    if (name == of_lesson) continue;
    if (!choice_row(name.c_str(), edits.body && scene.body.name == name)) continue;
    edits.body = find_body(name);
    choose_omega(edits, scene, context.session.lesson_scene());
    context.requests.edits = edits;
  }
  ImGui::EndCombo();
}

/// A power of ten.
std::string raised(int power) {
  static constexpr std::array kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(power))
    text += c == '-' ? "⁻" : kDigits[static_cast<std::size_t>(c - '0')];
  return text;
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

/// Behind the slider.
void name_last(const std::string& words) {
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.c_str());
}

void show_state(const PanelContext& context, const SceneModel& model, double t_s) {
  const Vec3 w_B = model.motion->w_B_at(t_s);
  const PrincipalMoments& I = model.scene.body.moments;
  const Vec3 L_B = angular_momentum_B(I, w_B);
  const auto number = [&](std::string text) { return with_decimals(std::move(text), context.language()); };
  value_row("|ω|", number(readable(w_B.norm(), 4)) + " rad/s");
  value_row("T", number(readable(kinetic_energy(I, w_B), 4)) + " J");
  value_row("|L|", number(readable(L_B.norm(), 4)) + " kg m²/s");
  value_row(context.said(words::kAngleOfOmegaAndL).c_str(),
            w_B.isZero(0)  // where nothing turns there is no angle
                ? "–"
                : number(fmt::format("{:.2f}°", angle_between(w_B, L_B) * kDegreesPerRadian)));
}

}  // namespace

void BodyPanel::edit_moments(PanelContext& context, const Scene& scene, std::string& refusal) const {
  static constexpr std::array kNames = {"I₁", "I₂", "I₃"};
  const Vec3 present = scene.body.moments.vector();
  const double unit = std::pow(10, power_);
  const std::string ten = power_ == 0 ? "" : "10" + raised(power_) + ' ';
  for (int i = 0; i < 3; ++i) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 7.5F * ImGui::GetFontSize());
    const double low = least_moments_[i] / unit, high = most_moments_[i] / unit;
    double moment = present[i] / unit;
    ImGui::PushID(i);
    const bool is_moved = number_slider("##moment", moment, low, high, "%.4g", 0, context.language());
    name_last(fmt::format("{} {}kg m²", kNames[static_cast<std::size_t>(i)], ten));
    ImGui::PopID();
    if (!is_moved) continue;
    Vec3 moments = present;
    moments[i] = moment * unit;
    set_moments(context, moments, refusal);
  }
}

/// The length of a slider is what the other two moments allow: no moment is larger than their sum, nor
/// smaller than their difference.
void BodyPanel::set_ranges(const Scene& scene) {
  if (ImGui::IsAnyItemActive()) return;
  const Vec3& I = scene.body.moments.vector();
  constexpr double kThinnest = 1e-3;  // a rod has no moment at all about its length
  for (int i = 0; i < 3; ++i) {
    const double a = I[(i + 1) % 3], b = I[(i + 2) % 3];
    least_moments_[i] = std::max(std::abs(a - b), kThinnest * (a + b));
    most_moments_[i] = a + b;
  }
  const double power = std::floor(std::log10(I.maxCoeff()));
  power_ = power < -2 || power > 3 ? static_cast<int>(power) : 0;
  most_omega_ = scene.w0_B.isZero(0) ? 1 : 2 * scene.w0_B.norm();
  const double omega_power = std::floor(std::log10(most_omega_));
  omega_power_ = omega_power < -2 || omega_power > 3 ? static_cast<int>(omega_power) : 0;
}

void BodyPanel::edit_omega(PanelContext& context, const Scene& scene) const {
  static constexpr std::array kNames = {"ω₁", "ω₂", "ω₃"};
  const double most = most_omega_, least = -most, unit = std::pow(10, omega_power_);
  const std::string ten = omega_power_ == 0 ? "" : "10" + raised(omega_power_) + ' ';
  for (int i = 0; i < 3; ++i) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 7.5F * ImGui::GetFontSize());
    double component = scene.w0_B[i];
    ImGui::PushID(i);
    component /= unit;
    const bool is_moved =
        number_slider("##omega", component, least / unit, most / unit, "%.5g", 0, context.language());
    component *= unit;
    name_last(fmt::format("{} {}rad/s", kNames[static_cast<std::size_t>(i)], ten));
    ImGui::PopID();
    if (!is_moved) continue;
    SceneEdits edits = context.session.edits();
    edits.w0_B = scene.w0_B;
    (*edits.w0_B)[i] = component;
    context.requests.edits = edits;
  }
  const bool is_drawn = draws_omega(*context.session.model());
  if (scene.body.name == kEarth) quiet_words(context.said(words::kEarthTurns));
  quiet_words(context.said(is_drawn ? words::kBodyAxesOrDrag : words::kBodyAxes));
}

void BodyPanel::draw(PanelContext& context, std::string& refusal) {
  LessonSession& session = context.session;
  if (!session.model()) return quiet_words(context.said(words::kStepHasNoFigure));
  heading(context.said(words::kBodyPanel).c_str());
  say_which(context, session.model()->scene);
  set_ranges(session.model()->scene);
  choose_body(context, session.model()->scene);
  edit_moments(context, session.model()->scene, refusal);
  if (!refusal.empty()) warning_words(refusal);
  heading(context.said(words::kAngularVelocity).c_str());
  edit_omega(context, session.model()->scene);
  heading(context.said(words::kAtPresent).c_str());
  show_state(context, *session.model(), session.t_s());
  ImGui::Dummy({0, 0.4F * ImGui::GetFontSize()});
  ImGui::BeginDisabled(session.edits().empty());
  if (ImGui::Button(context.said(words::kBackToScene).c_str(), {-1, 0})) session.reset_edits();
  ImGui::EndDisabled();
  tooltip_of_last(told(Command::reset_scene));
}

}  // namespace polhode
