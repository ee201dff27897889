// SPDX-License-Identifier: MIT
// A lesson's text read, and all of it checked that is to hold before it is shown: that its scenes can be
// modelled, and what of its claims is proved.
#pragma once

#include "lessons/reader/reader.h"
#include "physics/effort.h"

#include <string_view>
#include <vector>

namespace polhode {

/// What the reader says of a text, and if it has no error, what the model says of its scenes. In the order of
/// places. Its claims are proved, which check_claims tells of. Where `effort` throws BudgetSpent the stage,
/// or the claim, is an error, and nothing behind it is checked.
LessonReading check_lesson(std::string_view text, std::string_view file_name, const Effort& effort = {});

/// Adds diagnostics to others, all in the order of their places.
void add_in_order(std::vector<Diagnostic> more, std::vector<Diagnostic>& all);

}  // namespace polhode
