// SPDX-License-Identifier: MIT
// Many times of one motion, on several cores.
#pragma once

#include "physics/motion.h"

namespace polhode {

/// states[i] = motion.at(t_s[i]), to the bit and whatever `threads` ≥ 1 is; spans of equal length. Each
/// thread takes one piece of the times; a further thread pays from about 10⁴ times of a closed form each.
/// What an Effort (effort.h) throws on any of them comes out of the call, and `states` is then not to be
/// used.
void states_at(const Motion& motion, std::span<const double> t_s, std::span<RigidBodyState> states,
               unsigned threads);

}  // namespace polhode
