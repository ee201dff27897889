// SPDX-License-Identifier: MIT
// Any body under any torque by the embedded Runge-Kutta pairs of Dormand & Prince, 5(4) and 8(5,3), with a
// step that follows the error and dense output. It keeps nothing: T and |L| drift, within the tolerance.
//
// Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19-26. Hairer, Nørsett & Wanner (HNW), Solving Ordinary
// Differential Equations I, 2nd ed.: §II.4 (step control, (4.11)-(4.13); starting step, p. 169), Table
// II.5.2, §II.6 (dense output), §II.10 (error estimate and dense output of 8(5,3)). State y = (ω_B, q_SB),
// equations of equations_of_motion.h, numbers of dormand_prince_coefficients.h.
//
// Tolerance. A step is taken if the estimate of what it alone adds to the error is at most
//
//     err = ( |δω|²/w² + |δq|² )^½ ≤ tolerance,   w = max_i max(|ω_i| before, |ω_i| after the step):
//
// ω in units of itself (and no less than 2⁻⁹⁶⁰ of the unit below, where it has died away), q absolute, whose
// length is 1. For 8(5,3) δ = δ₅ |δ₅|/(|δ₅|² + 0.01 |δ₃|²)^½ (HNW §II.10). Taken or refused, the step that
// follows is h times
//
//     1/5 if f ≤ 1/5, otherwise min(6, f) rounded down to a multiple of 1/64,
//     f = 0.9 (tolerance/err)^(1/order), order 5 or 8,
//
// and after a refusal no longer than the step that is then taken (HNW (4.13)). The starting step is
// (0.01 tolerance)^(1/order)/max(|ẏ|, |ÿ|^½), ÿ from a trial step of 0.01/max(|ω_i|, |ω̇_i|^½), at most 100 of
// these, rounded down to a power of two: after HNW p. 169, but knowing no unit of time. Both roundings keep
// the last bit of a library's pow out of the motion. What the steps add grows with time as the motion lets
// it: see the table. After each step q is scaled to unit length, which changes no attitude and so no error.
//
// Error (the larger of ω, relative, and q) after N periods of I = (1, 2, 3), by tolerance:
//
//     tolerance            1e-6     1e-8     1e-10    1e-12
//     ω = (0.1, 1.5, 0.2)
//       5(4)   N = 1       2e-6     8e-9     8e-11    9e-13
//              N = 1000    -        7e-3     7e-5     7e-7
//       8(5,3) N = 1       2e-6     1e-8     8e-11    1e-12
//              N = 1000    -        4e-3     3e-5     1.4e-7
//     ω = (0.34641, 1.5, 0.2), near the separatrix, where rounding alone gives 5e-9 and 2e-4
//       5(4)   N = 1       5e-6     6e-8     4e-9     2e-9
//              N = 1000    -        6e-2     7e-4     4e-5
//       8(5,3) N = 1       4e-6     3e-8     1e-9     5e-9
//              N = 1000    -        2e-2     1.4e-4   2e-5
//
// against the exact motion. It grows as N², because T and |L| drift as N; the least there is for the first at
// N = 1000 is 4e-10, by 8(5,3) at 1e-15. Evaluations a period of the first: 5(4) 320, 790, 2000, 5000;
// 8(5,3) 290, 460, 660, 1090.
//
// At any scale: computed in units in which the moments and the rates are about 1, powers of two both, so that
// results scale to the bit with I, N and with ω, 1/t, √N.
#pragma once

#include "physics/body/equations_of_motion.h"
#include "physics/effort.h"
#include "physics/motion.h"

#include <cstdint>
#include <memory>
#include <span>

namespace polhode {

enum class DormandPrincePair { five_four, eight_five_three };

/// One step of the signed length h with the solution of order 5 or 8; no error control, q not normalised.
MotionVector dormand_prince_step(DormandPrincePair pair, const EquationsOfMotion& equations,
                                 const MotionVector& y, double h);

/// The dense output of that step at y(t + θh), 0 ≤ θ ≤ 1: error of order 4 or 7, once differentiable in t
/// from one step to the next, y at θ = 0 and the step's solution at θ = 1 (to rounding).
MotionVector dormand_prince_dense(DormandPrincePair pair, const EquationsOfMotion& equations,
                                  const MotionVector& y, double h, double theta);

class DormandPrinceMotion final : public Motion {
 public:
  /// Times that take more steps than this are not computed: 5 to 10 seconds of one core, all of which
  /// pass before it is known that a time lies too far.
  static constexpr std::int64_t kMaxSteps = 20'000'000;
  /// A smaller tolerance is taken to be this one: rounding adds more to every step.
  static constexpr double kMinTolerance = 1e-15;

  /// @throws std::domain_error if checked(Problem) refuses it, or not 0 < tolerance < 1.
  DormandPrinceMotion(DormandPrincePair pair, const Problem& problem, double tolerance,
                      std::int64_t max_steps = kMaxSteps, const Effort& effort = {});
  ~DormandPrinceMotion() override;

  /// By the dense output of the step that t lies in; steps start from t = 0 in both directions and do not
  /// depend on the times asked. New times cost one step for each step not yet taken, times seen before at
  /// most 16 steps (more once 2·10⁵ have been taken). NaN in every component if t is more than
  /// max_steps away, which no one knows beforehand (max_time_s() is infinite), or ω overflows, or no step is
  /// short enough.
  RigidBodyState at(double t_s) const override;

  /// The same numbers; times in order cost little more than the steps between them.
  void at(std::span<const double> t_s, std::span<RigidBodyState> states) const override;

  /// With the refused steps, the two evaluations of the starting step and the three of the dense output of
  /// 8(5,3). 0 where at(t_s) is NaN or t_s = 0.
  std::int64_t evaluations_to(double t_s) const override;

  /// Whether max_steps steps end before t: costs them, where they have not been taken.
  bool is_too_far(double t_s) const override;

  std::string_view method() const override;

  double tolerance() const { return tolerance_; }

 private:
  class Path;

  DormandPrincePair pair_;
  double tolerance_;
  std::unique_ptr<const Path> path_;
};

}  // namespace polhode
