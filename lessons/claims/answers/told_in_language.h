// SPDX-License-Identifier: MIT
// What a learner is told of an answer, in the language of the lesson. The judgements themselves are in
// English (answers.h, number_answer.h), as logs and the command line say them.
#pragma once

#include "base/words/language.h"
#include "lessons/claims/answers/answers.h"

#include <string>
#include <string_view>

namespace polhode {

/// As judge_number (number_answer.h): reason and hint in this language, all else the same.
AnswerJudgement judge_number_in(Language language, const NumberAnswer& answer, std::string_view text);

/// As words_of_reason (reason_tags.h).
std::string words_of_reason_in(Language language, std::string_view tag);

}  // namespace polhode
