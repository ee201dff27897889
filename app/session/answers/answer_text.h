// SPDX-License-Identifier: MIT
// What is said of questions and answers, with its formulas: to be set, where speech_text.h says it in words.
#pragma once

#include "lessons/claims/answers/answers.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/questions/state_task.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// One block of plain words.
RichText words_text(std::string words);
/// A line with formulas between dollars. A formula that cannot be read stands as it is written.
RichText line_text(std::string_view line);
/// A formula alone.
RichText formula_text(const std::string& tex);
/// `text` behind these words, in its first block.
RichText opened_by(std::string words, RichText text);
/// The blocks of both, one below the other.
RichText joined(RichText text, const RichText& more);
/// One line of both, without a break between.
RichText in_a_row(RichText text, const RichText& more);

/// What a learner is told who gave this answer: the reply to the choice, and after a right one why it is
/// right; may be empty.
RichText text_after(const Ask& ask, const AnswerJudgement& judgement);
/// What is right, and why: a choice, an order of letters, a number with its unit, a formula and how it is
/// typed, a state in numbers with their units.
RichText answer_text(const Lesson& lesson, const Ask& ask);
/// Which choice a letter or a number from 1 is, from 0; nothing: none.
std::optional<std::size_t> choice_named(const Ask& ask, std::string_view answer);
/// An answer that was right, as it was given: a formula that was typed is set, a choice has its words. Empty
/// of nothing.
RichText accepted_text(const Lesson& lesson, const Ask& ask, const std::string& accepted);

/// How an answer of its kind is typed, without what this question refuses: other letters than it asks for,
/// and rates where its answer has none. Precondition: it asks for an expression or a derivation.
std::string how_to_type(const Ask& ask);

/// What is said of an answer in the language of the lesson, whose reason the judgement has in English.
struct ToldVerdict {
  std::string verdict;  ///< "Not right: too large.", "A is not right.", "Right."
  std::string hint;     ///< how it is written, or why it cannot be read; may be empty
};
/// @param text as it was typed
ToldVerdict told_verdict(const Ask& ask, std::string_view text, const AnswerJudgement& judgement,
                         Language language);

/// What is given of the motion that a question is about: all that the reader does not change, as the lesson
/// has it. Empty of nothing.
RichText given_text(const StateTask& task, Language language);

}  // namespace polhode
