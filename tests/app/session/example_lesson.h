// SPDX-License-Identifier: MIT
// Lessons to walk through.
#pragma once

#include "app/session/lesson_session.h"

#include <string>

namespace polhode::test {

/// Of a text that has no diagnostics.
std::shared_ptr<const LoadedLesson> loaded_text(const std::string& text);
/// Of the lessons that come with the program, by id; read once.
std::shared_ptr<const LoadedLesson> loaded_lesson(const std::string& id);

/// Stages "free" (a scene; the same scene, with a question; the same motion with other overlays; another
/// body), "words" (none), "top" (a heavy top).
std::shared_ptr<const LoadedLesson> example();

/// Of every lesson that comes with the program.
inline const char* const kLessons[] = {"euler-equations", "symmetric-top", "intermediate-axis", "heavy-top",
                                       "numerical-lab"};

}  // namespace polhode::test
