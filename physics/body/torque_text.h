// SPDX-License-Identifier: MIT
// Torques as people write them: on the command line and in lessons.
#pragma once

#include "base/result.h"
#include "physics/body/torque.h"

#include <string_view>

namespace polhode {

/// One term from its text: `space:x,y,z` | `body:x,y,z` (N m) | `heavy:MGR,ax,ay,az` (N m; an axis of any
/// length) | `damping:C` (N m s) | `sink:C`. The error says what is wrong with the text.
Result<TorqueTerm> parse_torque_term(std::string_view text);

}  // namespace polhode
