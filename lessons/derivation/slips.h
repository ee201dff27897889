// SPDX-License-Identifier: MIT
// Why a line of a derivation does not hold: the one change that mends it. Internal to lessons/derivation/.
#pragma once

#include "lessons/derivation/derivation.h"

#include <functional>

namespace polhode {

struct FoundSlip {
  Slip slip = Slip::other;
  std::string reason;  ///< one sentence, without a full stop; it names the place, not what is right there
};

/// Which sides are a learner's, to be mended.
enum class MendedSides { both, right };

/// `holds`: whether an equality does, under what the derivation allows. `terms`: what may be missing, in the
/// language of claims. At most kMostMends equalities are tried.
inline constexpr int kMostMends = 1500;
FoundSlip find_slip(const Equality& wrong, const std::vector<std::string>& terms,
                    const std::function<bool(const Equality&)>& holds, const Vocabulary& vocabulary,
                    MendedSides sides = MendedSides::both);

}  // namespace polhode
