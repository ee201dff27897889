// SPDX-License-Identifier: MIT
#include "app/session/method_cost.h"

#include "app/session/lesson_session.h"
#include "base/stopwatch.h"
#include "physics/analysis/characteristic_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace polhode {

namespace {

MethodChoice choice_of(const SceneModel& model, const Problem& problem) {
  const MotionSpec& spec = model.scene.motion;
  return {spec.method.value_or(default_method(problem)), spec.step_s, spec.tolerance};
}

/// Evenly spread, t_s the last. Adaptive methods take steps again to each of them: they get fewer.
std::vector<RigidBodyState> states_until(const Motion& motion, Method method, double t_s) {
  const int count = facts_of(method).control == StepControl::adaptive ? 16 : 64;
  std::vector<double> times_s;
  for (int i = 1; i <= count; ++i) times_s.push_back(t_s * i / count);
  std::vector<RigidBodyState> states(times_s.size());
  motion.at(times_s, states);
  return states;
}

/// CPU time of a call that goes one frame further, ns: over as many frames as the clock needs.
template <class F>
double mean_ns(F&& next_frame) {
  constexpr double kLongEnough_s = 20e-6;
  constexpr int kMostFrames = 64;
  const double start_s = cpu_time_s();
  double spent_s = 0;
  int frames = 0;
  for (; frames < kMostFrames && spent_s < kLongEnough_s; spent_s = cpu_time_s() - start_s)
    for (const int until = 2 * frames + 1; frames < until; ++frames) next_frame();
  return 1e9 * spent_s / frames;
}

/// From `now` on, frame by frame, by a motion that starts there: what the present one knows of the way ahead
/// does not make it look cheap.
double ns_per_frame(const SceneModel& model, const Problem& problem, const MethodChoice& choice,
                    const RigidBodyState& now) {
  constexpr int kTimings = 3;
  if (!is_finite(now)) return std::numeric_limits<double>::quiet_NaN();
  const double frame_s = model.rate * kFrameSeconds;
  volatile double sink = 0;  // keeps the calls from being optimised away
  std::vector<double> times_ns;
  for (int i = 0; i < kTimings; ++i) {
    const auto ahead = make_motion({problem.I, now, problem.torque}, choice);
    double t_s = 0;
    times_ns.push_back(mean_ns([&] {
      t_s += frame_s;
      sink = sink + (model.needs.attitude ? ahead->at(t_s).w_B.x() : ahead->w_B_at(t_s).x());
    }));
  }
  return median(times_ns);
}

/// An exponent without the zeros that fill it up: "1e-10", "2e-5".
std::string two_digits(double value) {
  std::string text = fmt::format("{:.2g}", value);
  if (const std::size_t zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text;
}

std::string name_of_step(const MethodChoice& choice) {
  const std::string name(name_of(choice.method));
  if (choice.step_s) return fmt::format("{}, step {} s", name, two_digits(*choice.step_s));
  if (choice.tolerance) return fmt::format("{}, tolerance {}", name, two_digits(*choice.tolerance));
  return fmt::format("{}, closed form", name);
}

ParetoStep step_of(const WorkPrecisionRow& row) {
  const MethodChoice choice{row.method, row.step_s, row.tolerance};
  return {choice, row.error(), row.ns_per_period, name_of_step(choice)};
}

/// Those that go step by step and, where there is one, the closed form.
std::vector<Method> methods_for(const Problem& problem) {
  std::vector<Method> methods;
  for (const MethodFacts& facts : all_methods())
    if ((goes_step_by_step(facts.method) || facts.method == closed_form(problem)) &&
        !why_not(facts.method, problem))
      methods.push_back(facts.method);
  return methods;
}

struct Stopped {};

std::vector<ParetoStep> measured_front(const Problem& problem, double cpu_seconds,
                                       const std::atomic<bool>& stopped) {
  WorkPrecisionPlan plan;
  plan.period_s = characteristic_time(problem).value_or(0);
  plan.periods = 10;
  plan.methods = methods_for(problem);
  plan.cpu_seconds = cpu_seconds;
  if (!(plan.period_s > 0)) return {};
  try {
    const auto measured = measure_work_precision(problem, plan, [&](std::size_t) {
      if (stopped) throw Stopped{};
    });
    return measured ? pareto_steps(measured->rows) : std::vector<ParetoStep>();  // nothing to measure against
  } catch (const Stopped&) {
    return {};
  }
}

}  // namespace

AccuracyMeter::AccuracyMeter(const SceneModel& model)
    : problem_(problem_of(model.scene)), choice_(choice_of(model, problem_)) {
  const auto exact = closed_form(problem_);
  if (exact && goes_step_by_step(choice_.method)) exact_ = make_motion(problem_, {*exact});
}

AccuracyMeter::~AccuracyMeter() = default;

AccuracyReading AccuracyMeter::at(const SceneModel& model, double t_s) const {
  const auto states = states_until(*model.motion, choice_.method, t_s);
  const RigidBodyState& now = states.back();
  AccuracyReading reading;
  if (exact_) reading.error = error_of(now, exact_->at(t_s));
  reading.drift = drift_along(problem_, states);
  reading.ns_per_frame = ns_per_frame(model, problem_, choice_, now);
  return reading;
}

std::vector<ParetoStep> pareto_steps(const std::vector<WorkPrecisionRow>& rows) {
  const std::vector<bool> front = front_step_by_step(rows);
  std::vector<ParetoStep> steps, exact;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (front[i]) steps.push_back(step_of(rows[i]));
    if (!goes_step_by_step(rows[i].method) && rows[i].error() < kNoAnswer) exact.push_back(step_of(rows[i]));
  }
  std::stable_sort(steps.begin(), steps.end(), [](const ParetoStep& a, const ParetoStep& b) {
    return a.ns_per_period < b.ns_per_period;
  });
  steps.insert(steps.end(), exact.begin(), exact.end());
  return steps;
}

FrontMeasurement::FrontMeasurement(const Problem& problem, double cpu_seconds)
    : future_(std::async(std::launch::async, [this, problem, cpu_seconds] {
        return measured_front(problem, cpu_seconds, stopped_);
      })) {}

FrontMeasurement::~FrontMeasurement() {
  stopped_ = true;
  if (future_.valid()) future_.wait();
}

bool FrontMeasurement::is_ready() const {
  return !future_.valid() || future_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

const std::vector<ParetoStep>& FrontMeasurement::steps() {
  if (future_.valid() && is_ready()) steps_ = future_.get();
  return steps_;
}

RequirementWords requirement_words(const SceneModel& model) {
  RequirementWords words;
  for (const RequirementFacts& facts : requirement_facts())
    (model.needs.*facts.part ? words.computed : words.left_out).emplace_back(facts.words);
  return words;
}

}  // namespace polhode
