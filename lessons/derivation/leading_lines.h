// SPDX-License-Identifier: MIT
// Which lines of a derivation lead to its goal.
#pragma once

#include "lessons/derivation/derivation.h"

#include <vector>

namespace polhode {

/// Of lines that hold, the last of them the goal: whether each leads to it. The last does, and so does a line
/// of the lesson's solution, and one that has a term, but for numbers and moments as factors and divisors, in
/// common with a later line that does. What stands beside the way, "omega x N = omega x dL/dt", is true and
/// no step of it. Whether a line is needed nobody can tell: all of them hold by themselves.
std::vector<bool> lines_that_lead(const Derivation& derivation, const std::vector<DerivedLine>& lines);

}  // namespace polhode
