// SPDX-License-Identifier: MIT
// The lines of a ```claim fence.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/diagnostics/report.h"
#include "lessons/diagnostics/source_text.h"

#include <string_view>
#include <vector>

namespace polhode {

/// Lines of one claim that are read at most.
inline constexpr std::size_t kMaxClaimLines = 64;

/// Claims on the lines first…last of the source, each `left = right`, `premise => conclusion` for a
/// non-sequitur, with `within 1e-9` at its end allowed for a measured one. Empty lines are passed over; wrong
/// ones are reported and left out. `vocabulary` has the lesson's words; null: none.
std::vector<ClaimLine> read_claim_lines(const SourceText& source, int first_line, int last_line,
                                        ClaimKind kind, Report& report,
                                        const Vocabulary* vocabulary = nullptr);

}  // namespace polhode
