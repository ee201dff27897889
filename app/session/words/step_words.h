// SPDX-License-Identifier: MIT
// What a window says of the step that is shown, beside its text.
#pragma once

#include "app/session/lesson_session.h"

#include <string>

namespace polhode {

/// "stage 18 of 29"; while only some are for this class "stage 18 (1 of 2 chosen)": numbers are the lesson's.
std::string stage_count(const LessonSession& session);

/// Its equations, and of a derivation where it begins, where it leads, and the reader's lines: each on a
/// line.
std::string tex_of_step(const LessonSession& session);

}  // namespace polhode
