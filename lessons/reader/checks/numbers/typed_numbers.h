// SPDX-License-Identifier: MIT
// Numbers that an author typed into plain text, "5 kJ" or "27°".
#pragma once

#include "lessons/notation/tex_sides.h"
#include "render/typeset/rich_text.h"

#include <optional>
#include <vector>

namespace polhode {

/// A line with each number of its text that a unit stands behind, or a verb before and nothing behind, as a
/// formula of its own, so that both are looked at in the same way; its source begins where it is typed.
std::vector<TextSpan> with_numbers_apart(const std::vector<TextSpan>& line);

/// The number that a cell is, "5 J", "5" or "$5$ J"; nothing of one that has more or something else.
std::optional<TypedNumber> number_in_cell(const TextTable::Cell& cell);

}  // namespace polhode
