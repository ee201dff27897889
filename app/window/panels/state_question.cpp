// SPDX-License-Identifier: MIT
#include "app/window/panels/state_question.h"

#include "app/session/answers/answer_text.h"
#include "app/session/steering.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "base/angles.h"
#include "base/words/answer_words.h"
#include "base/words/edition_words.h"
#include "base/words/page_words.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "physics/body/euler.h"
#include "physics/body/euler_angles.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

namespace {

/// What a slider changes: its name as it is set, and its unit.
struct Name {
  const char* tex;
  const char* unit;
};
using Names = std::array<Name, 3>;

/// Between its name and its number, which the thumb would hide. True while it is moved.
bool slider(PanelContext& context, const Name& name, double& value, double from, double to,
            const char* format) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float left = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const float of_name = 1.6F * em, of_number = 6.6F * em;
  ImGui::PushID(name.tex);
  const float top = ImGui::GetCursorPosY(), above = ImGui::GetStyle().FramePadding.y;
  ImGui::SetCursorPosY(top + above);
  context.texts.show(formula_text(name.tex));
  ImGui::SetCursorPos({left + of_name, top});
  ImGui::SetNextItemWidth(room - of_name - of_number - gap);
  const bool is_moved = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &from, &to, "");
  ImGui::PopID();
  ImGui::SameLine(0, gap);
  ImGui::AlignTextToFramePadding();
  const std::string number = fmt::format(fmt::runtime(format), std::abs(value));
  const bool is_zero = number.find_first_not_of("0.") == number.npos;
  const std::string signed_number = (value < 0 && !is_zero ? "−" : "") + number + name.unit;
  ImGui::TextUnformatted(with_decimals(signed_number, context.session.lesson().about.language).c_str());
  return is_moved;
}

/// Three of them; true while one is moved.
bool sliders(PanelContext& context, const Names& names, Vec3& values, double from, double to,
             const char* format) {
  bool moved = false;
  for (int i = 0; i < 3; ++i)
    moved = slider(context, names[static_cast<std::size_t>(i)], values[i], from, to, format) || moved;
  return moved;
}

constexpr Names kOmegas = {{{"\\omega_1", " rad/s"}, {"\\omega_2", " rad/s"}, {"\\omega_3", " rad/s"}}};
constexpr Names kMoments = {{{"I_1", " kg m²"}, {"I_2", " kg m²"}, {"I_3", " kg m²"}}};
constexpr Names kAngles = {{{"\\varphi", "°"}, {"\\theta", "°"}, {"\\psi", "°"}}};
constexpr Names kTorques = {{{"N_1", " N m"}, {"N_2", " N m"}, {"N_3", " N m"}}};
constexpr Names kTorquesInSpace = {{{"N_x", " N m"}, {"N_y", " N m"}, {"N_z", " N m"}}};

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
    if (!sliders(context_, kOmegas, w0_B, -most, most, "{:.3f}")) return;
    edits_.w0_B = w0_B;
    changed_ = true;
  }

  void moments() {
    Vec3 I = now_.body.moments.vector();
    const double largest = lesson_.body.moments.vector().maxCoeff();
    if (!sliders(context_, kMoments, I, 0.01 * largest, 2 * largest, "{:.4g}")) return;
    const auto body = body_with_moments(I);
    if (!body) return;  // the slider springs back to what can be
    edits_.body = *body;
    changed_ = true;
  }

  void attitude() {
    const EulerAngles now = euler_angles_of(problem_of(now_).start.q_SB);
    Vec3 angles = Vec3(now.phi_rad, now.theta_rad, now.psi_rad) / kRadiansPerDegree;
    if (!sliders(context_, kAngles, angles, -180, 180, "{:.1f}")) return;
    angles[1] = std::clamp(angles[1], 0.0, 180.0);
    const Vec3 rad = angles * kRadiansPerDegree;
    edits_.attitude = attitude_of({rad[0], rad[1], rad[2]});
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
    if (!sliders(context_, in_space ? kTorquesInSpace : kTorques, N, -most, most, "{:.4g}")) return;
    edits_.torque =
        with_constant(now_.torque, in_space ? TorqueTerm(SpaceTorque{N}) : TorqueTerm(BodyTorque{N}));
    changed_ = true;
  }

  void time() {
    const LessonSession::Interval line = context_.session.time_line();
    double t_s = context_.session.t_s();
    if (!slider(context_, {"t", " s"}, t_s, line.from_s, line.to_s, "{:.3f}")) return;
    context_.session.set_playing(false);
    context_.session.scrub_to(t_s);
  }

  PanelContext& context_;
  const StateTask& task_;
  const Scene &lesson_, &now_;
  SceneEdits edits_;
  bool changed_ = false;
};

/// So that no line ends between a number and its unit.
std::string kept_together(std::string words, const std::string& unit) {
  const std::string apart = ' ' + unit;
  for (std::size_t at = words.find(apart); !unit.empty() && at != words.npos; at = words.find(apart, at))
    words.replace(at, 1, "\u00A0");
  return words;
}

RichText words_of_goal(const Lesson& lesson, const StateGoal& goal) {
  const Language language = lesson.about.language;
  RichText text = goal.say.empty() ? formula_text(tex_of(goal.number.expression, &lesson.notation.vocabulary))
                                   : line_text(goal.say);
  text = in_a_row(std::move(text),
                  words_text((goal.is ? " = " : " ") +
                             kept_together(range_of(goal, language), goal.number.written.unit)));
  return opened_by(std::string(words::kGoal.in(language)), std::move(text));
}

/// "35.2°, 4.8° too small"
std::string words_of_reading(const StateGoal& goal, const GoalReading& reading, Language language) {
  if (!reading.value) return std::string(words::kNotDefinedOnThis.in(language));
  const auto number = [&](double value) {
    return kept_together(with_decimals(value_text(goal, reading, value), language), goal.number.written.unit);
  };
  const std::string is = number(*reading.value);
  if (reading.is_reached) return is;
  const Phrase& off = reading.off < 0 ? words::kTooSmall : words::kTooLarge;
  return off.with(language, {is, number(std::abs(reading.off))});
}

/// The page beside may show another time than the one at which the motion is looked at.
void show_goal(PanelContext& context, const StateGoal& goal, const GoalReading& reading, bool is_at_start) {
  const Lesson& lesson = context.session.lesson();
  context.texts.show(words_of_goal(lesson, goal), TextInk::quiet);
  const std::string reads = words_of_reading(goal, reading, lesson.about.language);
  const Phrase& phrase = reading.is_reached ? (is_at_start ? words::kReachedAtStart : words::kReached)
                                            : (is_at_start ? words::kNowAtStart : words::kNow);
  const std::string line = phrase.with(lesson.about.language, {reads});
  reading.is_reached ? right_words(line) : plain_words(line);
}

void offer_check(PanelContext& context, const Ask& ask, const Steering& steering) {
  const Language language = context.session.lesson().about.language;
  const std::string state = text_of(steering.state);
  ImGui::BeginDisabled(!steering.elsewhere.empty() || state.empty());
  if (ImGui::Button(std::string(words::kCheck.in(language)).c_str(), {-1, 0}))
    context.session.answer(ask, state);
  ImGui::EndDisabled();
}

void offer_way_back(LessonSession& session) {
  ImGui::BeginDisabled(session.edits().empty());
  const std::string words(words::kBackToScene.in(session.lesson().about.language));
  if (ImGui::Button(words.c_str(), {-1, 0})) session.reset_edits();
  ImGui::EndDisabled();
  tooltip_of_last(told(Command::reset_scene));
}

/// It stands as long as the motion is the one that was judged. True: it is right, or one was before.
bool show_verdict(PanelContext& context, const Ask& ask, const Steering& steering) {
  using Mark = AnswerJudgement::Mark;
  const Language language = context.session.lesson().about.language;
  const std::string state = text_of(steering.state);
  const JudgedAnswer* judged = context.session.judged(ask);
  const AnswerRecord* record = context.session.record(ask);
  const bool is_of_now = judged != nullptr && judged->text == state;
  const bool is_right = is_of_now && judged->judgement.mark == Mark::right,
             was_right = !is_of_now && record != nullptr && record->right > 0;
  if (is_of_now) {
    std::string verdict = told_verdict(ask, judged->text, judged->judgement, language).verdict;
    for (const StateGoal& goal : ask.task->goals)
      verdict = kept_together(std::move(verdict), goal.number.written.unit);
    is_right ? right_words(verdict) : warning_words(verdict);
  }
  if (is_right) {
    context.texts.show(text_after(ask, judged->judgement));
  } else if (was_right) {
    show_accepted(context, ask);
  }
  return is_right || was_right;
}

}  // namespace

bool ask_for_state(PanelContext& context, const Ask& ask) {
  LessonSession& session = context.session;
  const Language language = session.lesson().about.language;
  const auto said = [language](const Phrase& phrase) { return std::string(phrase.in(language)); };
  const StateTask& task = *ask.task;
  if (session.is_aside()) {
    quiet_words(said(words::kShowsAnotherBody));
    return false;
  }
  const Steering steering = steering_of(session, task);
  const bool is_at_start = !task.change.contains(Steered::t);
  for (std::size_t i = 0; i < task.goals.size(); ++i)
    show_goal(context, task.goals[i], steering.goals[i], is_at_start);
  context.texts.show(given_text(task, language));
  if (!steering.elsewhere.empty()) {
    warning_words(words::kChangedToo.with(language, {steering.elsewhere}));
    if (ImGui::Button(said(words::kPutItBack).c_str(), {-1, 0}))
      context.requests.edits = put_back(session.edits(), task);
  }
  if (task.change.contains(Steered::omega) && session.model()->drawn.contains(Overlay::omega))
    quiet_words(said(words::kDragOrSlide));
  Controls(context, task).draw();
  // What is said of an answer comes and goes: it stands below all that is pressed.
  offer_check(context, ask, steering);
  offer_way_back(session);
  return show_verdict(context, ask, steering);
}

}  // namespace polhode
