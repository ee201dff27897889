// SPDX-License-Identifier: MIT
#include "app/window/panels/state_question.h"

#include "app/session/steering.h"
#include "app/window/controls/widgets.h"
#include "base/angles.h"
#include "physics/body/euler.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace polhode {

namespace {

/// A slider with its name behind it. True while it is moved.
bool slider(const char* name, double& value, double from, double to, const char* format) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6.5F * ImGui::GetFontSize());
  return ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &from, &to, format);
}

using Names = std::array<const char*, 3>;

/// Three of them; true while one is moved.
bool sliders(const Names& names, Vec3& values, double from, double to, const char* format) {
  bool moved = false;
  for (int i = 0; i < 3; ++i)
    moved = slider(names[static_cast<std::size_t>(i)], values[i], from, to, format) || moved;
  return moved;
}

/// The ends of a slider stand while the reader changes the scene: they are of the lesson's.
class Controls {
 public:
  Controls(PanelContext& context, const StateTask& task)
      : context_(context),
        task_(task),
        lesson_(*task.scene),
        now_(context.session.model()->scene),
        edits_(context.session.edits()) {}

  void draw() {
    if (task_.change.contains(Steered::omega)) omega();
    if (task_.change.contains(Steered::moments)) moments();
    if (task_.change.contains(Steered::attitude)) attitude();
    if (task_.change.contains(Steered::torque)) torque();
    if (task_.change.contains(Steered::t)) time();
    if (changed_) context_.requests.edits = edits_;
  }

 private:
  void omega() {
    Vec3 w0_B = now_.w0_B;
    const double most = lesson_.w0_B.isZero(0) ? 1 : 2 * lesson_.w0_B.norm();
    if (!sliders({"ω₁ rad/s", "ω₂ rad/s", "ω₃ rad/s"}, w0_B, -most, most, "%.4f")) return;
    edits_.w0_B = w0_B;
    changed_ = true;
  }

  void moments() {
    Vec3 I = now_.body.moments.vector();
    const double largest = lesson_.body.moments.vector().maxCoeff();
    if (!sliders({"I₁ kg m²", "I₂ kg m²", "I₃ kg m²"}, I, 0.01 * largest, 2 * largest, "%.4g")) return;
    const auto body = body_with_moments(I);
    if (!body) return;  // the slider springs back to what can be
    edits_.body = *body;
    changed_ = true;
  }

  void attitude() {
    Vec3 angles = euler_angles(problem_of(now_).start.q_SB) / kRadiansPerDegree;
    if (!sliders({"φ °", "θ °", "ψ °"}, angles, -180, 180, "%.1f")) return;
    angles[1] = std::clamp(angles[1], 0.0, 180.0);
    edits_.attitude = attitude_of(angles * kRadiansPerDegree);
    changed_ = true;
  }

  void torque() {
    const TorqueTerm present = constant_torque(now_.torque);
    const bool in_space = std::holds_alternative<SpaceTorque>(present);
    Vec3 N = components_of(present);
    // What holds ω where it is lies within: that is as large as ω×L.
    const Vec3 L_B = angular_momentum_B(lesson_.body.moments, lesson_.w0_B);
    const double most = std::max({2 * lesson_.w0_B.cross(L_B).norm(),
                                  2 * components_of(constant_torque(lesson_.torque)).norm(),
                                  0.1 * lesson_.w0_B.dot(L_B), 1e-6});
    const Names names =
        in_space ? Names{"N x N m", "N y N m", "N z N m"} : Names{"N₁ N m", "N₂ N m", "N₃ N m"};
    if (!sliders(names, N, -most, most, "%.4g")) return;
    edits_.torque =
        with_constant(now_.torque, in_space ? TorqueTerm(SpaceTorque{N}) : TorqueTerm(BodyTorque{N}));
    changed_ = true;
  }

  void time() {
    const LessonSession::Interval line = context_.session.time_line();
    double t_s = context_.session.t_s();
    if (!slider("t s", t_s, line.from_s, line.to_s, "%.3f")) return;
    context_.session.set_playing(false);
    context_.session.scrub_to(t_s);
  }

  PanelContext& context_;
  const StateTask& task_;
  const Scene &lesson_, &now_;
  SceneEdits edits_;
  bool changed_ = false;
};

void show_goal(const StateGoal& goal, const GoalReading& reading) {
  quiet_words(fmt::format("Goal: {} {}{}", goal.words(), goal.is ? "= " : "", range_of(goal)));
  if (reading.is_reached) return right_words("Reached: now " + words_of(goal, reading) + ".");
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(("Now " + words_of(goal, reading) + ".").c_str());
  ImGui::PopTextWrapPos();
}

/// The verdict stands as long as the motion is the one that was judged.
void check(PanelContext& context, const Ask& ask, const Steering& steering) {
  using Mark = AnswerJudgement::Mark;
  const std::string state = text_of(steering.state);
  ImGui::BeginDisabled(!steering.elsewhere.empty() || state.empty());
  if (ImGui::Button("Check", {-1, 0})) context.session.answer(ask, state);
  ImGui::EndDisabled();
  const JudgedAnswer* judged = context.session.judged(ask);
  const AnswerRecord* record = context.session.record(ask);
  if (judged != nullptr && judged->text == state && judged->judgement.mark == Mark::right) {
    right_words("Right.");
    plain_words(context.speech.words_after(ask, judged->judgement));
  } else if (judged != nullptr && judged->text == state) {
    warning_words(fmt::format("Not right: {}.", judged->judgement.reason));
  } else if (record != nullptr && record->right > 0) {
    quiet_words("You have answered this one right.");
  }
}

}  // namespace

void ask_for_state(PanelContext& context, const Ask& ask) {
  LessonSession& session = context.session;
  const StateTask& task = *ask.task;
  if (session.is_aside()) return quiet_words("The figure shows another body. Go back to this one first.");
  const Steering steering = steering_of(session, task);
  for (std::size_t i = 0; i < task.goals.size(); ++i) show_goal(task.goals[i], steering.goals[i]);
  if (!task.change.contains(Steered::t)) quiet_words("At t = 0, as the motion is set going.");
  if (!steering.elsewhere.empty()) {
    warning_words(fmt::format("Changed too: {}. This question is about the lesson's.", steering.elsewhere));
    if (ImGui::Button("Put it back", {-1, 0})) context.requests.edits = put_back(session.edits(), task);
  }
  if (task.change.contains(Steered::omega) && session.model()->drawn.contains(Overlay::omega))
    quiet_words("Drag the tip of ω in the figure, which keeps T, or use the sliders.");
  Controls(context, task).draw();
  check(context, ask, steering);
  ImGui::BeginDisabled(session.edits().empty());
  if (ImGui::Button("Back to the lesson's scene", {-1, 0})) session.reset_edits();
  ImGui::EndDisabled();
  tooltip_of_last(told(Command::reset_scene));
}

void show_it_button(PanelContext& context, const Counterexample& counter) {
  if (!counter.body || !context.session.has_scene()) return;
  const Counterexample* shown = context.session.counterexample();
  const bool is_shown = shown != nullptr && shown->state == counter.state;
  ImGui::BeginDisabled(is_shown);
  if (ImGui::Button(is_shown ? "It is in the figure" : "Show it in the figure"))
    context.requests.counterexample = counter;
  ImGui::EndDisabled();
}

}  // namespace polhode
