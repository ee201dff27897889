// SPDX-License-Identifier: MIT
// What a motion is known by: its energy, its momentum, and the period and rates that textbooks give of it.
#pragma once

#include "physics/analysis/symmetric_top.h"
#include "physics/body/problem.h"

#include <optional>

namespace polhode {

/// At the start of the motion, t = 0. Nothing where a rate is not defined.
struct MotionFacts {
  double T = 0, L = 0;                   ///< J, kg m²/s
  std::optional<double> period_s{};      ///< of the polhode
  std::optional<FreePrecession> free{};  ///< without torque
  /// Of a symmetric top under gravity alone: θ is the angle of its axis, towards the centre of mass, from the
  /// vertical.
  std::optional<double> theta_rad{};
  std::optional<SteadyPrecession> steady{};
  std::optional<Nutation> nutation{};
};
MotionFacts motion_facts(const Problem& problem);

}  // namespace polhode
