// SPDX-License-Identifier: MIT
// What stands under an equation: what kind of statement it is, in plain words, whether it is proved, and what
// both its sides come to on the running motion.
#pragma once

#include "base/words/language.h"
#include "lessons/claims/live_claims.h"

#include <string>
#include <vector>

namespace polhode {

/// Of the kinds false and non-sequitur.
bool refutes(ClaimKind kind);

/// What a verdict comes to: proved by exact arithmetic; stated, as laws, definitions and measurements are;
/// the equation, or what is inferred from it, is wrong; or nobody knows.
enum class Certainty { proved, stated, refuted, open };

/// What does not depend on time.
struct VerdictRow {
  const Claim* claim = nullptr;
  Certainty certainty = Certainty::open;
  std::string word;  ///< "true in every motion", "law", "false"
  /// What is given, to which order it holds, how it was measured; goes on behind the word and ", ".
  std::string note;
  /// A state in which what is false fails; goes on behind the note.
  std::string example{};
  /// Where the equation itself is not what is claimed: each line of the claim, as TeX.
  std::vector<std::string> claimed;
  /// What has become of that: it is "proved", "checked" or "stated", or only "claimed"; or it says the
  /// equation "in part".
  std::string_view claimed_is = "claimed";
};
/// `scene` is that of the claim's own step and says how its motion is computed; null where there is none.
/// With a model of it, measured claims are measured. A claim that nobody has proved is "not proved".
VerdictRow verdict_row(const Claim& claim, const Scene* scene, const SceneModel* model, Language language);

/// So many equations of a claim get their numbers; of more there are none.
inline constexpr std::size_t kMostLiveRows = 3;

/// As wide as nearly all of each row; wider ones are set smaller. A row for each equation that has two sides
/// on the page: a chain is one. None for what says that something is 0, unless it is false: 0 = 0 tells
/// nothing.
std::vector<std::string> widest_live_rows(const Claim& claim, Language language);
/// "(0.31, −0.20, 1.13) = (0.31, −0.20, 1.13)", as set_line sets it: what the sides of each row come to, at
/// most two digits behind the point. What holds to an order has "≈" between them, and its numbers are not
/// made equal; where they are further apart than a tenth, "≠". A step that is too long to tell has no
/// numbers, and says so. Empty where there are no values.
std::vector<std::string> live_rows(const Claim& claim, const LiveState& live, View view, Language language);

}  // namespace polhode
