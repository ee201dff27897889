// SPDX-License-Identifier: MIT
// Possible bodies in states of small whole numbers, the simplest first: where counterexamples are looked for.
// Internal to lessons/.
#pragma once

#include "lessons/claims/proof/proof.h"

namespace polhode {

/// The first state, in words, in which the premise holds and the sides are not so related: "I = (2, 3, 4)"
/// for I1 = I2. It names only what sides and premise depend on under these laws. States of small whole
/// numbers are tried in order. Some hundred states of random whole numbers follow where there is a premise,
/// or where an inequality is stated or given. `premise`: null if there is none. `tried`: in how many states
/// both sides are defined.
std::optional<Counterexample> first_whole_number_state(const Equality& sides, const Equality* premise,
                                                       LawsAssumed laws, const Given& given = {},
                                                       Relation relation = Relation::equal,
                                                       int* tried = nullptr);

/// The first state in which two sides, expanded in what is small, differ at a power of ε up to the order that
/// is given. In the text a small quantity has an ε, "ω = (ε, 1, 2ε)"; each side is its lowest term, "−0.5ε".
/// `differ_at`: the lowest power of ε at which they differ. Nothing if they differ in no state that is tried.
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
