// SPDX-License-Identifier: MIT
// Markdown with formulas that is nearly right, and what must hold of any of it.
#pragma once

#include "render/typeset/fonts.h"
#include "tests/fuzz/mutate.h"

#include <string>

namespace polhode::fuzz {

Mutator mutated_texts(std::uint64_t seed);

/// Reads the Markdown as paragraphs and as one line, and sets both in a narrow column, and itself as a
/// caption. What is wrong with the result, empty: nothing.
std::string finding_in_text(const std::string& markdown, bool justified, const Fonts& fonts);

}  // namespace polhode::fuzz
