// SPDX-License-Identifier: MIT
#include "physics/body/state.h"

#include <cmath>
#include <stdexcept>

namespace polhode {

RigidBodyState checked(const RigidBodyState& state) {
  if (!state.w_B.allFinite()) throw std::domain_error("angular velocity is not finite");
  const double largest = state.q_SB.coeffs().cwiseAbs().maxCoeff();
  if (!state.q_SB.coeffs().allFinite() || largest == 0)
    throw std::domain_error("attitude is not a finite non-zero quaternion");

  RigidBodyState unit = state;
  auto& q = unit.q_SB.coeffs();
  if (q.norm() == 1.0) return unit;
  const int e = std::ilogb(largest);  // exact scaling: the norm neither overflows nor is subnormal
  q = q.unaryExpr([e](double x) { return std::scalbn(x, -e); }).eval();
  q /= q.norm();
  return unit;
}

}  // namespace polhode
