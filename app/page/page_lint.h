// SPDX-License-Identifier: MIT
// Whether what a lesson's steps add fits on a page.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/effort.h"
#include "render/typeset/fonts.h"

#include <string_view>
#include <vector>

namespace polhode {

/// Composes the page of every step, wide, narrow and upright. A warning, at the step's first line, where its
/// type or a formula has to be much smaller than normal; an error where no page can hold it, or its figure
/// cannot be. About 5 ms a step of the lecture. Where `effort` throws BudgetSpent the step is an error, and
/// nothing behind it is checked.
std::vector<Diagnostic> page_diagnostics(const Lesson& lesson, const Fonts& fonts, std::string_view file_name,
                                         const Effort& effort = {});

/// The errors of figures alone, for a window, whose pages scroll: a step whose scene cannot be. No text is
/// set. About 0.5 ms a step of the lecture.
std::vector<Diagnostic> scene_errors(const Lesson& lesson, std::string_view file_name,
                                     const Effort& effort = {});

}  // namespace polhode
