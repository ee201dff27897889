// SPDX-License-Identifier: MIT
// Rates of change taken from a motion itself: what is claimed about derivatives is measured on the motion
// that is shown, never put in from the equations that it is to confirm.
#pragma once

#include "physics/body/types.h"

namespace polhode {

/// df/dt at t by the central difference of sixth order over t ± h, ± 2h, ± 3h; f gives a Vec3. Relative to
/// the rate Ω at which f changes: truncation (Ωh)⁶/140, rounding some ε/(Ωh). Both are about 1e-14 at Ωh =
/// 0.01.
template <class F>
auto derivative_at(const F& f, double t_s, double h_s) {
  using Value = decltype(f(t_s));
  const auto odd = [&](double n) -> Value { return f(t_s + n * h_s) - f(t_s - n * h_s); };
  return Value((45.0 * odd(1.0) - 9.0 * odd(2.0) + odd(3.0)) / (60.0 * h_s));
}

/// Ωh of derivative_at for functions that change at the rate Ω.
inline constexpr double kDifferenceAngle = 0.01;

}  // namespace polhode
