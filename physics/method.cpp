// SPDX-License-Identifier: MIT
#include "physics/method.h"

#include "physics/exact/asymmetric_motion.h"
#include "physics/exact/lagrange_top.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/exact/uniform_motion.h"
#include "physics/integrators/dormand_prince.h"
#include "physics/integrators/explicit_runge_kutta.h"
#include "physics/integrators/implicit_midpoint.h"
#include "physics/integrators/lie_poisson_splitting.h"
#include "physics/integrators/moser_veselov.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

using enum StepControl;
using M = Method;
using Torques = ServedTorque;

bool depends_on_attitude_alone(const Torque& torque) {
  return std::all_of(torque.begin(), torque.end(), [](const TorqueTerm& term) {
    return !std::holds_alternative<LinearDamping>(term) && !std::holds_alternative<EnergySink>(term);
  });
}

std::unique_ptr<const Motion> exact_motion(const Problem& p) {
  if (is_steady(p.I, p.start.w_B)) return std::make_unique<UniformMotion>(p.I, p.start);
  if (symmetry_axis(p.I)) return std::make_unique<SymmetricMotion>(p.I, p.start);
  return std::make_unique<AsymmetricMotion>(p.I, p.start);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void check_settings(const MethodFacts& facts, const MethodChoice& choice) {
  const std::string name(facts.name);
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  if (facts.control == fixed && !choice.step_s) throw std::domain_error("\"" + name + "\" needs a step");
  if (facts.control != fixed && choice.step_s) throw std::domain_error("\"" + name + "\" takes no step");
  if (facts.control != adaptive && choice.tolerance)
    throw std::domain_error("\"" + name + "\" takes no tolerance");
  if (choice.step_s && !positive(*choice.step_s)) throw std::domain_error("the step must be finite and > 0");
  if (choice.tolerance && !positive(*choice.tolerance))
    throw std::domain_error("the tolerance must be finite and > 0");
  if (choice.max_steps && *choice.max_steps < 1) throw std::domain_error("at least one step must be allowed");
}

}  // namespace

std::optional<std::string> why_not(Method method, const Problem& problem) {
  const MethodFacts& facts = facts_of(method);
  if (facts.torque == Torques::none && !problem.torque.empty()) return "it is for torque-free motion";
  if (facts.torque == Torques::of_attitude && !depends_on_attitude_alone(problem.torque))
    return "it serves torque that depends on attitude alone";
  if (method == M::uniform && !is_steady(problem.I, problem.start.w_B)) return "the rotation is not steady";
  if (method == M::symmetric && !symmetry_axis(problem.I)) return "no two moments are equal";
  if (method == M::lagrange_top && problem.torque.empty()) return "no weight acts";
  if (method == M::lagrange_top) return why_no_top(problem.I, problem.torque);
  return std::nullopt;
}

std::vector<std::string> serving_methods(const Problem& problem) {
  std::vector<std::string> names;
  for (const MethodFacts& facts : all_methods())
    if (!why_not(facts.method, problem)) names.emplace_back(facts.name);
  return names;
}

std::optional<Method> closed_form(const Problem& problem) {
  if (problem.torque.empty()) return M::exact;
  if (!why_not(M::lagrange_top, problem)) return M::lagrange_top;
  return std::nullopt;
}

Method default_method(const Problem& problem) { return closed_form(problem).value_or(M::dormand_prince_8); }

std::unique_ptr<const Motion> make_motion(const Problem& unchecked, const MethodChoice& choice,
                                          const Effort& effort) {
  const MethodFacts& facts = facts_of(choice.method);
  const Problem problem = checked(unchecked);
  if (const auto reason = why_not(choice.method, problem))
    throw std::domain_error("\"" + std::string(facts.name) + "\" cannot serve this: " + *reason +
                            "; what can: " + joined(serving_methods(problem)));
  check_settings(facts, choice);
  const std::int64_t max_steps = choice.max_steps.value_or(DormandPrinceMotion::kMaxSteps);

  switch (choice.method) {
    case M::exact:
      return exact_motion(problem);
    case M::uniform:
      return std::make_unique<UniformMotion>(problem.I, problem.start);
    case M::symmetric:
      return std::make_unique<SymmetricMotion>(problem.I, problem.start);
    case M::lagrange_top:
      return std::make_unique<LagrangeTopMotion>(problem);
    case M::explicit_euler:
      return explicit_euler_motion(problem, *choice.step_s, effort);
    case M::explicit_midpoint:
      return explicit_midpoint_motion(problem, *choice.step_s, effort);
    case M::rk4:
      return rk4_motion(problem, *choice.step_s, effort);
    case M::rk4_projected:
      return rk4_projected_motion(problem, *choice.step_s, effort);
    case M::splitting:
      return splitting_motion(problem, *choice.step_s, effort);
    case M::implicit_midpoint:
      return implicit_midpoint_motion(problem, *choice.step_s, effort);
    case M::implicit_midpoint_exp:
      return implicit_midpoint_exp_motion(problem, *choice.step_s, effort);
    case M::moser_veselov_2:
      return moser_veselov_motion(2, problem, *choice.step_s, effort);
    case M::moser_veselov_6:
      return moser_veselov_motion(6, problem, *choice.step_s, effort);
    case M::moser_veselov_10:
      return moser_veselov_motion(10, problem, *choice.step_s, effort);
    case M::dormand_prince_5:
      return std::make_unique<DormandPrinceMotion>(DormandPrincePair::five_four, problem,
                                                   choice.tolerance.value_or(kDefaultTolerance), max_steps,
                                                   effort);
    case M::dormand_prince_8:
      return std::make_unique<DormandPrinceMotion>(DormandPrincePair::eight_five_three, problem,
                                                   choice.tolerance.value_or(kDefaultTolerance), max_steps,
                                                   effort);
  }
  throw std::logic_error("a method without a motion");
}

std::string why_no_state(const Motion& motion, const Problem& problem, double t_s) {
  if (motion.is_too_far(t_s)) return "it takes more steps than are made: choose a shorter time";
  const auto method = method_from(motion.method());
  const bool is_free = problem.torque.empty();
  switch (method ? facts_of(*method).control : none) {
    case adaptive:
      return std::string("no step is short enough: the ") + (is_free ? "angular velocity" : "torque") +
             " is too large";
    case fixed:
      return std::string("its numbers overflow: ") +
             (is_free ? "the step is too long" : "the torque is too large, or the step too long");
    case none:
      break;
  }
  return "its numbers overflow: the angular velocity or the time is too large";
}

}  // namespace polhode
