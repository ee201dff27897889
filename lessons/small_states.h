// SPDX-License-Identifier: MIT
// Possible bodies in states of small whole numbers, the simplest first: where counterexamples are looked for.
// Internal to lessons/.
#pragma once

#include "lessons/proof.h"

namespace polhode {

/// The first state in which the equality fails, and the premise, if there is one, holds. In words; what
/// neither depends on under the assumption is left out.
std::optional<Counterexample> first_small_state(const Equality& equality, const Equality* premise,
                                                Assumption assumption);

}  // namespace polhode
