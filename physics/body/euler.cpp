// SPDX-License-Identifier: MIT
#include "physics/body/euler.h"

namespace polhode {

Vec3 angular_momentum_B(const PrincipalMoments& I, const Vec3& w_B) { return I.vector().cwiseProduct(w_B); }

Vec3 angular_momentum_S(const PrincipalMoments& I, const RigidBodyState& state) {
  return state.q_SB * angular_momentum_B(I, state.w_B);
}

double kinetic_energy(const PrincipalMoments& I, const Vec3& w_B) {
  return 0.5 * (I[0] * w_B[0] * w_B[0] + I[1] * w_B[1] * w_B[1] + I[2] * w_B[2] * w_B[2]);
}

Vec3 angular_acceleration_B(const PrincipalMoments& I, const Vec3& w_B, const Vec3& N_B) {
  return {((I[1] - I[2]) * w_B[1] * w_B[2] + N_B[0]) / I[0],
          ((I[2] - I[0]) * w_B[2] * w_B[0] + N_B[1]) / I[1],
          ((I[0] - I[1]) * w_B[0] * w_B[1] + N_B[2]) / I[2]};
}

}  // namespace polhode
