// SPDX-License-Identifier: MIT
// Letters and digits that answer a question, instead of what they do elsewhere (command.h).
#pragma once

#include "app/session/lesson_session.h"

#include <string_view>

namespace polhode {

/// The question of this step that letters answer: the first for one choice that was not answered right since
/// the place was reached; null: there is none, and every key is a command.
const Ask* asked_by_letter(const LessonSession& session);

/// Answers that question if the key, "B" or "2", is one of its choices; false, with nothing changed, if not.
bool answer_by_key(LessonSession& session, std::string_view key);

}  // namespace polhode
