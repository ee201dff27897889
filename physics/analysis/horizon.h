// SPDX-License-Identifier: MIT
// How far ahead a motion can be predicted, in one look: the numbers of conditioning.h for a Problem.
#pragma once

#include "physics/body/problem.h"

#include <optional>

namespace polhode {

/// Each is empty where there is no period: at rest, on a separatrix, under a torque. In steady rotation a
/// turn takes the place of the period.
struct Horizon {
  /// Conditioning::phase_per_period, rad.
  std::optional<double> condition;
  /// Periods after which rounding of the inputs alone may move the phase by 1e-3 rad, and by 0.1 rad.
  std::optional<double> periods_1e_3, periods_1e_1;
};
Horizon horizon_of(const Problem& problem);

}  // namespace polhode
