// SPDX-License-Identifier: MIT
// The time in which a motion does what is typical of it: by which to choose steps, spans and frames.
#pragma once

#include "physics/body/problem.h"

#include <optional>

namespace polhode {

/// Time of one turn at the rate |ω|, 2π/|ω|, s; nothing at rest.
std::optional<double> turn_time(const Vec3& w_B);

/// Period of the polhode (poinsot.h), s; nothing under a torque, in steady rotation and on a separatrix.
std::optional<double> polhode_period(const Problem& problem);

/// The period of the polhode where there is one, otherwise the time of a turn at the start; nothing at rest.
std::optional<double> characteristic_time(const Problem& problem);

}  // namespace polhode
