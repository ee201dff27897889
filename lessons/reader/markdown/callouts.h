// SPDX-License-Identifier: MIT
// Block quotes, which are call-outs: what the lecture said, and what it meant, notes, examples and the like.
#pragma once

#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"

#include <vector>

namespace polhode {

/// Call-outs of one quote that are read at most.
inline constexpr std::size_t kMaxCallouts = 64;

/// Names of call-outs, as they are written.
const std::vector<std::string>& callout_names();

/// Call-outs of a quote on the lines first…last; each starts on a line that opens with [!KIND], or with
/// [!quote WHO], [!derivation TITLE].
std::vector<Callout> read_callouts(int first_line, int last_line, TextReader& texts);

}  // namespace polhode
