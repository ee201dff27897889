// SPDX-License-Identifier: MIT
// A motion of a rigid body as a function of time.
#pragma once

#include <optional>
#include <string_view>

#include "physics/state.h"

namespace polhode {

/// Pure and random-access: at(t) depends on the motion and t alone, never on the times asked before; any sign of t;
/// safe to call from several threads. Never throws once constructed.
class Motion {
 public:
  virtual ~Motion() = default;

  /// State at t_s seconds after the start, rad/s and unit quaternion.
  virtual RigidBodyState at(double t_s) const = 0;

  /// ω_B alone, rad/s: the same numbers as at(t_s).w_B, for less where the attitude is not needed for it.
  virtual Vec3 w_B_at(double t_s) const { return at(t_s).w_B; }

  /// The field's term for the method, as in `--method`: "uniform", "symmetric", "rk4", ...
  virtual std::string_view method() const = 0;
};

}  // namespace polhode
