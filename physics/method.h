// SPDX-License-Identifier: MIT
// The methods that follow a rigid body in time: what each is called, serves, costs and keeps, and the motion
// it makes. The only place where a method's name meets its code. Sources and formulas stand in the header of
// each method, physics/exact/ and physics/integrators/.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/motion.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

enum class Method {
  exact,  ///< the best closed form there is for the body: uniform, symmetric or asymmetric
  uniform,
  symmetric,
  explicit_euler,
  explicit_midpoint,
  rk4,
  rk4_projected,
  splitting,
  implicit_midpoint,
  implicit_midpoint_exp,
  moser_veselov_2,
  moser_veselov_6,
  moser_veselov_10,
  dormand_prince_5,
  dormand_prince_8,
};

enum class StepControl { none, fixed, adaptive };  ///< none: closed form
enum class ServedTorque { none, of_attitude, any };

struct MethodFacts {
  Method method;
  std::string_view name;  ///< for machines: "rk4"
  std::string_view term;  ///< for readers: "classical Runge-Kutta"
  StepControl control;
  ServedTorque torque;
  int order;               ///< of the error in the step; 0: exact. Under a torque `splitting` and
                           ///< `moser_veselov_*` are of order 2
  std::string_view keeps;  ///< what it keeps of the free body beyond its order, "nothing" if so
};

std::span<const MethodFacts> all_methods();
const MethodFacts& facts_of(Method method);
std::string_view name_of(Method method);
std::optional<Method> method_from(std::string_view name);
const std::vector<std::string>& method_names();

/// Why the method cannot serve this problem, or nothing if it can.
std::optional<std::string> why_not(Method method, const Problem& problem);
/// Names of the methods that can serve it.
std::vector<std::string> serving_methods(const Problem& problem);

/// exact without torque, else dormand_prince_8.
Method default_method(const Problem& problem);

inline constexpr double kDefaultTolerance = 1e-10;

struct MethodChoice {
  Method method = Method::exact;
  /// For methods with a fixed step, which require it: finite, > 0.
  std::optional<double> step_s = {};
  /// For adaptive methods: what one step may add to the error, ω relative and q absolute; 0 < tolerance < 1.
  /// Absent: kDefaultTolerance.
  std::optional<double> tolerance = {};
  /// For adaptive methods: times that take more steps are not computed. Absent: 2·10⁷, some seconds.
  std::optional<std::int64_t> max_steps = {};
};

/// @throws std::domain_error with the reason: state or torque not finite, why_not (naming the methods that
/// can serve), step missing, step or tolerance out of range, or given to a method that has none. `effort` is
/// told what an integrator costs; a closed form costs too little to be told.
std::unique_ptr<const Motion> make_motion(const Problem& problem, const MethodChoice& choice,
                                          const Effort& effort = {});

/// For people: why motion.at(t_s) is NaN, where it is, such as "its numbers overflow: the step is too long".
std::string why_no_state(const Motion& motion, const Problem& problem, double t_s);

}  // namespace polhode
