// SPDX-License-Identifier: MIT
// Questions for a number: the keys that say what is right, and what it comes to on the motion of their step.
#pragma once

#include "lessons/claims/answers/number_answer.h"
#include "lessons/reader/front_matter/toml_tree.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"
#include "physics/effort.h"

#include <optional>

namespace polhode {

/// `answer`, `unit` and `within` of a question for a number. Nothing, and reports, where one is wrong.
/// Precondition: there is an answer.
std::optional<NumberAnswer> read_number_answer(const TomlTable& keys, TextReader& texts);

/// "Answer in rad/s, to within 2 %.", to stand behind what is asked.
std::string words_of_what_is_asked(const NumberAnswer& answer);

/// Computes the answers to all questions for a number, on the motion of their step at the time of its still,
/// once for all who ask. What has no value there has none, and lint says so.
/// @returns the place of the first question whose answer is not computed because `effort` threw BudgetSpent
std::optional<SourcePlace> compute_answers(Lesson& lesson, const Effort& effort = {});

}  // namespace polhode
