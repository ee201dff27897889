// SPDX-License-Identifier: MIT
// What an equation claims, as data. proof.h settles it, live_claims.h says what it comes to on a motion.
#pragma once

#include "lessons/claims/expression.h"
#include "lessons/diagnostics/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

enum class ClaimKind { identity, definition, law, motion, free, is_false, measured, non_sequitur };
std::string_view name_of(ClaimKind kind);
/// Nothing if no kind has the name.
std::optional<ClaimKind> claim_kind_from(std::string_view name);
std::vector<std::string> claim_kind_names();

/// One line of a claim: `left = right`, or `premise => conclusion` for a non-sequitur. proof.h settles it.
struct ClaimLine {
  Equality equality;                   ///< of a non-sequitur the premise
  std::optional<Equality> conclusion;  ///< of a non-sequitur
  std::optional<double> within;        ///< of `measured`: relative tolerance after the word
  SourcePlace place;
};
struct Claim {
  std::string equation;  ///< id of an equation of the same stage
  ClaimKind kind = ClaimKind::identity;
  std::vector<ClaimLine> lines;
  SourcePlace place;
};

}  // namespace polhode
