// SPDX-License-Identifier: MIT
#include "physics/analysis/horizon.h"

#include "physics/analysis/conditioning.h"

namespace polhode {

Horizon horizon_of(const Problem& problem) {
  if (!problem.torque.empty()) return {};
  const auto found = conditioning(problem.I, problem.start.w_B);
  if (!found) return {};
  return {found->phase_per_period, found->horizon_periods(1e-3), found->horizon_periods(1e-1)};
}

}  // namespace polhode
