// SPDX-License-Identifier: MIT
// Whether all that a lesson claims holds: for `lint`.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/effort.h"

#include <string_view>
#include <vector>

namespace polhode {

/// An error for each line of a claim that is not what its kind says, with its place, a counterexample if
/// there is one of small whole numbers, and the kind it might be. `measured` lines are measured on the scene
/// of their step. Some 10 ms for a lecture, and at most kMaxDiagnostics errors. In the order of their places.
/// Where `effort` throws BudgetSpent the claim is an error, and nothing behind it is checked.
std::vector<Diagnostic> check_claims(const Lesson& lesson, std::string_view file_name,
                                     const Effort& effort = {});

}  // namespace polhode
