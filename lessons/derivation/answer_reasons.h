// SPDX-License-Identifier: MIT
// What a learner is told of an answer.
#pragma once

#include "lessons/claims/answers.h"

#include <string_view>

namespace polhode {

/// As judge_answer, and of expressions more:
/// - Who writes the question again has answered nothing. That is so where a formula of the prompt is equal to
///   the lesson's answer, and the learner's is that formula but for brackets, order and I·ω for L, or has a
///   letter that the formula has and the lesson's answer has not: what was to be replaced.
/// - What judge_answer finds no reason for is looked at once more: is a term of the lesson's answer missing
///   in it? Does one of the changes mend it that mend lines of derivations (slips.h): another index, a term
///   with ω×, a moment, a square?
AnswerJudgement judge_with_reasons(const Question& question, std::string_view answer, const Prover& prover,
                                   const Vocabulary& vocabulary);

/// Whether it would be judged right; the reason is not looked for, so that it takes some 0.1 ms at most for
/// what people type.
bool is_right_answer(const Question& question, std::string_view answer, const Prover& prover,
                     const Vocabulary& vocabulary);

}  // namespace polhode
