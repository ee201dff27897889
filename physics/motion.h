// SPDX-License-Identifier: MIT
// A motion of a rigid body as a function of time.
//
// Implementations: uniform_motion.h (steady rotation), symmetric_motion.h (two equal moments), rk4_motion.h
// (any body, any torque, fixed step). The torque-free asymmetric body in closed form, with the separatrix,
// will be asymmetric_motion.h: it starts from polhode_constants.h, which holds what it shares with the
// polhode curve. Which of them serves a scene is chosen in render/scene/model.h and nowhere else.
#pragma once

#include "physics/state.h"

#include <optional>
#include <string_view>

namespace polhode {

/// Pure and random-access: at(t) depends on the motion and t alone, never on the times asked before; any sign
/// of t; safe to call from several threads. Never throws once constructed, except for lack of memory. At
/// times it cannot reach (see the implementation) every component of the answer is NaN.
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
