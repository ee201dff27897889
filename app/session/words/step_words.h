// SPDX-License-Identifier: MIT
// What a window says of the step that is shown, beside its text.
#pragma once

#include "app/session/lesson_session.h"

#include <string>

namespace polhode {

/// "stage 18 of 29", in the lesson's language; before a class that sees some of them those are counted,
/// "stage 1 of 2", and the number of another is the lesson's, "stage 18 (not one of the 2 chosen)".
std::string stage_count(const LessonSession& session);
/// "step 2 of 5", likewise.
std::string step_count(const LessonSession& session);
/// Of the window: where one is, or that all lessons are listed. `stage` is the title of the present one.
std::string window_title(const LessonSession& session, const std::string& stage);

/// Its equations, and of a derivation where it begins, where it leads, and the reader's lines: each on a
/// line.
std::string tex_of_step(const LessonSession& session);

}  // namespace polhode
