// SPDX-License-Identifier: MIT
// How fast a motion changes ω, measured on the motion itself.
#pragma once

#include "physics/motion.h"

namespace polhode {

/// ω̇_B at t, rad/s², for a motion that turns at about `speed` rad/s (0: at rest): the difference quotient of
/// five points, (ω(t−2h) − 8ω(t−h) + 8ω(t+h) − ω(t+2h))/12h with h = 0.002/speed. Its own error is about
/// 1e-12 speed²: h⁴ speed⁵/30 and what rounding leaves, ε speed/h. Nothing of the equations of motion goes
/// in, so that they can be tested with it. NaN within 2h of what the motion reaches.
Vec3 w_rate_B(const Motion& motion, double t_s, double speed);

}  // namespace polhode
