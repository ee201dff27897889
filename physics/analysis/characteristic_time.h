// SPDX-License-Identifier: MIT
// How long a motion takes for what is typical of it.
#pragma once

#include "physics/body/problem.h"

#include <optional>

namespace polhode {

/// Of one turn at the rate |ω|, 2π/|ω|, s; nothing at rest.
std::optional<double> turn_time(const Vec3& w_B);

/// Period of the polhode, s; nothing with torque, in steady rotation and on a separatrix.
std::optional<double> polhode_period(const Problem& problem);

/// The polhode period, or else a turn at the start; nothing at rest.
std::optional<double> characteristic_time(const Problem& problem);

}  // namespace polhode
