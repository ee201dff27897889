// SPDX-License-Identifier: MIT
#include "app/cli/trace/trace_motion.h"

#include "app/cli/exit_codes.h"
#include "app/cli/numbers.h"
#include "base/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polhode {

namespace {

std::optional<double> positive(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const double value = finite_number(option, text);
  if (!(value > 0)) throw usage(fmt::format("{}: {} is not > 0", option, text));
  return value;
}

void check_control(const MethodFacts& facts, const TypedMethod& typed) {
  const std::string motion = typed.method.empty() ? fmt::format("this motion is followed by {}", facts.name)
                                                  : fmt::format("{} has none", facts.name);
  if (facts.control == StepControl::fixed && typed.step.empty())
    throw usage(fmt::format("--method {} needs --step, in seconds", facts.name));
  if (facts.control != StepControl::fixed && !typed.step.empty())
    throw usage(fmt::format("--step is for methods with a fixed step; {}", motion));
  if (facts.control != StepControl::adaptive && !typed.tolerance.empty())
    throw usage(fmt::format("--tolerance is for adaptive methods; {}", motion));
}

}  // namespace

Method serving_method(const Problem& problem, const std::string& name) {
  const std::optional<Method> method = method_from(name);
  if (!method)
    throw usage(fmt::format("--method: unknown \"{}\"{} (there are {})", name,
                            did_you_mean(name, method_names()), fmt::join(method_names(), ", ")));
  if (const auto reason = why_not(*method, problem))
    throw usage(fmt::format("--method {} cannot serve this {}: {}; what can: {}", name,
                            problem.torque.empty() ? "body and state" : "torque", *reason,
                            fmt::join(serving_methods(problem), ", ")));
  return *method;
}

MethodChoice method_choice(const Problem& problem, const TypedMethod& typed) {
  const std::optional<double> tolerance = positive("--tolerance", typed.tolerance);
  if (tolerance && *tolerance >= 1) throw usage(fmt::format("--tolerance: {} is not < 1", typed.tolerance));
  const Method method =
      typed.method.empty() ? default_method(problem) : serving_method(problem, typed.method);
  check_control(facts_of(method), typed);
  return {method, positive("--step", typed.step), tolerance};
}

TracedMotion traced_motion(const Problem& problem, const TypedMethod& typed) {
  const MethodChoice choice = method_choice(problem, typed);
  const MethodFacts& facts = facts_of(choice.method);
  const bool all_said = !typed.method.empty() && choice.tolerance;
  std::string note;
  if (facts.control == StepControl::adaptive && !all_said)
    note = fmt::format("method {}, tolerance {:g}", facts.name, choice.tolerance.value_or(kDefaultTolerance));
  return {make_motion(problem, choice), std::move(note)};
}

TracedMotion traced_motion(const Problem& problem, const TypedMethod& typed, const MotionSpec& spec) {
  if (!typed.method.empty() || !typed.step.empty() || !typed.tolerance.empty())
    return traced_motion(problem, typed);
  const Method method = spec.method.value_or(default_method(problem));
  return {make_motion(problem, {method, spec.step_s, spec.tolerance}), {}};
}

}  // namespace polhode
