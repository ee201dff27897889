// SPDX-License-Identifier: MIT
// Torque-free symmetric top in closed form: two moments exactly equal, any axis the symmetry axis.
// With c the symmetry axis and (a, b, c) right-handed (Landau & Lifshitz, Mechanics, §33 and §36;
// docs/numerics.md §2.4):
//
//     ω_a + iω_b = (ω_a0 + iω_b0) e^{iνt},   ω_c constant,   ν = ω_c (I_c − I_a)/I_a,
//     q_SB(t) = q_SB(0) ⊗ exp(½ (L_B0/I_a) t) ⊗ exp(−½ ν e_c t):
//
// the body turns about the fixed L with |L|/I_a, and about its own axis with −ν.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/motion.h"

#include <optional>

namespace polhode {

/// The axis c (0, 1, 2) whose moment differs from the two others, which are equal to the last bit; 2 for a
/// sphere; nothing for an asymmetric body. No tolerance: nearly equal moments belong to the asymmetric
/// motion.
std::optional<int> symmetry_axis(const PrincipalMoments& I);

/// Invariant: two moments are equal.
class SymmetricMotion final : public Motion {
 public:
  /// @throws std::domain_error if the state is not finite or no two moments are equal.
  SymmetricMotion(const PrincipalMoments& I, const RigidBodyState& start);

  /// |Δω|/|ω| and |Δq| ≤ 4ε(1 + cond), cond ≈ the angles turned, νt and |L|t/I_a. Three sincos.
  RigidBodyState at(double t_s) const override;
  Vec3 w_B_at(double t_s) const override;
  std::string_view method() const override { return "symmetric"; }

 private:
  RigidBodyState start_;
  int c_;       // symmetry axis
  Vec3 w_L_B_;  // L_B0/I_a, rad/s, in units of 2^e_L: it may exceed the largest double
  int e_L_;
  double nu_;  // rad/s: rate at which ω circles the symmetry axis in the body, signed about +c

  double angle(double t_s) const;  // ν t
};

}  // namespace polhode
