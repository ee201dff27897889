// SPDX-License-Identifier: MIT
// Whether a lesson's own derivation is one.
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/lesson.h"
#include "physics/effort.h"

namespace polhode {

/// Every line of it holds, none for any factor alike, and the last, and no line before, is the goal.
void check_derivation(const Ask& ask, const Derivation& derivation, const Prover& prover, Report& report,
                      const Effort& effort);

}  // namespace polhode
