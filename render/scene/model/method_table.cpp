// SPDX-License-Identifier: MIT
#include "render/scene/model/method_table.h"

#include "physics/method.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MethodRow row_of(const Motion& motion, Method method, const Problem& problem, double t_s) {
  const RigidBodyState state = motion.at(t_s);
  const double evaluations = static_cast<double>(motion.evaluations_to(t_s));
  const bool per_time = facts_of(method).control == StepControl::none;
  return {method,
          {kNaN, kNaN},
          drift_along(problem, {&state, 1}),
          per_time || t_s == 0.0 ? evaluations : evaluations / std::abs(t_s)};
}

bool stands_in_table(const MethodFacts& facts, const Problem& problem) {
  return (facts.control == StepControl::fixed || facts.method == Method::dormand_prince_8) &&
         !why_not(facts.method, problem);
}

}  // namespace

std::unique_ptr<const Motion> reference_motion(const Problem& problem, const Effort& effort) {
  constexpr double kTolerance = 1e-13;
  const Method method = default_method(problem);
  const bool adaptive = facts_of(method).control == StepControl::adaptive;
  return make_motion(problem,
                     {.method = method,
                      .tolerance = adaptive ? std::optional(kTolerance) : std::nullopt,
                      .max_steps = kMostStillSteps},
                     effort);
}

MethodTable method_table(const Problem& problem, double step_s, double t_s, const Effort& effort,
                         const std::vector<Method>& chosen) {
  const auto reference = reference_motion(problem, effort);
  const RigidBodyState end = reference->at(t_s);
  MethodTable table{t_s, step_s, {}};
  if (const auto exact = closed_form(problem)) table.rows.push_back(row_of(*reference, *exact, problem, t_s));
  for (const MethodFacts& facts : all_methods()) {
    const bool is_chosen =
        chosen.empty() || std::find(chosen.begin(), chosen.end(), facts.method) != chosen.end();
    if (!is_chosen || !stands_in_table(facts, problem)) continue;
    const bool steps = facts.control == StepControl::fixed;
    const auto motion = make_motion(
        problem, {facts.method, steps ? std::optional(step_s) : std::nullopt, {}, kMostStillSteps}, effort);
    MethodRow row = row_of(*motion, facts.method, problem, t_s);
    row.error = error_of(motion->at(t_s), end);
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace polhode
