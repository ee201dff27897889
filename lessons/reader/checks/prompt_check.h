// SPDX-License-Identifier: MIT
// Whether a question's answer is what its prompt asks for.
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/checks/numbers/known_numbers.h"
#include "lessons/reader/lesson.h"

#include <functional>
#include <vector>

namespace polhode {

/// Of a prompt that asks for one quantity, "What is $T$?", "How large is the angle between …?", the answer
/// has to be that: an expression, or the formula of the right choice, is proved equal under what the question
/// allows; a number is that of the scene. An order of formulas, "the smallest first", is that of their
/// numbers. The names of a state question's goals are those of what is computed. What a prompt gives of a
/// scene on which the answer is computed, "with $\omega_3 = 5$ rad/s", is so there.
void check_prompt(const Ask& ask, const Lesson& lesson, const Prover& prover,
                  const std::function<std::vector<ShownMotion>()>& motions, Report& report,
                  const Effort& effort);

}  // namespace polhode
