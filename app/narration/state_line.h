// SPDX-License-Identifier: MIT
// A state that somebody is to bring about, as pages and windows print it.
#pragma once

#include "base/words/phrase.h"
#include "lessons/reader/questions/steered_state.h"

#include <string>

namespace polhode {

/// "\vec\omega = (1.5,\, 0,\, 0.45)\,\mathrm{rad/s}" and the like, of each part that the state has, four
/// digits each: a line with formulas between dollars, parted by semicolons. Empty of nothing.
std::string state_line(const SteeredState& state, Language language);

}  // namespace polhode
