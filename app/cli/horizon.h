// SPDX-License-Identifier: MIT
// How far ahead a motion can be told: what `trace` and `info` say of it.
#pragma once

#include "physics/body/problem.h"

#include <optional>
#include <string>

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

/// One sentence, without a full stop; empty where there is no horizon.
std::string sentence(const Horizon& horizon);

/// `"condition":c,"horizon_periods":{"1e-3":n,"1e-1":n}`: members of a JSON object.
std::string json_members(const Horizon& horizon);

}  // namespace polhode
