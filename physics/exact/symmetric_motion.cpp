// SPDX-License-Identifier: MIT
#include "physics/exact/symmetric_motion.h"

#include "physics/exact/polhode_constants.h"
#include "physics/exact/uniform_motion.h"

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

// L_B0/I_a in Extended: I_c/I_a of a needle underflows where its product with a large ω_c counts.
SymmetricMotion::SymmetricMotion(const PrincipalMoments& I, const RigidBodyState& start)
    : start_(checked(start)), c_(checked_symmetry_axis(I)) {
  const double I_a = I[(c_ + 1) % 3];
  const double w_c = start.w_B[c_];
  Vec3Extended w_L_B = start.w_B.cast<Extended>();
  w_L_B[c_] *= Extended{I[c_]} / I_a;
  const Extended largest = w_L_B.cwiseAbs().maxCoeff();
  e_L_ = largest > 0 ? ilogb(largest) : 0;
  w_L_B_ = w_L_B.unaryExpr([this](Extended x) { return scalbn(x, -e_L_); }).cast<double>();
  nu_ = w_c * ((I[c_] - I_a) / I_a);
}

// 0 once νt is beyond the range of double: the phase is lost long before, L in space must not be.
double SymmetricMotion::angle(double t_s) const {
  const double angle = nu_ * t_s;
  return std::isfinite(angle) ? angle : 0.0;
}

Vec3 SymmetricMotion::w_B_at(double t_s) const {
  const int a = (c_ + 1) % 3;
  const int b = (c_ + 2) % 3;
  const double cosine = std::cos(angle(t_s));
  const double sine = std::sin(angle(t_s));
  Vec3 w_B = start_.w_B;
  w_B[a] = start_.w_B[a] * cosine - start_.w_B[b] * sine;
  w_B[b] = start_.w_B[a] * sine + start_.w_B[b] * cosine;
  return w_B;
}

RigidBodyState SymmetricMotion::at(double t_s) const {
  const Quat about_L = rotation_by(w_L_B_, std::scalbn(t_s, e_L_));
  const Quat spin = rotation_by(-Vec3::Unit(c_), angle(t_s));
  return {start_.q_SB * about_L * spin, w_B_at(t_s)};
}

}  // namespace polhode
