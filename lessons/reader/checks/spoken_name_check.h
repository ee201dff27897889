// SPDX-License-Identifier: MIT
// Whether what is called "angular momentum" is it: where a symbol is declared, and at a brace.
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/lesson.h"
#include "physics/effort.h"

namespace polhode {

/// "angular momentum" is L, and nothing else that has its unit.
void check_spoken_names(const Lesson& lesson, const SourceText& source, const Prover& prover, Report& report,
                        const Effort& effort);

/// "kinetic energy" below a brace is what the brace holds.
void check_braces(const Equation& equation, const Lesson& lesson, const SourceText& source,
                  const Prover& prover, Report& report, const Effort& effort);

}  // namespace polhode
