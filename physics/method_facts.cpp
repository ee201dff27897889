// SPDX-License-Identifier: MIT
#include "physics/method_facts.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

using enum StepControl;
using M = Method;
using Torques = ServedTorque;

// In the order of the enumerators.
constexpr std::array kFacts = {
    MethodFacts{M::exact, "exact", "closed form", none, Torques::none, 0, "T, L in space, |q|"},
    MethodFacts{M::uniform, "uniform", "steady rotation", none, Torques::none, 0, "T, L in space, |q|"},
    MethodFacts{M::symmetric, "symmetric", "symmetric top", none, Torques::none, 0, "T, L in space, |q|"},
    MethodFacts{M::lagrange_top, "lagrange-top", "heavy symmetric top", none, Torques::of_attitude, 0,
                "under weight: T + V, L_z, L_3, |q|"},
    MethodFacts{M::explicit_euler, "explicit-euler", "explicit Euler", fixed, Torques::any, 1, "nothing"},
    MethodFacts{M::explicit_midpoint, "explicit-midpoint", "explicit midpoint", fixed, Torques::any, 2,
                "nothing"},
    MethodFacts{M::rk4, "rk4", "RK4", fixed, Torques::any, 4, "nothing"},
    MethodFacts{M::rk4_projected, "rk4-projected", "RK4 with projection", fixed, Torques::none, 4,
                "T, |L|, |q|"},
    MethodFacts{M::splitting, "splitting", "splitting", fixed, Torques::of_attitude, 2,
                "L in space, |q|; reversible"},
    MethodFacts{M::implicit_midpoint, "implicit-midpoint", "implicit midpoint", fixed, Torques::none, 2,
                "T, L in space, |q|; reversible"},
    MethodFacts{M::implicit_midpoint_exp, "implicit-midpoint-exp", "implicit midpoint with exp", fixed,
                Torques::none, 2, "T, |L|, |q|; reversible"},
    MethodFacts{M::moser_veselov_2, "moser-veselov-2", "Moser–Veselov 2", fixed, Torques::of_attitude, 2,
                "T, L in space, |q|; reversible"},
    MethodFacts{M::moser_veselov_6, "moser-veselov-6", "Moser–Veselov 6", fixed, Torques::of_attitude, 6,
                "T, L in space, |q|; reversible"},
    MethodFacts{M::moser_veselov_10, "moser-veselov-10", "Moser–Veselov 10", fixed, Torques::of_attitude, 10,
                "T, L in space, |q|; reversible"},
    MethodFacts{M::dormand_prince_5, "dormand-prince-5", "Dormand–Prince 5(4)", adaptive, Torques::any, 5,
                "nothing"},
    MethodFacts{M::dormand_prince_8, "dormand-prince-8", "Dormand–Prince 8(5,3)", adaptive, Torques::any, 8,
                "nothing"},
};

}  // namespace

std::span<const MethodFacts> all_methods() { return kFacts; }

const MethodFacts& facts_of(Method method) { return kFacts[static_cast<std::size_t>(method)]; }

std::string_view name_of(Method method) { return facts_of(method).name; }

std::optional<Method> method_from(std::string_view name) {
  const auto found = std::find_if(kFacts.begin(), kFacts.end(),
                                  [name](const MethodFacts& facts) { return facts.name == name; });
  return found == kFacts.end() ? std::nullopt : std::optional(found->method);
}

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> result;
    for (const MethodFacts& facts : kFacts) result.emplace_back(facts.name);
    return result;
  }();
  return kNames;
}

}  // namespace polhode
