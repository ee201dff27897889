// SPDX-License-Identifier: MIT
// The row under an equation that says what kind of statement it is, whether it is proved, and what both its
// sides come to on the running motion.
#pragma once

#include "lessons/claims/live_claims.h"

#include <string>

namespace polhode {

/// Of the kinds false and non-sequitur.
bool refutes(ClaimKind kind);

/// What does not depend on time.
struct VerdictRow {
  const Claim* claim = nullptr;
  std::string word;      ///< "MOTION"
  std::string note;      ///< "proved for any torque"; of what is false a counterexample
  bool refutes = false;  ///< the equation, or what is inferred from it
  bool proved = true;    ///< the claim is what its kind says
};
/// `scene` is that of the claim's own step and says how its motion is computed; null where there is none.
/// With a model of it, measured claims are measured. A claim that nobody has proved is "not proved".
VerdictRow verdict_row(const Claim& claim, const Scene* scene, const SceneModel* model);

/// "(0.31, −0.20, 1.13) = (0.31, −0.20, 1.13), apart 2·10⁻¹⁵ ≤ 4·10⁻¹³", as set_line sets it: what the two
/// sides of the equation come to. Of a claim of several lines only how far the worst of them is off. No
/// numbers where the step is too long to tell, and nothing where there are no values.
std::string live_text(const Claim& claim, const LiveState& live, View view);
/// As wide as the live values of nearly every claim become; wider ones are set smaller.
std::string widest_live_text(const Claim& claim);

}  // namespace polhode
