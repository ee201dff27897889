// SPDX-License-Identifier: MIT
// The answers to a stage's questions in a line, as at the end of a textbook's chapter.
#pragma once

#include "lessons/reader/lesson.h"

#include <string>

namespace polhode {

/// "step 2, B; step 4, 0.25 J; step 7, for example " and a state (state_line.h), as set_lines() of
/// render/typeset/paragraph.h sets it; empty where nothing is asked. Of an order the letters from the first
/// to the last. Derivations are left out, for their lines are the text's own, and so are states whose numbers
/// have many digits, or that have an attitude.
std::string short_answers(const Lesson& lesson, const Stage& stage);

}  // namespace polhode
