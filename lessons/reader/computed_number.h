// SPDX-License-Identifier: MIT
// A number in the texts and formulas of a lesson that the program computes.
#pragma once

#include "lessons/claims/live_claims.h"
#include "lessons/diagnostics/diagnostic.h"
#include "render/typeset/math/math.h"

#include <optional>
#include <string>

namespace polhode {

/// Of \live, or of \value, which was typed and is to be what is computed.
struct ComputedNumber {
  Expression expression;  ///< a scalar
  double unit_si = 1;     ///< of the unit in which it is shown
  LiveNumber written;
  SourcePlace place;  ///< of the expression

  bool is_typed() const { return !written.typed.empty(); }
};

/// What it is on a motion, in its unit; nothing where it has no value.
std::optional<double> value_of(const ComputedNumber& number, const LiveState& live);

/// What should have been typed: the value with as many digits behind the point and the same power of ten.
/// Nothing if what was typed is off by no more than half a unit of its last digit. Precondition: it is typed.
std::optional<std::string> right_instead(const ComputedNumber& number, double value);

}  // namespace polhode
