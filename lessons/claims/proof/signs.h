// SPDX-License-Identifier: MIT
// Inequalities that hold for a reason that can be written down.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/claim_state.h"

namespace polhode {

/// Whether left ≥ right, or > if it is strict, wherever both sides are defined, in every state of every
/// possible body. True is proof; false says nothing.
///
/// The difference is written out, exactly, as a quotient n/d of polynomials (rational_function.h); it has the
/// sign of n d. A term is not negative if its coefficient is positive and no symbol of unknown sign has an
/// odd power in it: moments, J_xx, J_yy, J_zz and m are positive. Any other term c γ is made up for by two of
/// these, s and t with s t = γ², for λ s + μ t ≥ 2 √(λμ) |γ|: so squares are found. All this is tried twice:
/// with the moments as they are, and with I1 = b + c, I2 = c + a, I3 = a + b, where a, b, c ≥ 0 are all that
/// moments of a possible body say (likewise J_xx, J_yy, J_zz). Of moments that are given, linear ones are
/// taken over to a, b, c. So are inequalities that are given: with I3 − I1 = a − c > 0 the bodies are those
/// with a = c + d, d > 0. One that is linear in the moments is used if one of a, b, c alone has a positive
/// factor in it, or none a negative one; of others, that one number (ω_i, N_i, h, k, a constant) is positive
/// or negative. What is not used makes nothing false: it is only not helped by. A strict inequality needs a
/// term that is left over and cannot be 0. At most some 8 ms; what takes longer is not proved.
bool is_never_less(const Equality& sides, bool strict, LawsAssumed laws, const Given& given);

}  // namespace polhode
