// SPDX-License-Identifier: MIT
// Expressions near a given one: to find out what a learner has slipped on. Internal to lessons/.
#pragma once

#include "lessons/claims/expressions/expression.h"

#include <array>
#include <vector>

namespace polhode {

/// d/dt, d*/dt, and components of ω̇.
bool is_rate(const ExpressionNode& node);

/// The nodes that stand in sums, wherever these are, in the order in which they are written; at most
/// kMostSummands.
std::vector<int> summands_of(const Expression& expression);
inline constexpr std::size_t kMostSummands = 32;

Expression negated(Expression expression);
Expression times(Expression expression, int numerator, int denominator);
/// `summand` is one of summands_of.
Expression with_summand_negated(Expression expression, int summand);
Expression without_summand(Expression expression, int summand);

/// [i] is the axis that is written for axis i, from 0.
using AxisPermutation = std::array<int, 3>;
inline constexpr std::array<AxisPermutation, 5> kAxisPermutations{
    {{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
/// With the axes named otherwise: I1, w1, dw1, N1, e1, Jxx, comp(a, 1) …
Expression renamed(Expression expression, const AxisPermutation& axes);

}  // namespace polhode
