// SPDX-License-Identifier: MIT
// Syntax of the expressions in claims and answers: names, brackets, operators. What they mean is the
// checker's.
#pragma once

#include "lessons/report.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Brackets of an expression nest at most so deep.
inline constexpr int kMaxExpressionNesting = 64;

/// Reports, with columns, what keeps a text from being an expression: characters and names that are not
/// known, brackets, operators without operand, functions with too few or too many arguments. The text stands
/// on one line, its first byte at `start`. Linear.
/// @return true if nothing was reported.
bool check_expression(std::string_view text, SourcePlace start, Report& report);

/// Names an expression can use, for "did you mean".
const std::vector<std::string>& expression_symbols();
std::vector<std::string> expression_functions();

}  // namespace polhode
