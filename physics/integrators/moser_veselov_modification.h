// SPDX-License-Identifier: MIT
// The modified inertia of preprocessed Moser-Veselov integrators,
//
//     1/Ĩ_i = s/I_i + e,
//
// s and e power series in h² whose coefficients are polynomials in T and |L|²:
// Hairer & Vilmart, J. Phys. A 39 (2006) 13225-13235, eq. (12) and the appendix (orders 4 to 10). Internal to
// physics/.
//
// With H = h²T and N = h²|L|²/2 the published coefficients are sums over negative powers of the moments; for
// a needle of I_1 ≪ I_3 the terms of degree p in H and N cancel to (I_1/I_3)^p of themselves. Here, in units
// of the largest moment: ρ = I_1 (the smallest), I_2 = 1 − γρ with γ = (I_3 − I_2)/I_1 in [0, 1], I_3 = 1,
// and N = H + ρM with
//
//     M = −½ h² [(I_3 − I_1) ω_1² + γ I_2 ω_2²].
//
// Over the denominator (I_1 I_2 I_3)^p = ρ^p I_2^p the numerator of M^a H^(p−a) is ρ^a, from the power of ρM,
// times a polynomial in ρ which starts at ρ^(p−a). The class computes with these polynomials, drops what must
// vanish, and divides by ρ^(p−a) exactly: no digit is lost for a needle, and a disc or a sphere is nothing
// special.
#pragma once

#include "physics/integrators/step_arithmetic.h"

#include <array>

namespace polhode {

class MoserVeselovModification {
 public:
  /// order 2, 6 or 10.
  MoserVeselovModification(const PrincipalMoments& I, int order);

  struct Factors {
    double s;
    Triple sigma;  ///< I_i/Ĩ_i = s + e I_i
  };
  /// For the step h at ω_B: the same, to rounding, all along a free motion. About 10 ns.
  Factors operator()(double h, const Triple& w_B) const;

 private:
  static constexpr int kMostTerms = 4;
  // Coefficients of M^a H^(p−a), a = 0..p, for p = 1..terms_.
  using Series = std::array<std::array<double, kMostTerms + 1>, kMostTerms>;

  int terms_;
  Triple relative_I_;  // I_i/I_3
  Triple H_, M_;       // H = h² Σ H_i ω_i², M likewise
  Series s_{}, e_{};
};

}  // namespace polhode
