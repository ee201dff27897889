// SPDX-License-Identifier: MIT
#include "physics/symmetric_motion.h"

#include "physics/uniform_motion.h"

#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

int checked_symmetry_axis(const PrincipalMoments& I) {
  const auto c = symmetry_axis(I);
  if (!c) throw std::domain_error("symmetric motion needs two exactly equal moments");
  return *c;
}

}  // namespace

std::optional<int> symmetry_axis(const PrincipalMoments& I) {
  for (const int c : {2, 1, 0}) {
    if (I[(c + 1) % 3] == I[(c + 2) % 3]) return c;
  }
  return std::nullopt;
}

SymmetricMotion::SymmetricMotion(const PrincipalMoments& I, const RigidBodyState& start)
    : start_(checked(start)), c_(checked_symmetry_axis(I)), w_L_B_(start.w_B) {
  const double I_a = I[(c_ + 1) % 3];
  const double w_c = start.w_B[c_];
  w_L_B_[c_] = w_c * (I[c_] / I_a);
  nu_ = w_c * ((I[c_] - I_a) / I_a);
}

Vec3 SymmetricMotion::w_B_at(double t_s) const {
  const double angle = nu_ * t_s;
  if (!std::isfinite(angle)) return start_.w_B;
  const int a = (c_ + 1) % 3;
  const int b = (c_ + 2) % 3;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  Vec3 w_B = start_.w_B;
  w_B[a] = start_.w_B[a] * cosine - start_.w_B[b] * sine;
  w_B[b] = start_.w_B[a] * sine + start_.w_B[b] * cosine;
  return w_B;
}

RigidBodyState SymmetricMotion::at(double t_s) const {
  const Vec3 spin_B = -nu_ * Vec3::Unit(c_);
  return {start_.q_SB * rotation_by(w_L_B_, t_s) * rotation_by(spin_B, t_s), w_B_at(t_s)};
}

}  // namespace polhode
