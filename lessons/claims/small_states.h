// SPDX-License-Identifier: MIT
// Possible bodies in states of small whole numbers, the simplest first: where counterexamples are looked for.
// Internal to lessons/.
#pragma once

#include "lessons/claims/proof.h"

namespace polhode {

/// Of at most six digits; "−" is its minus.
std::string number_text(double value);

/// The first state in which the sides are not so related, and the premise, if there is one, holds. In words;
/// what neither depends on under the assumption is left out. `tried`: in how many states both sides are
/// defined.
std::optional<Counterexample> first_small_state(const Equality& sides, const Equality* premise,
                                                Assumption assumption, const Given& given = {},
                                                Relation relation = Relation::equal, int* tried = nullptr);

/// Whether there is a body as is given: not so of I2 = 0, or of I3 = 3*I1 with I2 = I1. Bodies of small
/// moments are tried, and such that are 2^n times as heavy, |n| ≤ 140. Some 5 ms where there is none.
bool is_possible(const Given& given);

}  // namespace polhode
