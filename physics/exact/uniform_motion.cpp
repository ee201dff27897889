// SPDX-License-Identifier: MIT
#include "physics/exact/uniform_motion.h"

#include <cmath>
#include <stdexcept>

namespace polhode {

bool is_steady(const PrincipalMoments& I, const Vec3& w_B) {
  const auto pair_vanishes = [&](int i, int j) { return I[i] == I[j] || w_B[i] == 0 || w_B[j] == 0; };
  return pair_vanishes(0, 1) && pair_vanishes(1, 2) && pair_vanishes(2, 0);
}

Quat rotation_by(const Vec3& w_B, double t_s) {
  const double largest = w_B.cwiseAbs().maxCoeff();
  if (largest == 0) return Quat::Identity();

  const int e = std::ilogb(largest);  // exact scaling: neither |ω|² nor a subnormal ω loses digits
  const Vec3 w = w_B.unaryExpr([e](double x) { return std::scalbn(x, -e); });
  const double norm = w.norm();
  const double half_angle = 0.5 * norm * std::scalbn(t_s, e);
  if (!std::isfinite(half_angle)) return Quat::Identity();

  const Vec3 v = (std::sin(half_angle) / norm) * w;
  return {std::cos(half_angle), v[0], v[1], v[2]};
}

UniformMotion::UniformMotion(const PrincipalMoments& I, const RigidBodyState& start)
    : start_(checked(start)) {
  if (!is_steady(I, start.w_B)) {
    throw std::domain_error(
        "uniform motion needs steady rotation: ω along a principal axis, or equal moments");
  }
}

RigidBodyState UniformMotion::at(double t_s) const {
  return {start_.q_SB * rotation_by(start_.w_B, t_s), start_.w_B};
}

}  // namespace polhode
