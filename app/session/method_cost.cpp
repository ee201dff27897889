// SPDX-License-Identifier: MIT
#include "app/session/method_cost.h"

#include "base/words/phrase.h"
#include "base/words/window_words.h"
#include "physics/analysis/characteristic_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace polhode {

namespace {

/// An exponent without the zeros that fill it up: "1e-10", "2e-5".
std::string two_digits(double value) {
  std::string text = fmt::format("{:.2g}", value);
  if (const std::size_t zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text;
}

ParetoStep step_of(const WorkPrecisionRow& row) {
  return {{row.method, row.step_s, row.tolerance}, row.error(), row.ns_per_period};
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

std::string named_in(Language language, const MethodChoice& choice) {
  const std::string name(name_of(choice.method));
  const auto digits = [&](double value) { return with_decimals(two_digits(value), language); };
  if (choice.step_s) return words::kMethodOfStep.with(language, {name, digits(*choice.step_s)});
  if (choice.tolerance) return words::kMethodOfTolerance.with(language, {name, digits(*choice.tolerance)});
  return words::kMethodOfClosedForm.with(language, {name});
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

}  // namespace polhode
