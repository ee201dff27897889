// SPDX-License-Identifier: MIT
// A motion of a rigid body as a function of time.
//
// Closed forms: steady rotation, two equal moments, three different ones (physics/exact/). Step by step: the
// integrators. method.h makes a motion of either kind by its name.
#pragma once

#include "physics/body/state.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace polhode {

/// Pure and random-access: at(t) depends on the motion and t alone, never on the times asked before; any sign
/// of t; safe to call from several threads. Never throws once constructed, except for lack of memory and what
/// its Effort throws (effort.h). At a time that it cannot reach, every component of the answer is NaN.
class Motion {
 public:
  virtual ~Motion() = default;

  /// State at t_s seconds after the start, rad/s and unit quaternion.
  virtual RigidBodyState at(double t_s) const = 0;

  /// ω_B alone, rad/s: the same numbers as at(t_s).w_B, for less where the attitude is not needed for it.
  virtual Vec3 w_B_at(double t_s) const { return at(t_s).w_B; }

  /// states[i] = at(t_s[i]), to the bit; spans of equal length. Faster than a loop where the motion can.
  virtual void at(std::span<const double> t_s, std::span<RigidBodyState> states) const {
    for (std::size_t i = 0; i < t_s.size(); ++i) states[i] = at(t_s[i]);
  }

  /// The longest |t| that is computed, s; beyond it the answer is NaN.
  virtual double max_time_s() const { return std::numeric_limits<double>::infinity(); }

  /// Why at(t_s) is NaN, where it is: true if the way to t_s takes more steps than the motion makes, false if
  /// ω overflows on it.
  virtual bool is_too_far(double t_s) const { return std::abs(t_s) > max_time_s(); }

  /// Evaluations of the right-hand side that the way from the start to t_s takes where nothing of it is known
  /// yet; for a closed form 1, the formula.
  virtual std::int64_t evaluations_to(double t_s) const {
    static_cast<void>(t_s);
    return 1;
  }

  /// The name of its method, one of method_names() (method_facts.h): "uniform", "symmetric", "rk4", ...
  virtual std::string_view method() const = 0;
};

}  // namespace polhode
