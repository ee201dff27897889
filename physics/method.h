// SPDX-License-Identifier: MIT
// The motion of a rigid body by the method of one's choice: which methods serve a problem, and the motion
// each makes. The only place where a method's name meets its code. What methods are called and keep stands in
// method_facts.h, sources and formulas in the header of each method, physics/exact/ and physics/integrators/.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/method_facts.h"
#include "physics/motion.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// Why the method cannot serve this problem, or nothing if it can.
std::optional<std::string> why_not(Method method, const Problem& problem);
/// Names of the methods that can serve it.
std::vector<std::string> serving_methods(const Problem& problem);

/// The closed form that a motion is held against: exact without torque, lagrange_top for a symmetric top
/// under its weight alone; nothing under another torque.
std::optional<Method> closed_form(const Problem& problem);
/// The closed form where there is one, else dormand_prince_8.
Method default_method(const Problem& problem);

struct MethodChoice {
  Method method = Method::exact;
  /// For methods with a fixed step, which require it: finite, > 0.
  std::optional<double> step_s = {};
  /// For adaptive methods: what one step may add to the error, ω relative and q absolute; 0 < tolerance < 1.
  /// Absent: kDefaultTolerance.
  std::optional<double> tolerance = {};
  /// For adaptive methods: times that take more steps are not computed; ≥ 1. Absent: 2·10⁷, some seconds.
  std::optional<std::int64_t> max_steps = {};
};

/// @throws std::domain_error with the reason: state or torque that checked(Problem) refuses, why_not (naming
/// the methods that can serve), step missing, step, tolerance or max_steps out of range, step or tolerance
/// given to a method that has none. `effort` is told what an integrator costs; a closed form costs too little
/// to be told.
std::unique_ptr<const Motion> make_motion(const Problem& problem, const MethodChoice& choice,
                                          const Effort& effort = {});

/// For people: why motion.at(t_s) is NaN, where it is, such as "its numbers overflow: the step is too long".
std::string why_no_state(const Motion& motion, const Problem& problem, double t_s);

}  // namespace polhode
