// SPDX-License-Identifier: MIT
// Keys of an ```ask fence of the type state; that its solution reaches its goals.
#pragma once

#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/questions/state_task.h"

#include <optional>

namespace polhode {

/// The keys that only such a question has.
inline constexpr std::array kKeysOfStates = {"goals", "change", "solution"};

/// Nothing, and reports, where one of its keys is wrong or missing; `place` is that of the fence.
std::optional<StateTask> read_state_task(const TomlTable& table, SourcePlace place, TextReader& texts);

/// Behind what is asked: "Goal: … To be changed: …".
void say_what_is_to_be_reached(const StateTask& task, const Vocabulary& vocabulary, Language language,
                               RichText& prompt);

/// What a question asks, as pages and slides have it: the goals of a state question and what may be changed
/// stand where it is answered, in the window's panel and on readers' pages.
RichText without_goals(const Ask& ask);

/// Gives the state questions of a step its scene; what they ask to change has to be there.
void place_state_questions(Step& step, Report& report);

/// That the solution reaches the goals, and that the scene as it stands does not.
void check_state_task(const Ask& ask, Report& report, const Effort& effort);

}  // namespace polhode
