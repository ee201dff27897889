// SPDX-License-Identifier: MIT
// Sides that are lengths. Internal to lessons/claims/.
#pragma once

#include "lessons/claims/expressions/expression.h"

namespace polhode {

/// Whether a side is a length, norm(a), or one times or by what is never negative: moments, the mass and
/// numbers above 0, as in norm(L)/I1. Two of them are equal where their squares are (with_lengths_squared).
bool is_length(const Expression& side);

}  // namespace polhode
