// SPDX-License-Identifier: MIT
// Block quotes: what the lecture said, and what it meant.
#pragma once

#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"

#include <vector>

namespace polhode {

/// Call-outs of one quote that are read at most.
inline constexpr std::size_t kMaxCallouts = 64;

/// Call-outs of a quote on the lines first…last; each starts on a line that opens with [!said] or [!meant].
std::vector<Callout> read_callouts(int first_line, int last_line, TextReader& texts);

}  // namespace polhode
