// SPDX-License-Identifier: MIT
#include "physics/analysis/characteristic_time.h"

#include "physics/geometry/poinsot.h"

#include <numbers>

namespace polhode {

std::optional<double> turn_time(const Vec3& w_B) {
  const double speed = w_B.stableNorm();
  return speed > 0 ? std::optional(2 * std::numbers::pi / speed) : std::nullopt;
}

std::optional<double> polhode_period(const Problem& problem) {
  return problem.torque.empty() ? polhode_period(problem.I, problem.start.w_B) : std::nullopt;
}

std::optional<double> characteristic_time(const Problem& problem) {
  const std::optional<double> period_s = polhode_period(problem);
  return period_s ? period_s : turn_time(problem.start.w_B);
}

}  // namespace polhode
