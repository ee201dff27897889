// SPDX-License-Identifier: MIT
#include "physics/body/euler_angles.h"

#include <cmath>
#include <numbers>

namespace polhode {

Quat attitude_of(const EulerAngles& angles) {
  const auto turn = [](double angle_rad, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(angle_rad, axis));
  };
  return turn(angles.phi_rad, Vec3::UnitZ()) * turn(angles.theta_rad, Vec3::UnitX()) *
         turn(angles.psi_rad, Vec3::UnitZ());
}

// w + iz = cos(θ/2) e^{i(φ + ψ)/2}, x + iy = sin(θ/2) e^{i(φ − ψ)/2}.
EulerAngles euler_angles_of(const Quat& q_SB) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double upright = std::hypot(q_SB.w(), q_SB.z()), tilted = std::hypot(q_SB.x(), q_SB.y());
  const double half_sum = std::atan2(q_SB.z(), q_SB.w()), half_difference = std::atan2(q_SB.y(), q_SB.x());
  EulerAngles angles;
  angles.theta_rad = 2 * std::atan2(tilted, upright);
  if (tilted == 0) {
    angles.phi_rad = std::remainder(2 * half_sum, kTurn);
  } else if (upright == 0) {
    angles.phi_rad = std::remainder(2 * half_difference, kTurn);
  } else {
    angles.phi_rad = std::remainder(half_sum + half_difference, kTurn);
    angles.psi_rad = std::remainder(half_sum - half_difference, kTurn);
  }
  return angles;
}

Vec3 w_B_of(const EulerAngles& angles, double phi_rate, double theta_rate, double w3) {
  const double sin_psi = std::sin(angles.psi_rad), cos_psi = std::cos(angles.psi_rad);
  const double across = phi_rate * std::sin(angles.theta_rad);
  return {across * sin_psi + theta_rate * cos_psi, across * cos_psi - theta_rate * sin_psi, w3};
}

}  // namespace polhode
