// SPDX-License-Identifier: MIT
// What the formulas of a prompt say: an answer that says the same is none.
#pragma once

#include "lessons/derivation/derivation.h"
#include "render/typeset/rich_text.h"

#include <vector>

namespace polhode {

/// Each side of each equation, and each formula that is one side; those that cannot be read are passed over.
std::vector<Expression> asked_formulas(const RichText& prompt, const LineNotation& how);

}  // namespace polhode
