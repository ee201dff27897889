// SPDX-License-Identifier: MIT
#include "physics/state.h"

#include <cmath>
#include <stdexcept>

namespace polhode {

RigidBodyState checked(const RigidBodyState& state) {
  if (!state.w_B.allFinite()) throw std::domain_error("angular velocity is not finite");
  const double norm = state.q_SB.coeffs().stableNorm();
  if (!std::isfinite(norm) || norm == 0)
    throw std::domain_error("attitude is not a finite non-zero quaternion");

  RigidBodyState unit = state;
  if (norm != 1.0) unit.q_SB.coeffs() /= norm;
  return unit;
}

}  // namespace polhode
