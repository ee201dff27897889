// SPDX-License-Identifier: MIT
// The motion of a rigid body by the method of one's choice: which methods serve a problem, and the motion
// each makes. The only place where a method's name meets its code; source and formulas stand in the header of
// each method, what it is called and keeps in method_facts.h.
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

/// exact without torque, else dormand_prince_8.
Method default_method(const Problem& problem);

struct MethodChoice {
  Method method = Method::exact;
  std::optional<double> step_s = {};  ///< of fixed-step methods: required, finite, > 0
  std::optional<double> tolerance =
      {};  ///< of adaptive methods, 0 < tolerance < 1; absent: kDefaultTolerance
  std::optional<std::int64_t> max_steps = {};  ///< of adaptive methods; absent: as many as they make at most
};

/// @throws std::domain_error with the reason: state or torque not finite, why_not (naming the methods that
/// can serve), step missing, step or tolerance out of range, or given to a method that has none. What an
/// integrator costs is told to `effort`; a closed form tells nothing.
std::unique_ptr<const Motion> make_motion(const Problem& problem, const MethodChoice& choice,
                                          const Effort& effort = {});

/// Why the motion has no state at t_s, where it has none: "its numbers overflow: the step is too long".
/// Speaks of a torque only where there is one.
std::string why_no_state(const Motion& motion, const Problem& problem, double t_s);

}  // namespace polhode
