// SPDX-License-Identifier: MIT
// The clause of a line that speaks of what stands behind it, "half of $I_3$ is", or before it, "is half of
// $I_3$".
#pragma once

#include "lessons/claims/relation.h"
#include "render/typeset/rich_text.h"

#include <optional>
#include <vector>

namespace polhode {

/// The stretches of the clause before one of a line, whole formulas and the end of a text.
std::vector<TextSpan> clause_before(const std::vector<TextSpan>& line, std::size_t at);

/// Cut off the end of a clause what joins it to what follows, "is", "is always", "has the length": what it
/// says of both. Nothing of other words.
std::optional<Relation> take_verb(std::vector<TextSpan>& clause);

/// The same of "is more than", "exceeds", "is less than", "never exceeds"; "at most", "never" and the like
/// may be equal.
std::optional<Relation> take_comparison(std::vector<TextSpan>& clause);

/// The same of "stays between", "lies between", "varies between": whether it is meant of all times; nothing
/// of other words.
std::optional<bool> take_between(std::vector<TextSpan>& clause);

/// The stretches of the clause behind one of a line, up to the stop or comma that ends it.
std::vector<TextSpan> clause_behind(const std::vector<TextSpan>& line, std::size_t at);
/// Cut off the beginning of a clause what joins it to what stands before, "is", "is always", "equals".
std::optional<Relation> take_verb_at_start(std::vector<TextSpan>& clause);

/// Whether there is more in it than a formula.
bool has_words(const std::vector<TextSpan>& clause);

}  // namespace polhode
