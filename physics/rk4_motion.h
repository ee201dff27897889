// SPDX-License-Identifier: MIT
// Any body under any torque by the classical Runge-Kutta method of order 4 with a fixed step.
// Kutta 1901; Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, §II.1. It keeps nothing:
// T, |L| and |q| drift, which the lecture shows. State y = (ω_B, q_SB), equations of euler.h, torque of
// torque.h.
//
// The grid is t = k h from the start, k of either sign; a time between grid points is one shorter step from
// the grid point towards the start. Time is never accumulated, and at(t) depends on scene and t alone
// (checkpoints.h). The quaternion is carried as the method gives it and normalised only in the answer; q̇ is
// linear in q, so its length changes no direction (it is scaled by powers of two, which is exact, lest it
// overflow), and a torque that depends on attitude uses q/|q|.
#pragma once

#include "physics/motion.h"
#include "physics/principal_moments.h"
#include "physics/torque.h"

#include <cstdint>
#include <memory>

namespace polhode {

class Rk4Motion final : public Motion {
 public:
  /// Times further than this many steps from the start are not computed: at most about 40 seconds of one
  /// core.
  static constexpr std::int64_t kMaxSteps = 100'000'000;

  /// @throws std::domain_error if the state or the torque is not finite, or the step is not finite and > 0.
  Rk4Motion(const PrincipalMoments& I, const Torque& torque, const RigidBodyState& start, double step_s);
  ~Rk4Motion() override;

  /// Error of order h⁴ in ω and in q. New times cost about 0.1 to 0.4 µs a step, times seen before at most
  /// 16 steps (more once 2·10⁵ have been taken). NaN in every component if |t| > max_time_s() or ω has
  /// overflowed on the way; NaN in q alone if only q has (|ω|h beyond 1e50).
  RigidBodyState at(double t_s) const override;

  /// Bitwise at(t_s).w_B; integrates ω alone if the torque does not depend on attitude.
  Vec3 w_B_at(double t_s) const override;

  std::string_view method() const override { return "rk4"; }

  double step_s() const { return step_s_; }

  /// kMaxSteps·h: the longest |t| that is computed, s.
  double max_time_s() const { return static_cast<double>(kMaxSteps) * step_s_; }

 private:
  struct Paths;

  double step_s_;
  bool attitude_needed_for_w_;
  std::unique_ptr<const Paths> paths_;
};

}  // namespace polhode
