// SPDX-License-Identifier: MIT
// The methods that follow a rigid body in time: what each is called, which torques it serves, its order, and
// what it keeps. method.h makes a motion with one.
#pragma once

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
  lagrange_top,  ///< the heavy symmetric top, closed form
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

/// Of adaptive methods, where none is chosen.
inline constexpr double kDefaultTolerance = 1e-10;

enum class StepControl { none, fixed, adaptive };  ///< none: closed form
enum class ServedTorque { none, of_attitude, any };

struct MethodFacts {
  Method method;
  std::string_view name;  ///< for machines: "rk4"
  std::string_view term;  ///< for readers: "RK4", "Moser–Veselov 6"
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

}  // namespace polhode
