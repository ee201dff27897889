// SPDX-License-Identifier: MIT
#include "physics/body/problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

bool has_unit_axis(const TorqueTerm& term) {
  constexpr double kUnit = 1e-6;
  const auto* top = std::get_if<HeavyTop>(&term);
  return !top || std::abs(top->axis_B.stableNorm() - 1.0) <= kUnit;
}

}  // namespace

Problem checked(const Problem& problem) {
  if (!is_finite(problem.torque)) throw std::domain_error("torque is not finite");
  if (!std::all_of(problem.torque.begin(), problem.torque.end(), has_unit_axis))
    throw std::domain_error("the axis of a heavy top must be a unit vector");
  return {problem.I, checked(problem.start), problem.torque};
}

}  // namespace polhode
