// SPDX-License-Identifier: MIT
// What checking a lesson may cost: so much that no lecture comes near it, and so little that nobody waits
// long. Counted in evaluations of the equations of motion, 50 to 90 ns each, and never in time: a lesson that
// passes on one machine passes on all.
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "lessons/diagnostics/diagnostic.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace polhode {

/// Of one lesson, all its checks together: some 5 to 10 seconds of one core. The lecture takes 20 million of
/// it.
inline constexpr std::int64_t kLintBudget = 100'000'000;

// What else is done, as if it were evaluations.
inline constexpr std::int64_t kPageEvaluations = 5'000;  ///< a page laid out
/// And each glyph of its text, at each size tried: 10 in plain text, 40 in a formula of 16,000.
inline constexpr std::int64_t kGlyphEvaluations = 30;
/// A line of a claim, each node of its expressions, the search for a counterexample that there is not; and an
/// inequality or a condition written out in symbols.
inline constexpr std::int64_t kClaimLineEvaluations = 5'000, kClaimNodeEvaluations = 100,
                              kVainSearchEvaluations = 1'000'000, kWrittenOutEvaluations = 200'000;

inline std::int64_t nodes_in(const Equality& equality) {
  return static_cast<std::int64_t>(equality.left.nodes.size() + equality.right.nodes.size());
}

/// Of the first place that was no longer checked.
inline Diagnostic too_long_to_check(std::string_view file, SourcePlace place) {
  return {Severity::error, std::string(file), place,
          "the lesson is too long to check: what comes from here on is not checked",
          "a lesson may take " + std::to_string(kLintBudget / 1'000'000) +
              " million evaluations: shorten `at` and `duration`, take longer steps, or split the lesson"};
}

}  // namespace polhode
