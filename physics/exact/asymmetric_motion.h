// SPDX-License-Identifier: MIT
// Torque-free motion of an asymmetric body in closed form: ω by Jacobi's elliptic functions, attitude by
// theta functions, at any time, past or future, for the same price.
//
// In the axes (a, b, c) of polhode_constants.h, with m = I ω, G = |m|, T the energy:
//
//     ω_a = A cn u,  ω_b = σ B sn u,  ω_c = C dn u,   u = u_0 + λ t                  Whittaker §69; LL §37
//
// Attitude (after van Zon & Schofield, J. Comput. Phys. 225 (2007) 145-164, and Celledoni, Fassò, Säfström &
// Zanna, SIAM J. Sci. Comput. 30 (2008) 2084-2112; docs/numerics.md §2.3, 2.5). With q_P the shortest
// rotation that takes m/G to e_c, and q_c(Ψ) the rotation by Ψ about e_c,
//
//     q_SB(t) = q_SB(0) ⊗ [q_c(Ψ_0) q_P0]⁻¹ ⊗ q_c(Ψ) q_P,     q_P = (G + m_c, m_b, −m_a, 0)/|·|,
//     Ψ̇ = (2T + G ω_c)/(G + m_c),                              never singular, because m_c ≥ 0.
//
// Ψ̇ has simple poles in u, so Ψ is a linear function of time plus the argument of a theta function (Jacobi
// 1850; Whittaker & Watson §22.74): no integral of the third kind is left,
//
//     Ψ − Ψ_0 = Ω λ t + σ (β(u) − β(u_0)),   β = arg{i θ_1(x − iy; q)} − arg(cn u + i√p sn u),
//     x = πu/2K,  y = πα/2K,  p = I_b d_ca/(I_a d_cb),  α = R_F(p − 1, p − 1 + k², p),
//     Ω = (C_ψ − σπ/2)/K,  C_ψ = (G/λ) cel(k', p, 1/I_a, p/I_b).
//
// β is periodic and |β| < π/2: e^{iβ/2} is a principal square root, so no branch is counted, no arctangent
// taken, and q_SB(t) is continuous, sign included. Near the separatrix Jacobi's imaginary transformation
// gives series in q' = e^{−πK/K'} instead of q = e^{−πK'/K}: five terms reach ε for q ≤ 0.21 (k² < 0.97),
// three beyond. On the separatrix (k' = 0, D = 0 to the last bit of double-double) q' = 0 and the same series
// are sech and tanh: Deriglazov, arXiv 2401.11518. sn, cn, dn come from the same theta functions
// (DLMF 20.2, 22.2), as polynomials in sin²x and cos²x, or in e^{−2|X|}: a call is two sincos (or a sincos
// and an exponential), two roots, some products.
#pragma once

#include "physics/exact/polhode_constants.h"
#include "physics/exact/theta_series.h"
#include "physics/motion.h"

#include <array>

namespace polhode {

/// Invariant: the rotation is not steady and no two moments are equal.
class AsymmetricMotion final : public Motion {
 public:
  /// @throws std::domain_error if the state is not finite, the rotation steady or two moments
  /// equal (uniform_motion.h, symmetric_motion.h).
  AsymmetricMotion(const PrincipalMoments& I, const RigidBodyState& start);

  /// |Δω|/|ω| and |Δq| ≤ 4ε(1 + cond), cond the condition number with respect to the given ω and the
  /// differences of the given moments: about 50 |t|/P in general, 30/δ |t|/P at relative distance δ from the
  /// separatrix. T and |L| within 4·10⁻¹⁵, the direction of L in space within 10⁻¹⁴, at any t: nothing
  /// accumulates. Results are the same to the bit under scaling of I, or of ω and 1/t, by powers of two.
  /// at(0) is the start to the bit.
  /// Times so far away that the phase of ω is lost (10¹⁵ half periods), or that of the attitude (10¹⁵ quarter
  /// turns), give some state of the same T and L. A component of ω beyond the largest double is infinite.
  RigidBodyState at(double t_s) const override;

  /// Bitwise at(t_s).w_B, for less than half the price.
  Vec3 w_B_at(double t_s) const override;

  /// Bitwise a loop over at(t), several times at once where the machine can.
  void at(std::span<const double> t_s, std::span<RigidBodyState> states) const override;

  std::string_view method() const override { return "exact"; }

  /// How the theta functions are summed: in the nome q of k, in that of k' (k² > 0.97), or k = 1.
  enum class Series { in_nome, in_complementary_nome, separatrix };
  Series series() const { return f_.series; }

 private:
  // Rates in units of 2^e_w, exact. Arrays of three go along the axes a, b, c.
  struct Formula {
    Series series = Series::in_nome;
    std::array<int, 3> axes{};
    std::array<double, 3> signs{};     // (v_a, v_b, v_c) = signs · (components along the body's axes)
    double time_scale = 1;             // 2^e_w
    std::array<double, 3> w_scales{};  // signs · 2^e_w
    double last_time = 0;              // beyond it the phase of ω is lost, and time stands still
    std::array<double, 3> w{};         // factors of ±cn, ±sn, dn, with those of the theta functions
    std::array<double, 3> m_over_w{};  // m/G of ω
    double sigma = 1;
    double v0 = 0, v_rate = 0;       // v = u/2K, in half periods; u itself on the separatrix
    double psi_rate = 0;             // linear part of Ψ/2, in quarter turns
    double psi_per_half_period = 0;  // what it lacks at each half period (in_complementary_nome)
    double X_per_v = 1;              // X = πu/2K' = πK/K' · v
    double nome = 0, nome_squared = 0, root_nome = 0;  // q', q'², √q'
    double cn_over_root_p_sn = 0;                      // factor that turns θ_2/θ_1 into cn/(√p sn)
    ThetaSeries E{};                                   // θ_1/sin x = E(sin²x), θ_2/cos x = E(cos²x)
    ThetaSeries F{};                                   // θ_4 = F(sin²x), θ_3 = F(cos²x)
    ThetaSeries im{}, re{};                  // i θ_1(x − iy) = cos x re(cos²x) + i sin x im(sin²x)
    std::array<double, 3> sin_Y{}, cos_Y{};  // (−1)ⁿ sin, cos (2n + 1)Y, Y = πα/2K'
    std::array<double, 4> q0{1, 0, 0, 0};    // q_SB(0) ⊗ [q_c(Ψ_0) q_P0]⁻¹: w, a, b, c
  };
  struct Evaluation;
  struct Setup;

  RigidBodyState start_;
  Formula f_;
};

}  // namespace polhode
