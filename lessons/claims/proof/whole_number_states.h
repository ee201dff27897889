// SPDX-License-Identifier: MIT
// Possible bodies in states of small whole numbers, the simplest first: where counterexamples are looked for.
// Internal to lessons/.
#pragma once

#include "lessons/claims/proof/proof.h"

namespace polhode {

/// The first state in which the sides are not so related, and the premise, if there is one, holds; with a
/// premise, or where an order is stated or given, also among some hundred states of random small numbers. In
/// words; what neither depends on under these laws is left out. `tried`: in how many states both sides
/// are defined.
std::optional<Counterexample> first_whole_number_state(const Equality& sides, const Equality* premise,
                                                       LawsAssumed laws, const Given& given = {},
                                                       Relation relation = Relation::equal,
                                                       int* tried = nullptr);

/// The first state in which two sides, expanded in what is small, differ through the order that is given;
/// what is small has an ε, "ω = (ε, 1, 2ε)", and of the sides there is what comes first, "−0.5ε".
/// `differ_at`: the power of ε at which they do. Nothing if none of those tried is one.
std::optional<Counterexample> first_state_in_series(const Equality& sides, LawsAssumed laws,
                                                    const Given& given, int& differ_at);

/// Whether some body and state that are tried are as is given, and each inequality holds strictly: so there
/// is room in every direction. Moments from a ratio of 1e-4 to 1e4 are tried, and w, N, h, k and constants of
/// either sign. At most some 20 ms.
bool bounds_are_possible(const Given& given);

/// Whether there is a body as is given: not so of I2 = 0, or of I3 = 3*I1 with I2 = I1. Bodies of small
/// moments are tried, and such that are 2^n times as heavy, |n| ≤ 140. Some 5 ms where there is none. Of
/// inequalities nothing is said.
bool is_possible(const Given& given);

}  // namespace polhode
