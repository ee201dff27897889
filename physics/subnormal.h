// SPDX-License-Identifier: MIT
// Numbers below the normal ones, in which a damped motion ends: rest is never reached, and processors take
// long.
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
