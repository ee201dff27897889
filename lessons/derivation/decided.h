// SPDX-License-Identifier: MIT
// Whether a line that holds could have failed. Internal to lessons/.
//
// Without torque dT/dt = 0, so that "dT/dt = 2 w1 w2 w3 ((I2 - I3) + (I3 - I1) + (I1 - I2))" holds with any
// factor in front: both its sides are 0, and it is evidence of nothing.
#pragma once

#include "lessons/derivation/derivation.h"

namespace polhode {

/// Precondition: it holds under what the derivation allows. Undecided is a line both of whose sides are 0
/// there, without being written as 0, or one of whose terms is, unless
/// - it holds under less: as an identity, in every motion, or without what is given; or
/// - it holds once the law is another, and is another in the line too: with N1/(w2 w3) added to each I2 - I3,
///   which stands for I1 w1'/(w2 w3), and N taken from each omega x L; or
/// - it is a line of the lesson's solution, multiplied out, with none of its terms cancelled.
bool is_decided(const Equality& link, const Derivation& derivation, const Prover& prover);

/// Whether both sides are the same factors and terms in another order, a·b = b·a: this says nothing. Not so
/// of an identity of vectors, a·(b×c) = b·(c×a), and not of a bracket that is multiplied out.
bool is_mere_rearrangement(const Equality& equality);

}  // namespace polhode
