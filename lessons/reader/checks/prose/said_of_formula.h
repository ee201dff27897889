// SPDX-License-Identifier: MIT
// What the words before and behind a formula say of it, as far as they can be read.
#pragma once

#include "lessons/notation/tex_statements.h"
#include "lessons/reader/lesson.h"

#include <string>
#include <vector>

namespace polhode {

/// Of the formula that is this stretch of a line:
///
///   "The energy is $2T$"           a name in words, a verb; the formula ends its clause
///   "$T$ is half the energy"       a verb, a name in words or another formula, and nothing else
///   "$I_1$ exceeds $I_2$"          likewise "is larger than", "is equal to", "is parallel to" …
///   "$I_1$ and $I_2$ are equal"    or parallel, or perpendicular
///   "$T$ vanishes", "$T$ is constant", "$T$ never changes"
///
/// Nothing of a formula that is a part of a longer name, "the square of $T$ is", nor of numbers.
std::vector<StatedLink> said_of_formula(const std::vector<TextSpan>& line, std::size_t at,
                                        const Lesson& lesson);

/// "the angular momentum $T$": whatever it is, it is not of that kind; empty where it may be.
std::string why_not_called(const std::vector<TextSpan>& line, std::size_t at, const Lesson& lesson);

}  // namespace polhode
