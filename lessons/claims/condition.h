// SPDX-License-Identifier: MIT
// Conditions from which something is to follow: "ddt(L) = 0 => …", solved for what they say.
#pragma once

#include "base/result.h"
#include "lessons/claims/claim_state.h"

#include <string>
#include <vector>

namespace polhode {

/// What a premise sets, as an assumption would (given.h): N1 = 0, N2 = 0, N3 = 0. A possible body
/// is in a state in which the premise holds if, and only if, these quantities have what they are set to.
///
/// Each component of the premise, written out (rational_function.h), is solved for a component of N or ω or
/// for a moment that occurs in it once, times moments and numbers only: for such a factor is never 0. So no
/// state in which the premise holds is lost, as w1 = 0 would lose from w1*w2 = 0. Refused, with the reason,
/// is what cannot be solved so.
Result<std::vector<Setting>> settings_of_condition(const Equality& premise, LawsAssumed laws,
                                                   const Given& given);

}  // namespace polhode
