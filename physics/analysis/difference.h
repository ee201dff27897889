// SPDX-License-Identifier: MIT
// Rates of change taken from a motion itself: what is claimed about derivatives is measured on the motion
// that is shown, never put in from the equations that it is to confirm.
#pragma once

#include "physics/body/types.h"

#include <array>
#include <utility>

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

/// df/dt and d²f/dt² from the same six values, and f(t), which is `now`: truncation of the second (Ωh)⁶/560,
/// rounding some 4ε/(Ωh)², at Ωh = 0.01 1e-11.
template <class F, class Value>
std::pair<Value, Value> derivatives_at(const F& f, const Value& now, double t_s, double h_s) {
  std::array<Value, 3> odd, even;
  for (std::size_t n = 0; n < 3; ++n) {
    const double step_s = static_cast<double>(n + 1) * h_s;
    const Value after = f(t_s + step_s), before = f(t_s - step_s);
    odd[n] = after - before;
    even[n] = (after - now) + (before - now);
  }
  return {(45.0 * odd[0] - 9.0 * odd[1] + odd[2]) / (60.0 * h_s),
          (270.0 * even[0] - 27.0 * even[1] + 2.0 * even[2]) / (180.0 * h_s * h_s)};
}

/// Ωh of derivative_at for functions that change at the rate Ω.
inline constexpr double kDifferenceAngle = 0.01;

}  // namespace polhode
