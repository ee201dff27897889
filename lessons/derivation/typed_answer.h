// SPDX-License-Identifier: MIT
// An expression that a learner types: in the words of Claims, "w3*w1*(I1 - I3)", or as lines of derivations
// are typed, "w3 w1 (I1 - I3)", "omega . L". Internal to lessons/derivation/.
#pragma once

#include "lessons/derivation/derivation.h"

#include <string_view>

namespace polhode {

struct TypedAnswer {
  Expression expression;
  /// Whether its text is what was typed: places in it mean something to who typed it.
  bool is_as_typed = true;
};

/// What both notations read means the same in both: the words of Claims are tried first. Where neither reads
/// it, the reason is that of the one that gets further, of both as far that of lines. `tex` of what cannot be
/// read is empty.
Result<TypedAnswer, UnreadableLine> read_typed_answer(std::string_view text, const LineNotation& how);

}  // namespace polhode
