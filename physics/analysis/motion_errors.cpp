// SPDX-License-Identifier: MIT
#include "physics/analysis/motion_errors.h"

#include "base/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// std::max forgets a NaN on its right.
double larger(double a, double b) { return std::isnan(b) || b > a ? b : a; }

/// T and L in units of the body's largest moment and of |ω₀|, so that none overflows unless the motion does.
class Invariants {
 public:
  explicit Invariants(const Problem& problem)
      : I_(problem.I.vector() / problem.I.vector().maxCoeff()), speed_(problem.start.w_B.stableNorm()) {}

  double two_T(const RigidBodyState& state) const {
    const Vec3 w_B = state.w_B / speed_;
    return w_B.dot(I_.cwiseProduct(w_B));
  }
  Vec3 L_S(const RigidBodyState& state) const { return state.q_SB * I_.cwiseProduct(state.w_B / speed_); }

 private:
  Vec3 I_;
  double speed_;
};

}  // namespace

bool is_finite(const RigidBodyState& state) {
  return state.w_B.allFinite() && state.q_SB.coeffs().allFinite();
}

StateError error_of(const RigidBodyState& state, const RigidBodyState& reference) {
  if (!is_finite(state) || !is_finite(reference)) return {kNaN, kNaN};  // Eigen's stableNorm forgets a NaN
  const Quat apart = reference.q_SB.conjugate() * state.q_SB;
  return {(state.w_B - reference.w_B).stableNorm() / reference.w_B.stableNorm(),
          2 * std::atan2(apart.vec().norm(), std::abs(apart.w()))};
}

InvariantDrift drift_along(const Problem& problem, std::span<const RigidBodyState> states) {
  const bool keeps_T = problem.torque.empty();
  const bool keeps_L = std::all_of(problem.torque.begin(), problem.torque.end(), [](const TorqueTerm& term) {
    return std::holds_alternative<EnergySink>(term);
  });
  if (!keeps_L || problem.start.w_B.isZero(0.0)) return {kNaN, kNaN, kNaN};

  const Invariants of(problem);
  const double two_T0 = of.two_T(problem.start);
  const Vec3 L0_S = of.L_S(problem.start);
  InvariantDrift drift;
  for (const RigidBodyState& state : states) {
    const Vec3 L_S = of.L_S(state);
    drift.T = larger(drift.T, std::abs(of.two_T(state) / two_T0 - 1));
    drift.L = larger(drift.L, std::abs(L_S.norm() / L0_S.norm() - 1));
    drift.L_direction_rad = larger(drift.L_direction_rad, angle_between(L0_S, L_S));
  }
  if (!keeps_T) drift.T = kNaN;
  return drift;
}

}  // namespace polhode
