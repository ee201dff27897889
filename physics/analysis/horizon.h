// SPDX-License-Identifier: MIT
// How far ahead a motion can be told.
#pragma once

#include "physics/body/problem.h"

#include <optional>

namespace polhode {

/// Nothing where there is no period: at rest, on a separatrix, under a torque. In steady rotation a turn
/// takes its place (physics/analysis/conditioning.h).
struct Horizon {
  std::optional<double> condition;  ///< phase, rad, moved in a period by a relative change 1 of the inputs
  std::optional<double>
      periods_1e_3;  ///< after which rounding of the inputs alone moves the phase by 1e-3 rad
  std::optional<double> periods_1e_1;  ///< ... by 0.1 rad
};
Horizon horizon_of(const Problem& problem);

}  // namespace polhode
