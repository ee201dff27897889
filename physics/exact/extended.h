// SPDX-License-Identifier: MIT
// Extended, the numbers in which the constants of a motion are computed before they are rounded to double: of
// 64 bits at least, and of a range in which products of a few doubles stay.
//
// It is long double where that is more than double (x87: 64 bits, 15 bits of exponent; aarch64 GNU/Linux: 113
// bits), and DoubleDouble where it is not (MSVC, macOS on ARM, -mlong-double-64). Functions of it are called
// by unqualified names: those of the C library for long double, their own for DoubleDouble. Algorithms stop
// at η = 2⁻⁶⁴, whichever it is; the results, rounded to double, agree but for some last bits.
#pragma once

#include "physics/exact/double_double.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace polhode {

/// 64 bits, and exponents that hold the product of eight doubles: k² has five as factors above its line.
inline constexpr bool kLongDoubleIsExtended =
    std::numeric_limits<long double>::digits >= 64 &&
    std::numeric_limits<long double>::max_exponent >= 8 * std::numeric_limits<double>::max_exponent &&
    std::numeric_limits<long double>::min_exponent <= 8 * (std::numeric_limits<double>::min_exponent - 53);

using Extended = std::conditional_t<kLongDoubleIsExtended, long double, DoubleDouble>;
inline constexpr Extended kPi = std::numbers::pi_v<Extended>;

// Without them an unqualified sqrt of long double might be that of double.
using std::abs;
using std::asinh;
using std::ilogb;
using std::scalbn;
using std::sqrt;

/// One rounding where it is long double, none where it is not.
inline Extended to_extended(const DoubleDouble& x) { return scalbn(Extended{x.hi()} + x.lo(), x.exponent()); }

}  // namespace polhode
