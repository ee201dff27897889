// SPDX-License-Identifier: MIT
// The methods side by side on one problem: how wrong each is at one time, what it has kept, and what it
// costs.
#pragma once

#include "physics/analysis/motion_errors.h"
#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/method_facts.h"
#include "physics/motion.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace polhode {

struct MethodRow {
  Method method = Method::exact;
  StateError error;      ///< at t; NaN of the reference itself, and where the method went beyond double
  InvariantDrift drift;  ///< at t, from the start
  /// Of the equations of motion, for a second of the motion; of a closed form those of the formula for one
  /// time. A count and no time: pictures repeat.
  double evaluations_per_s = 0;
};

struct MethodTable {
  double t_s = 0;
  double step_s = 0;            ///< of the methods of fixed step
  std::vector<MethodRow> rows;  ///< the reference first, then in the order of `Method`
};

/// Steps that each method of a scene's table takes at most: about 0.2 s in all.
inline constexpr double kMostTableSteps = 1e5;

/// A still whose motion takes more steps than this is refused: they last about a second.
inline constexpr std::int64_t kMostStillSteps = 2'000'000;

/// Steps that a plot of orders shows, each half of the one before.
inline constexpr int kOrderSteps = 7;

/// As exact as a still can have it: the closed form; without one Dormand-Prince 8 at a tolerance near
/// rounding, 1e-13, where that of a measurement (kReferenceTolerance) may take longer.
/// @throws std::domain_error as make_motion does.
std::unique_ptr<const Motion> reference_motion(const Problem& problem, const Effort& effort = {});

/// Every method of fixed step that serves the problem, and Dormand-Prince 8 with its usual tolerance, against
/// the reference motion.
/// @param chosen of these alone, with the reference; empty: all
/// @throws std::domain_error as make_motion does.
MethodTable method_table(const Problem& problem, double step_s, double t_s, const Effort& effort = {},
                         const std::vector<Method>& chosen = {});

}  // namespace polhode
