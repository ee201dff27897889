// SPDX-License-Identifier: MIT
// What a lesson's scene is as a problem of mechanics, in numbers: for `polhode info`.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/analysis/symmetric_top.h"
#include "physics/body/problem.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// At the start of the motion, t = 0. Nothing where a rate is not defined.
struct SceneFacts {
  std::size_t first_step = 1, last_step = 1;  ///< from 1; steps between them show this motion, or no scene
  Body body;                                  ///< moments about the pivot, if it has one
  Problem problem;
  double T = 0, L = 0;               ///< J, kg m²/s
  std::optional<double> period_s{};  ///< of the polhode
  std::optional<FreePrecession> free{};
  /// Of a symmetric top under gravity alone: θ is the angle of its axis, towards the centre of mass, from the
  /// vertical.
  std::optional<double> theta_rad{};
  std::optional<SteadyPrecession> steady{};
  std::optional<Nutation> nutation{};
};

/// The motions of a stage in their order; steps that follow each other with the same one are one.
std::vector<SceneFacts> facts_of(const Stage& stage);

}  // namespace polhode
