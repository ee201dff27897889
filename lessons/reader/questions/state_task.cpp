// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/state_task.h"

#include "base/words/page_words.h"
#include "lessons/claims/proof/counterexample_text.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace polhode {
namespace {

std::string with_unit(const std::string& number, const std::string& unit) {
  if (unit.empty() || unit == "1") return number;
  if (unit == "deg" || unit == "°") return number + "°";
  return number + ' ' + unit;
}

/// So many decimals as show `digits` digits of it.
int decimals_for(double value, int digits) {
  return digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// A number to the tenth of what matters: of the tolerance; but far from its goal with three digits, or so
/// many as show two of what it is off.
std::string number_with_digits(double value, double tolerance, const GoalReading& reading) {
  if (!(tolerance > 0)) return number_text(value);
  const int most = decimals_for(tolerance, 2);
  int few = reading.value && *reading.value != 0 ? decimals_for(*reading.value, 3) : most;
  if (!reading.is_reached && reading.off != 0) few = std::max(few, decimals_for(reading.off, 2));
  const int decimals = std::clamp(std::min(few, most), 0, 12);
  constexpr double kMostWritten = 1e9;
  if (!(std::abs(value) < kMostWritten)) return number_text(value);
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == text.npos;
  return value < 0 && !is_zero ? "−" + text : text;
}

/// What is to be told apart: half the range, or a hundredth of its one end.
double tolerance_of(const StateGoal& goal) {
  if (goal.least && goal.most) return 0.5 * (*goal.most - *goal.least);
  const double end = std::abs(goal.least ? *goal.least : goal.most.value_or(0));
  return 0.01 * (end > 0 ? end : 1);
}

AnswerJudgement unreadable(std::string reason, std::string hint = {}, int column = 0) {
  AnswerJudgement judgement;
  judgement.mark = AnswerJudgement::Mark::unreadable;
  judgement.reason = std::move(reason);
  judgement.hint = std::move(hint);
  judgement.column = column;
  return judgement;
}

/// Whether an angle in it is that of a vector of length 0, which has none; atan2(0, 0) is 0 elsewhere, so
/// that plots go through the pole.
bool has_angle_of_nothing(const Expression& expression, MotionNumbers& motion) {
  const auto is_zero = [&](int index) {
    const auto end = expression.nodes.begin() + index + 1;
    const Expression part{expression.text, {expression.nodes.begin(), end}, expression.constants};
    return motion.value_of(part) == 0.0;
  };
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), [&](const ExpressionNode& node) {
    return node.operation == Operation::atan2 && is_zero(node.a) && is_zero(node.b);
  });
}

}  // namespace

std::string range_of(const StateGoal& goal, Language language) {
  const std::string& unit = goal.number.written.unit;
  const auto number = [&](double value) { return with_decimals(number_text(value), language); };
  const auto text = [&](double value) { return with_unit(number(value), unit); };
  if (goal.is) {
    // As in 20° ± 1°, 3 ± 1 and (3 ± 0.1) s.
    const bool is_degrees = unit == "deg" || unit == "°", has_none = unit.empty() || unit == "1";
    const std::string within = number(*goal.most - *goal.is);
    if (is_degrees) return text(*goal.is) + " ± " + within + "°";
    const std::string both = number(*goal.is) + " ± " + within;
    return has_none ? both : '(' + both + ") " + unit;
  }
  if (goal.least && goal.most) return words::kBetween.with(language, {text(*goal.least), text(*goal.most)});
  return goal.least ? words::kAtLeast.with(language, {text(*goal.least)})
                    : words::kAtMost.with(language, {text(*goal.most)});
}

double judged_time_s(const StateTask& task, double t_s) { return task.change.contains(Steered::t) ? t_s : 0; }

std::vector<GoalReading> read_goals(const StateTask& task, const SceneModel& model, double t_s,
                                    const Effort& effort) {
  MotionNumbers motion(model, t_s, effort);
  std::vector<GoalReading> readings;
  for (const StateGoal& goal : task.goals) {
    GoalReading& reading = readings.emplace_back();
    reading.value = value_of(goal.number, motion);
    if (reading.value && has_angle_of_nothing(goal.number.expression, motion)) reading.value.reset();
    if (!reading.value) continue;
    const double value = *reading.value;
    const bool is_less = goal.least && !(value >= *goal.least), is_more = goal.most && !(value <= *goal.most);
    reading.is_reached = !is_less && !is_more;
    const double end = is_less ? *goal.least : is_more ? *goal.most : value;
    reading.off = value - goal.is.value_or(end);
  }
  return readings;
}

bool are_reached(const std::vector<GoalReading>& goals) {
  return std::all_of(goals.begin(), goals.end(), [](const GoalReading& goal) { return goal.is_reached; });
}

std::string value_text(const StateGoal& goal, const GoalReading& reading, double number) {
  return with_unit(number_with_digits(number, tolerance_of(goal), reading), goal.number.written.unit);
}

std::string words_of(const StateGoal& goal, const GoalReading& reading) {
  if (!reading.value) return "not defined on this motion";
  std::string is = value_text(goal, reading, *reading.value);
  if (reading.is_reached) return is;
  return is + ", " + value_text(goal, reading, std::abs(reading.off)) +
         (reading.off < 0 ? " too small" : " too large");
}

std::string why_not_allowed(const StateTask& task, const SteeredState& state) {
  const SteeredParts changed = state.parts();
  for (std::size_t i = 0; i < kSteered.size(); ++i) {
    const auto part = static_cast<Steered>(i);
    if (changed.contains(part) && !task.change.contains(part))
      return fmt::format("this question keeps {} as {} in the lesson: it asks to change {}",
                         facts_of(part).words.in(Language::en),
                         part == Steered::moments ? "they are" : "it is", words_of(task.change));
  }
  if (state.torque && constant_torque(task.scene->torque).index() != state.torque->index())
    return std::holds_alternative<BodyTorque>(*state.torque)
               ? "the torque of this scene is constant in space: write \"space:x,y,z\""
               : "the torque of this scene is constant in the body: write \"body:x,y,z\"";
  return "";
}

namespace {

/// Products of a few such numbers are still finite.
bool is_too_large(const SteeredState& state) {
  constexpr double kMost = 1e50;
  const auto exceeds = [](const std::optional<Vec3>& x) { return x && x->cwiseAbs().maxCoeff() > kMost; };
  return exceeds(state.w0_B) || exceeds(state.moments);
}

}  // namespace

AnswerJudgement judge_state(const StateTask& task, const SteeredState& state, const Effort& effort) {
  if (std::string why = why_not_allowed(task, state); !why.empty()) return unreadable(std::move(why));
  if (is_too_large(state)) return unreadable("a number in this is too large");
  try {
    const SceneModel model =
        make_model(without_picture(steered(*task.scene, state), 0), ModelFor::numbers, effort);
    const double t_s = judged_time_s(task, state.t_s.value_or(still_time_s(*task.scene)));
    // Far away nothing is known of a motion but its energy: a phase that is lost would reach a goal by
    // chance.
    constexpr double kMostLoops = 1000;
    const double reach_s = std::min(model.reach_s, kMostLoops * model.span_s);
    if (!(std::abs(t_s) <= reach_s) || !is_computable(model, t_s))
      return unreadable(
          fmt::format("t = {:.6g} s is too far away: the motion is judged up to {:.6g} s", t_s, reach_s));
    const std::vector<GoalReading> readings = read_goals(task, model, t_s, effort);
    AnswerJudgement judgement;
    judgement.mark = are_reached(readings) ? AnswerJudgement::Mark::right : AnswerJudgement::Mark::wrong;
    if (judgement.mark == AnswerJudgement::Mark::wrong) judgement.tag = "goal";
    for (std::size_t i = 0; i < readings.size(); ++i)
      if (!readings[i].is_reached)
        judgement.reason += (judgement.reason.empty() ? "" : "; ") + task.goals[i].words() + " is " +
                            words_of(task.goals[i], readings[i]);
    return judgement;
  } catch (const std::domain_error& error) {
    return unreadable(error.what());
  }
}

AnswerJudgement judge_state(const StateTask& task, std::string_view text, const Effort& effort) {
  const auto state = parse_state(text);
  if (state) return judge_state(task, *state, effort);
  const UnreadableState& fault = state.error();
  return unreadable(fault.message, fault.hint, fault.column);
}

}  // namespace polhode
