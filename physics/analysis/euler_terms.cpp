// SPDX-License-Identifier: MIT
#include "physics/analysis/euler_terms.h"

#include "physics/analysis/difference.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"

#include <algorithm>
#include <cmath>

namespace polhode {

double EulerTerms::largest() const { return std::max({inertial_B.norm(), gyroscopic_B.norm(), N_B.norm()}); }

EulerTerms euler_terms_at(const Motion& motion, const PrincipalMoments& I, const Torque& torque, double t_s) {
  const RigidBodyState now = motion.at(t_s);
  const Vec3 N_B = torque_B(torque, now);
  // The pace at which ω changes: of its own turning, and from rest of what the torque does.
  const double pace = std::max(norm_of(now.w_B), std::sqrt(N_B.norm() / I.vector().minCoeff()));
  const Vec3 gyroscopic_B = now.w_B.cross(angular_momentum_B(I, now.w_B));
  if (pace == 0.0) return {Vec3::Zero(), gyroscopic_B, N_B};
  const auto w_B = [&](double at_s) { return motion.w_B_at(at_s); };
  const Vec3 w_dot_B = derivative_at(w_B, t_s, kDifferenceAngle / pace);
  return {I.vector().cwiseProduct(w_dot_B), gyroscopic_B, N_B};
}

}  // namespace polhode
