// SPDX-License-Identifier: MIT
#include "app/session/symbol_note.h"
#include "app/session/words/method_words.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "physics/method.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {

namespace {

/// For methods that have one: a 64th of the time of a turn.
double usual_step_s(const SceneModel& model) {
  const double speed = model.scene.w0_B.norm();
  return speed > 0 ? 2 * std::numbers::pi / speed / 64 : 0.01;
}

/// Empty where there is no number.
std::string number_with_unit(double value, const char* unit) {
  const std::string number = readable(value, 2);
  return number.empty() ? number : number + unit;
}

void set_motion(PanelContext& context, const MotionSpec& motion) {
  SceneEdits edits = context.session.edits();
  edits.motion = motion;
  context.requests.edits = edits;
}

std::string time_text(double ns) {
  if (ns < 1e3) return fmt::format("{:.3g} ns", ns);
  return ns < 1e6 ? fmt::format("{:.3g} µs", ns / 1e3) : fmt::format("{:.3g} ms", ns / 1e6);
}

Method method_of(const SceneModel& model) {
  return model.scene.motion.method.value_or(default_method(problem_of(model.scene)));
}

/// What cannot serve is there, and says why.
void choose_method(PanelContext& context, const SceneModel& model) {
  const Problem problem = problem_of(model.scene);
  const Method present = method_of(model);
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##method", std::string(name_of(present)).c_str(), ImGuiComboFlags_HeightLarge))
    return;
  for (const MethodFacts& facts : all_methods()) {
    const auto reason = why_not(facts.method, problem);
    const auto flags = reason ? ImGuiSelectableFlags_Disabled : ImGuiSelectableFlags_None;
    if (choice_row(std::string(facts.name).c_str(), facts.method == present, flags)) {
      MotionSpec motion{
          .method = facts.method, .step_s = {}, .tolerance = {}, .ghost = model.scene.motion.ghost};
      if (facts.control == StepControl::fixed)
        motion.step_s = model.scene.motion.step_s.value_or(usual_step_s(model));
      set_motion(context, motion);
    }
    tooltip_of_last(reason ? *reason : fmt::format("{}; keeps {}", facts.term, facts.keeps));
  }
  ImGui::EndCombo();
}

void choose_step(PanelContext& context, const SceneModel& model) {
  const MethodFacts& facts = facts_of(method_of(model));
  MotionSpec motion = model.scene.motion;
  if (facts.control == StepControl::none) return quiet_words("A closed form: any t at once, no step.");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6 * ImGui::GetFontSize());
  if (facts.control == StepControl::fixed) {
    double step = motion.step_s.value_or(usual_step_s(model));
    const double low = usual_step_s(model) / 256, high = usual_step_s(model) * 16;
    const bool is_moved = number_slider("##step", step, low, high, "%.4g", ImGuiSliderFlags_Logarithmic);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted("step, s");
    if (is_moved) {
      motion.step_s = step;
      set_motion(context, motion);
    }
  } else {
    double tolerance = motion.tolerance.value_or(kDefaultTolerance);
    const double low = 1e-14, high = 1e-2;
    const bool is_moved =
        number_slider("##tolerance", tolerance, low, high, "%.1e", ImGuiSliderFlags_Logarithmic);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted("tolerance");
    if (is_moved) {
      motion.method = facts.method;
      motion.tolerance = tolerance;
      set_motion(context, motion);
    }
  }
}

/// Whatever the method and what is shown.
bool same_problem(const Scene& a, const Scene& b) {
  return a.body == b.body && a.w0_B == b.w0_B && a.attitude == b.attitude && a.torque == b.torque;
}

/// Where the present method is: with its step or tolerance, or one within a factor of two.
std::optional<int> place_on(const std::vector<ParetoStep>& steps, const SceneModel& model) {
  const MotionSpec& motion = model.scene.motion;
  const auto size_of = [](const std::optional<double>& step_s, const std::optional<double>& tolerance) {
    return step_s.value_or(tolerance.value_or(1));
  };
  const double present = size_of(motion.step_s, motion.tolerance);
  std::optional<int> best;
  double least = std::log(2.0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const MethodChoice& choice = steps[i].choice;
    const double off = std::abs(std::log(size_of(choice.step_s, choice.tolerance) / present));
    if (choice.method != method_of(model) || off > least) continue;
    least = off;
    best = static_cast<int>(i);
  }
  return best;
}

/// A panel has its new height, and its scroll bar, two frames after it has new contents.
constexpr int kFramesToSettle = 3;

const char* why_no_error(const SceneModel& model) {
  return facts_of(method_of(model)).control == StepControl::none ? "the reference" : "no closed form";
}

void choose_quality(PanelContext& context, const SceneModel& model) {
  for (const QualityLevel level : {QualityLevel::draft, QualityLevel::normal, QualityLevel::fine}) {
    if (level != QualityLevel::draft) ImGui::SameLine();
    if (!radio_button(name_of(level), model.scene.quality == level)) continue;
    SceneEdits edits = context.session.edits();
    edits.quality = level;
    context.requests.edits = edits;
  }
  value_row("picture, per frame", fmt::format("{:.0f} ms", context.frame_ms));
}

/// How far the sides of the step's claims are apart at this moment, of the size of their terms, and what
/// rounding and method allow.
void show_residuals(const LessonSession& session, const LiveState& live) {
  bool is_first = true;
  for (const Claim* claim : blocks_of<Claim>(session.step())) {
    if (claim->kind == ClaimKind::is_false || !can_be_shown(*claim, session.model()->scene)) continue;
    const auto value = live_value(*claim, live, View::space);
    if (!value) continue;
    if (is_first) heading("Both sides of the equations differ by");
    is_first = false;
    value_row(claim->equation.c_str(), value->tolerance > kDecisive
                                           ? "the step is too long to tell"
                                           : fmt::format("{}, allowed {}", readable(value->residual, 1),
                                                         readable(value->tolerance, 1)));
  }
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all.empty() ? "nothing" : all;
}

}  // namespace

void MethodPanel::choose_from_front(PanelContext& context, const SceneModel& model) {
  if (!(front_of_ && same_problem(*front_of_, model.scene)) && !ImGui::IsAnyItemActive()) {
    front_.reset();
    front_ = std::make_unique<FrontMeasurement>(problem_of(model.scene));
    front_of_ = model.scene;
  }
  if (!front_ || !front_->is_ready()) {
    frames_to_settle_ = kFramesToSettle;
    return quiet_words("measuring the methods on this motion …");
  }
  const std::vector<ParetoStep>& steps = front_->steps();
  if (steps.empty()) return quiet_words("Nothing could be measured on this motion.");
  const auto present = place_on(steps, model);
  int chosen = present.value_or(0);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##front", &chosen, 0, static_cast<int>(steps.size()) - 1, "")) {
    const MethodChoice& choice = steps[static_cast<std::size_t>(chosen)].choice;
    set_motion(context, {.method = choice.method,
                         .step_s = choice.step_s,
                         .tolerance = choice.tolerance,
                         .ghost = model.scene.motion.ghost});
    return;  // the model is another one now
  }
  ImGui::TextDisabled("fast");
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize("accurate").x);
  ImGui::TextDisabled("accurate");
  if (!present)
    return quiet_words(
        "Each step of the slider is the fastest for its accuracy. The present method is none of them.");
  const ParetoStep& step = steps[static_cast<std::size_t>(*present)];
  const bool is_reference = facts_of(step.choice.method).control == StepControl::none;
  const std::string error = is_reference ? "what the errors of the others are against"
                                         : "error after 10 periods " + number_with_unit(step.error, "");
  quiet_words(fmt::format("{}: {}, {} a period", step.name, error, time_text(step.ns_per_period)));
}

void MethodPanel::show_accuracy(PanelContext& context, const SceneModel& model) {
  if (!meter_ || meter_of_ != context.session.model_number()) {
    meter_ = std::make_unique<AccuracyMeter>(model);
    meter_of_ = context.session.model_number();
    read_at_s_ = -1;
  }
  constexpr double kReadable_s = 0.2;
  const bool at_rest = !context.session.is_moving() && read_of_t_s_ != context.session.t_s();
  if (at_rest || context.clock_s - read_at_s_ > kReadable_s || read_at_s_ < 0) {
    now_ = meter_->at(model, context.session.t_s());
    live_ = live_state(model, context.session.t_s());
    read_at_s_ = context.clock_s;
    read_of_t_s_ = context.session.t_s();
  }
  value_row("error of ω", now_.error ? number_with_unit(now_.error->omega, "") : why_no_error(model));
  value_row("error of attitude", now_.error ? number_with_unit(now_.error->attitude_rad, " rad") : "");
  value_row("drift of T", number_with_unit(now_.drift.T, ""));
  value_row("drift of |L|", number_with_unit(now_.drift.L, ""));
  value_row("drift of L's direction", number_with_unit(now_.drift.L_direction_rad, " rad"));
  value_row("motion, per frame", time_text(now_.ns_per_frame));
  if (live_) show_residuals(context.session, *live_);
}

std::optional<double> MethodPanel::seconds_to_wake() const {
  if (frames_to_settle_ == 0) return std::nullopt;
  return frames_to_settle_ == kFramesToSettle ? 0.1 : 0.0;
}

void MethodPanel::draw(PanelContext& context, const std::string& refusal) {
  LessonSession& session = context.session;
  if (!session.model()) return quiet_words("This step has no figure.");
  heading("From fast to accurate");
  // As high as it becomes: when the methods are measured nothing falls from under the pointer.
  constexpr float kLinesBelow = 3;  // the ends of the slider, and what is said of the present method
  const float end = ImGui::GetCursorPosY() + ImGui::GetFrameHeightWithSpacing() +
                    kLinesBelow * ImGui::GetTextLineHeightWithSpacing();
  choose_from_front(context, *session.model());
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), end));
  heading("Method");
  choose_method(context, *session.model());
  choose_step(context, *session.model());
  if (!refusal.empty()) warning_words(refusal);
  bool ghost = session.model()->scene.motion.ghost;
  const std::string why_not = why_idle(session, Command::ghost);
  ImGui::BeginDisabled(!why_not.empty());
  if (ImGui::Checkbox("the exact body beside it, as a ghost", &ghost)) {
    MotionSpec motion = session.model()->scene.motion;
    motion.ghost = ghost;
    set_motion(context, motion);
  }
  ImGui::EndDisabled();
  tooltip_of_last(why_not);
  heading("Now");
  show_accuracy(context, *session.model());
  heading("Picture");
  choose_quality(context, *session.model());
  heading("What the scene requires");
  const RequirementWords words = requirement_words(*session.model());
  quiet_words(fmt::format("{}: {}", session.model()->motion->method(), why_method(session)));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(("Computed: " + joined(words.computed)).c_str());
  ImGui::TextUnformatted(("Not computed: " + joined(words.left_out)).c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace polhode
