// SPDX-License-Identifier: MIT
// Whether the fonts have what a lesson says.
#pragma once

#include "lessons/reader/lesson.h"
#include "render/typeset/fonts.h"

#include <string_view>
#include <vector>

namespace polhode {

/// Sets every text and formula of a lesson once. An error for each character that no font has or that runs
/// from right to left, with its place, at most 100; in the order of their places. About 25 ms for a lecture.
std::vector<Diagnostic> check_type(const Lesson& lesson, const Fonts& fonts, std::string_view file_name);

}  // namespace polhode
