// SPDX-License-Identifier: MIT
// The constants of torque-free motion in Jacobi's elliptic functions: what the polhode curve, its period and
// the exact asymmetric motion share. Whittaker, Analytical Dynamics, 4th ed., §69; Landau & Lifshitz,
// Mechanics, §37; robust form: van Zon & Schofield, J. Comput. Phys. 225 (2007) 145-164, with only positive
// sums and differences of the given moments, which are exact when within a factor 2; never L² − 2TI of
// computed T and L (docs/numerics.md §1, 2.1, 2.2).
//
//     ω_a = A cn u,   ω_b = σ B sn u,   ω_c = C dn u,   u = u_0 + λt,   modulus k, complement k',
//
// in the axes (a, ±b, ±c), right-handed with ω_c ≥ 0. c is the dn axis, whose component never changes sign:
// the axis of the largest moment (σ = +1) if D = L² − 2TI_mid > 0, of the smallest (σ = −1) if D < 0.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/exact/elliptic.h"

#include <array>
#include <optional>

namespace polhode {

using Vec3Extended = Eigen::Matrix<Extended, 3, 1>;

struct PolhodeConstants {
  int a = 0, b = 1, c = 2;  ///< axes, b that of the intermediate moment
  double sigma = 1;         ///< sign(D); +1 on the separatrix
  double sign_b = 1,
         sign_c = 1;  ///< ω → (ω_a, sign_b ω_b, sign_c ω_c) makes the frame right-handed and ω_c ≥ 0
  Extended A = 0, B = 0, C = 0;  ///< amplitudes, rad/s, > 0
  Extended k = 0, kp = 1;        ///< modulus and complementary modulus; kp = 0: separatrix
  Extended lambda = 0;           ///< rad/s
  bool separatrix() const { return kp == 0; }
};

/// Nothing if the rotation is steady (uniform_motion.h). The side, and the separatrix (D = 0), are decided in
/// double-double arithmetic (error of D about 2⁻¹⁰⁰ of its larger term), by no tolerance. The other constants
/// have relative errors of a few roundings of Extended in terms of the moments' differences. About 0.3 µs.
std::optional<PolhodeConstants> polhode_constants(const PrincipalMoments& I, const Vec3& w_B);

/// Axes sorted by moment, smallest first; equal moments keep their order.
std::array<int, 3> sorted_axes(const PrincipalMoments& I);

/// +1 if (a, b, c) is an even permutation of (0, 1, 2), else −1.
double parity(int a, int b);

}  // namespace polhode
