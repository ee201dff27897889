// SPDX-License-Identifier: MIT
// What a learner is told of an answer.
#pragma once

#include "lessons/claims/answers/answers.h"
#include "lessons/derivation/derivation.h"

#include <string_view>

namespace polhode {

/// As judge_answer, and of expressions more:
/// - They may be typed as lines of derivations are: "omega . L", "w3 w1 (I1 - I3)".
/// - What is right is no answer where it writes the question again, or with other letters than are asked for
///   (restatement.h).
/// - What judge_answer finds no reason for is looked at once more: is a term of the lesson's answer missing
///   in it? Does one of the changes mend it that mend lines of derivations (slips.h): another index, a term
///   with ω×, a moment, a square?
AnswerJudgement judge_with_reasons(const Question& question, std::string_view answer, const Prover& prover,
                                   const LineNotation& how);

/// Whether it would be judged right; the reason is not looked for, so that it takes some 0.1 ms at most for
/// what people type.
bool is_right_answer(const Question& question, std::string_view answer, const Prover& prover,
                     const LineNotation& how);

}  // namespace polhode
