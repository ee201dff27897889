// SPDX-License-Identifier: MIT
// Whether all that a lesson claims holds.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/effort.h"

#include <optional>
#include <string_view>
#include <vector>

namespace polhode {

/// Proves every claim, once for all who speak of it: each line gets its judgement. Some 10 ms for a lecture.
/// @returns the place of the first claim that is not proved because `effort` threw BudgetSpent
std::optional<SourcePlace> prove_claims(Lesson& lesson, const Effort& effort = {});

/// Of a lesson that is proved: an error for each line of a claim that is not what its kind says, with its
/// place, a counterexample if there is one of small whole numbers, and the kind it might be. `measured` lines
/// are measured on the scene of their step. A claim that is written beside its formula is a warning where the
/// two do not say the same: where the formula can be read, line by line; elsewhere where the claim speaks of
/// a quantity that the formula does not show, unless the author says that it is in other words. At most
/// kMaxDiagnostics errors, in the order of their places. Where `effort` throws BudgetSpent the claim is an
/// error, and nothing behind it is checked.
std::vector<Diagnostic> check_claims(const Lesson& lesson, std::string_view file_name,
                                     const Effort& effort = {});

}  // namespace polhode
