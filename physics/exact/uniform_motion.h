// SPDX-License-Identifier: MIT
// Steady rotation in closed form: ω constant in the body and in space, q_SB(t) = q_SB(0) ⊗ exp(½ ω_B t).
// Landau & Lifshitz, Mechanics, §37; every spin about a principal axis, and every spin of a sphere.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/motion.h"

namespace polhode {

/// True if ω_B is constant in the absence of torque: I_i = I_j or ω_i = 0 or ω_j = 0 for each pair of axes,
/// that is all products (I_i − I_j) ω_i ω_j of Euler's equations vanish. Tested structurally, not by a
/// tolerance and not by the rounded products, which may underflow.
bool is_steady(const PrincipalMoments& I, const Vec3& w_B);

/// exp(½ ω_B t) = (cos ½|ω|t, sin ½|ω|t · ω/|ω|): rotation by |ω|t about ω. Angles beyond the range of double
/// give the identity. Error at most ε(4 + 4|ω t|), ε = 2⁻⁵³, nearly all of it from the rounding of the angle.
Quat rotation_by(const Vec3& w_B, double t_s);

/// Invariant: is_steady(I, w_B).
class UniformMotion final : public Motion {
 public:
  /// @throws std::domain_error if the state is not finite or the rotation is not steady.
  UniformMotion(const PrincipalMoments& I, const RigidBodyState& start);

  /// ω exact; attitude within ε(4 + 4|ω t|), ε = 2⁻⁵³. One sincos.
  RigidBodyState at(double t_s) const override;
  Vec3 w_B_at(double) const override { return start_.w_B; }
  std::string_view method() const override { return "uniform"; }

 private:
  RigidBodyState start_;
};

}  // namespace polhode
