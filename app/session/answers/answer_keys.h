// SPDX-License-Identifier: MIT
// Letters and digits that answer a question, instead of what they do elsewhere (command.h).
#pragma once

#include "app/session/lesson_session.h"

#include <string>
#include <string_view>

namespace polhode {

/// The question of this step that letters answer: the first for one choice that was not answered right since
/// the place was reached; null: there is none.
const Ask* asked_by_letter(const LessonSession& session);

/// Answers that question if the key, "B" or "2", is one of its choices; false, with nothing changed, if not.
bool answer_by_key(LessonSession& session, std::string_view key);

/// Why such a key picks nothing, in a sentence to be told: no question of the step that has this choice is
/// open any more. Empty: it is no letter of a choice, or one that is open has it.
std::string why_no_choice(const LessonSession& session, std::string_view key);

/// Whether the step asks what will happen, and nobody has said so yet, or been told.
bool has_open_prediction(const LessonSession& session);

/// Whether a question of the step was answered, and its motion is yet to show what happens.
bool awaits_answer(const LessonSession& session);

/// Whether an answer to it is typed into a field.
bool is_typed(const Ask& ask);

/// The question that is typed and not yet answered right whose answer the key, one character, begins: while
/// the panel of questions is open any that an answer can begin with; while none is, of a derivation, which is
/// written on the page, the first letter of a name in its first line or its goal, and what is no command.
/// Null: none, and the key is what it is elsewhere.
const Ask* begun_by_letter(const LessonSession& session, std::string_view key);

}  // namespace polhode
