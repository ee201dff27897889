// SPDX-License-Identifier: MIT
// A lesson as plain text, for those who read with their ears or fingers.
#pragma once

#include "lessons/reader/lesson.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline constexpr std::size_t kTranscriptColumns = 80;

/// Title, stages (by id; empty: all) with their prose, equations in words with their tags, what the lecture
/// said and meant, and questions with their choices; no hints and no answers. At the end what is cited.
/// UTF-8, lines of at most kTranscriptColumns characters where words allow, each ended.
std::string transcript_of(const Lesson& lesson, const std::vector<std::string>& stages);

/// The words in lines of at most kTranscriptColumns characters; the first begins with `first`, the others
/// with as many blanks.
std::string wrapped(std::string_view words, const std::string& first);

}  // namespace polhode
