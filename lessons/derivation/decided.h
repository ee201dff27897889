// SPDX-License-Identifier: MIT
// Whether a line that holds could have failed. Internal to lessons/.
//
// Without torque dT/dt = 0, so that "dT/dt = 2 w1 w2 w3 ((I2 - I3) + (I3 - I1) + (I1 - I2))" holds with any
// factor in front: both its sides are 0, and it is evidence of nothing.
#pragma once

#include "lessons/derivation/derivation.h"

namespace polhode {

/// Precondition: the line holds under what the derivation allows.
///
/// A line is suspect if both its sides are 0 there and neither is written as 0: without torque
/// "dT/dt = 2 dT/dt". Or if one of several terms is 0 there: "L = L + dT/dt omega". A suspect line is decided
/// all the same if one of these is so:
/// - It holds under less, with sides that are not 0 there: as an identity, in every motion, or without what
///   is given. Without torque both sides of "dL/dt = d*L/dt + omega x L" are 0, but it is an identity.
/// - It holds under another law, once that law is written into the line: N1/(w2 w3) is added to each I2 - I3,
///   which stands for I1 w1'/(w2 w3), and N is taken from each omega x L.
/// - It is a line of the lesson's solution, multiplied out, and none of its terms cancel.
bool is_decided(const Equality& link, const Derivation& derivation, const Prover& prover);

/// Whether both sides are the same factors and terms in another order, a·b = b·a: this says nothing. Not so
/// of an identity of vectors, a·(b×c) = b·(c×a), and not of a bracket that is multiplied out.
bool is_mere_rearrangement(const Equality& equality);

}  // namespace polhode
