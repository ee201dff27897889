// SPDX-License-Identifier: MIT
// Expressions as one would type them: the way back of typed_formula.h.
#pragma once

#include "lessons/claims/expressions/expression.h"

#include <string>

namespace polhode {

/// A part of an expression, from one of its nodes down: "omega x (I omega)".
std::string typing_of(const Expression& expression, int node);

}  // namespace polhode
