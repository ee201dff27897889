// SPDX-License-Identifier: MIT
// Numbers below the normal ones, in which a damped motion ends: rest is never reached, and processors take
// long.
//
// Adaptive and fixed-step motions look at the components of their state alone. Where these are normal but
// their products are not, as with |ω| about 1e-157, evaluations are as dear and count 1 all the same.
#pragma once

#include <cmath>
#include <cstdint>

namespace polhode {

/// What an evaluation with such numbers counts in an Effort (effort.h) where others count 1: so many times it
/// is as dear. Seen with Dormand-Prince 8(5,3) on x86-64: 20.
inline constexpr std::int64_t kSubnormalFactor = 20;

template <class... Numbers>
bool any_subnormal(Numbers... x) {
  return ((std::fpclassify(x) == FP_SUBNORMAL) || ...);
}

}  // namespace polhode
