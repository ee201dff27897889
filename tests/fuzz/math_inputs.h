// SPDX-License-Identifier: MIT
// Formulas that are nearly right, and what must hold of any of them.
#pragma once

#include "render/typeset/math/math.h"
#include "tests/fuzz/mutate.h"

#include <string>

namespace polhode::fuzz {

/// Mutations of the formulas in tests/data/formulas.
Mutator mutated_formulas(std::uint64_t seed);

/// Reads the formula, sets it in display, in line and broken, and says it. What is wrong with the result,
/// empty: nothing.
std::string finding_in(const std::string& tex, const Fonts& fonts);

}  // namespace polhode::fuzz
