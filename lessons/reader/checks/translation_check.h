// SPDX-License-Identifier: MIT
// Lessons in another language, NAME.de.md beside NAME.md: whether only words differ.
#pragma once

#include "lessons/reader/lesson.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// "intermediate-axis.md" of "intermediate-axis.de.md"; empty: the name is not that of a translation.
std::string original_of(std::string_view file_name);

/// An error wherever the lessons differ in more than words, at its place in the translation, with that in the
/// original: in ids, stages, steps, what stands on them and in which order; in formulas, numbers, links and
/// citations, text by text, whichever way they stand in it, but for the words of \text{…}; in claims,
/// questions and their right answers, scenes, and all of the front matter that is no text.
///
/// So what lint finds of the original's statements, which it reads in English, holds of those of the
/// translation as far as numbers and formulas say it.
std::vector<Diagnostic> check_translation(const Lesson& translated, std::string_view file,
                                          const Lesson& original, std::string_view original_file);

}  // namespace polhode
