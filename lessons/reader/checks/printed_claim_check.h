// SPDX-License-Identifier: MIT
// Whether a claim that is written beside a formula says what the formula says.
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/lesson.h"
#include "physics/effort.h"

#include <vector>

namespace polhode {

/// Line by line where the formula, one of `equations`, can be read; elsewhere letters, relations and numbers
/// are compared, unless the author says that the claim is in other words.
void check_against_formula(const Claim& claim, const std::vector<const Equation*>& equations,
                           const Lesson& lesson, const Prover& prover, Report& report, const Effort& effort);

/// What an author chose to claim, by hand or with \proved, is to say something.
void check_is_not_empty(const Claim& claim, Report& report);

}  // namespace polhode
