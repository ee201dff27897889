// SPDX-License-Identifier: MIT
#include "app/session/symbol_note.h"
#include "app/session/words/method_words.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "base/angles.h"
#include "base/words/verdict_words.h"
#include "base/words/window_words.h"
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
  if (facts.control == StepControl::none) return quiet_words(context.said(words::kClosedForm));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6 * ImGui::GetFontSize());
  if (facts.control == StepControl::fixed) {
    double step = motion.step_s.value_or(usual_step_s(model));
    const double low = usual_step_s(model) / 256, high = usual_step_s(model) * 16;
    const bool is_moved =
        number_slider("##step", step, low, high, "%.4g", ImGuiSliderFlags_Logarithmic, context.language());
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted(context.said(words::kStepS).c_str());
    if (is_moved) {
      motion.step_s = step;
      set_motion(context, motion);
    }
  } else {
    double tolerance = motion.tolerance.value_or(kDefaultTolerance);
    const double low = 1e-14, high = 1e-2;
    const bool is_moved = number_slider("##tolerance", tolerance, low, high, "%.1e",
                                        ImGuiSliderFlags_Logarithmic, context.language());
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted(context.said(words::kTolerance).c_str());
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

const Phrase& why_no_error(const SceneModel& model) {
  const bool is_closed = facts_of(method_of(model)).control == StepControl::none;
  return is_closed ? words::kTheReference : words::kNoClosedForm;
}

const Phrase& words_of(QualityLevel level) {
  return level == QualityLevel::draft  ? words::kDraft
         : level == QualityLevel::fine ? words::kFine
                                       : words::kNormal;
}

void choose_quality(PanelContext& context, const SceneModel& model) {
  for (const QualityLevel level : {QualityLevel::draft, QualityLevel::normal, QualityLevel::fine}) {
    if (level != QualityLevel::draft) ImGui::SameLine();
    if (!radio_button(context.said(words_of(level)).c_str(), model.scene.quality == level)) continue;
    SceneEdits edits = context.session.edits();
    edits.quality = level;
    context.requests.edits = edits;
  }
  value_row(context.said(words::kPicturePerFrame).c_str(), fmt::format("{:.0f} ms", context.frame_ms));
}

/// How far the sides of the step's claims are apart at this moment, of the size of their terms, and what
/// rounding and method allow.
void show_residuals(const PanelContext& context, const LiveState& live) {
  const LessonSession& session = context.session;
  const auto number = [&](double value) { return with_decimals(readable(value, 1), context.language()); };
  bool is_first = true;
  for (const Claim* claim : blocks_of<Claim>(session.step())) {
    if (claim->kind == ClaimKind::is_false || !can_be_shown(*claim, session.model()->scene)) continue;
    const auto value = live_value(*claim, live, View::space);
    if (!value) continue;
    if (is_first) heading(context.said(words::kSidesDiffer).c_str());
    is_first = false;
    value_row(
        claim->equation.c_str(),
        value->tolerance > kDecisive
            ? context.said(words::kStepTooLong)
            : words::kAllowed.with(context.language(), {number(value->residual), number(value->tolerance)}));
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
    return quiet_words(context.said(words::kMeasuring));
  }
  const std::vector<ParetoStep>& steps = front_->steps();
  if (steps.empty()) return quiet_words(context.said(words::kNotMeasured));
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
  const std::string fast = context.said(words::kFast), accurate = context.said(words::kAccurate);
  ImGui::TextDisabled("%s", fast.c_str());
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(accurate.c_str()).x);
  ImGui::TextDisabled("%s", accurate.c_str());
  if (!present) return quiet_words(context.said(words::kNotOnFront));
  const ParetoStep& step = steps[static_cast<std::size_t>(*present)];
  const bool is_reference = facts_of(step.choice.method).control == StepControl::none;
  const auto number = [&](std::string text) { return with_decimals(std::move(text), context.language()); };
  const std::string error =
      is_reference ? context.said(words::kReferenceOfOthers)
                   : words::kErrorAfterPeriods.with(context.language(), {number(readable(step.error, 2))});
  quiet_words(words::kFrontStep.with(context.language(), {named_in(context.language(), step.choice), error,
                                                          number(time_text(step.ns_per_period))}));
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
  const auto row = [&](const Phrase& name, const std::string& value) {
    value_row(context.said(name).c_str(), with_decimals(value, context.language()));
  };
  const auto degrees = [](double rad) { return number_with_unit(kDegreesPerRadian * rad, " °"); };
  row(words::kErrorOfOmega,
      now_.error ? number_with_unit(now_.error->omega, "") : context.said(why_no_error(model)));
  row(words::kErrorOfAttitude, now_.error ? degrees(now_.error->attitude_rad) : "");
  row(words::kChangeOfT, number_with_unit(now_.drift.T, ""));
  row(words::kChangeOfL, number_with_unit(now_.drift.L, ""));
  row(words::kChangeOfDirection, degrees(now_.drift.L_direction_rad));
  row(words::kMotionPerFrame, time_text(now_.ns_per_frame));
  if (live_) show_residuals(context, *live_);
}

std::optional<double> MethodPanel::seconds_to_wake() const {
  if (frames_to_settle_ == 0) return std::nullopt;
  return frames_to_settle_ == kFramesToSettle ? 0.1 : 0.0;
}

void MethodPanel::draw(PanelContext& context, const std::string& refusal) {
  LessonSession& session = context.session;
  if (!session.model()) return quiet_words(context.said(words::kStepHasNoFigure));
  heading(context.said(words::kFromFastToAccurate).c_str());
  // As high as it becomes: when the methods are measured nothing falls from under the pointer.
  constexpr float kLinesBelow = 3;  // the ends of the slider, and what is said of the present method
  const float end = ImGui::GetCursorPosY() + ImGui::GetFrameHeightWithSpacing() +
                    kLinesBelow * ImGui::GetTextLineHeightWithSpacing();
  choose_from_front(context, *session.model());
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), end));
  heading(context.said(words::kMethod).c_str());
  choose_method(context, *session.model());
  choose_step(context, *session.model());
  if (!refusal.empty()) warning_words(refusal);
  bool ghost = session.model()->scene.motion.ghost;
  const std::string why_not = why_idle(session, Command::ghost);
  ImGui::BeginDisabled(!why_not.empty());
  if (ImGui::Checkbox(context.said(words::kGhostBeside).c_str(), &ghost)) {
    MotionSpec motion = session.model()->scene.motion;
    motion.ghost = ghost;
    set_motion(context, motion);
  }
  ImGui::EndDisabled();
  tooltip_of_last(why_not);
  heading(context.said(words::kNowAndSince).c_str());
  show_accuracy(context, *session.model());
  heading(context.said(words::kPicture).c_str());
  choose_quality(context, *session.model());
  heading(context.said(words::kWhatSceneRequires).c_str());
  const RequirementWords words = requirement_words(*session.model());
  quiet_words(fmt::format("{}: {}", session.model()->motion->method(), why_method(session)));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(("Computed: " + joined(words.computed)).c_str());
  ImGui::TextUnformatted(("Not computed: " + joined(words.left_out)).c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace polhode
