// SPDX-License-Identifier: MIT
// What stands around computed numbers in a formula, before any side is read. Internal to lessons/notation/
// (tex_numbers.h).
#pragma once

#include "lessons/notation/tex_items.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace polhode {

/// So many computed numbers stand in it.
std::size_t numbers_in(const TexItem& item);
std::size_t numbers_in(std::span<const TexItem> items);
/// Adds their indices in Math::live; those of scripts and labels are not counted.
void collect(const TexItem& item, std::vector<std::size_t>& numbers);
/// The index in Math::live of what is a computed number and no more.
std::optional<std::size_t> number_of(const TexItem& item);

/// A comma, a wide space, a new line.
bool is_break(const TexItem& item);
/// "1, 2, …, 7"
bool is_dots(std::span<const TexItem> items);
/// Words that part what is said of two things, and say nothing of either: "and", "so".
bool joins_sentences(const TexItem& words);
bool has_words(const MathNode& node);
/// A letter as those of units.
bool is_upright(const TexItem& item);

/// What stands between brackets with commas, or in the cells of a matrix; empty of a side that is neither.
std::vector<TexItems> cells_of(std::span<const TexItem> side);

}  // namespace polhode
