// SPDX-License-Identifier: MIT
// Inside asymmetric_motion: from the constants of the formula to the state at one time, and from the start to
// the constants. The formulas stand in asymmetric_motion.h.
#pragma once

#include "physics/exact/asymmetric_motion.h"
#include "physics/exact/elementary.h"

#include <cmath>

// Compiled twice, for processors with and without four-lane vectors; which is chosen at run time. The same
// bits. Not under the thread sanitizer: the choice is made before it is there, and it would be called.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define POLHODE_VECTOR_CLONES [[gnu::target_clones("arch=x86-64-v3", "default")]]
#else
#define POLHODE_VECTOR_CLONES
#endif

namespace polhode {

// One time. Everything is straight-line code on doubles, so that a loop over it is vectorised, and gives the
// same bits as one call.
struct AsymmetricMotion::Evaluation {
  double w_a, w_b, w_c;  // in the motion's own units and frame
  double q_w, q_a, q_b, q_c;

  // What the theta functions give: sn, cn, dn up to the factors in Formula::w, and β as a direction in the
  // plane.
  struct Theta {
    double sn, cn, dn;
    double cos_beta, sin_beta;  // times a common positive factor
    double half_periods;        // those counted off before X, in_complementary_nome
  };

  [[gnu::always_inline]] static Theta theta_in_nome(const Formula& f, double v) {
    const SinCos x = sincos_quarter_turns(2 * v);
    const double sin2 = x.sin * x.sin, cos2 = x.cos * x.cos;
    const double theta1 = x.sin * polynomial(f.E, sin2);
    const double theta2 = x.cos * polynomial(f.E, cos2);
    const double theta3 = polynomial(f.F, cos2);
    const double inverse_theta4 = 1 / polynomial(f.F, sin2);
    const double im = x.sin * polynomial(f.im, sin2);
    const double re = x.cos * polynomial(f.re, cos2);
    const double cn = f.cn_over_root_p_sn * theta2;
    return {theta1 * inverse_theta4, theta2 * inverse_theta4, theta3 * inverse_theta4,
            re * cn + im * theta1,   im * cn - re * theta1,   0};
  }

  // Series in q' = e^{−πK/K'} with E = e^{−2|X|} and W = q'/E: every power of E and W stays within [0, 1].
  [[gnu::always_inline]] static Theta theta_in_complementary_nome(const Formula& f, double v) {
    const double shifted = v + kRounder;
    const double half_periods = shifted - kRounder;
    const double r = v - half_periods;
    const double X = f.X_per_v * std::abs(r);  // beyond kLastDecay where k' < 10⁻³⁰⁷
    const Decay d = decay(X < kLastDecay ? X : kLastDecay);
    const double root_W = f.root_nome * d.inverse;
    const double E = d.exp * d.exp, W = root_W * root_W;
    const double one_minus_E = std::copysign(d.one_minus_exp, r) * (1 + d.exp);

    const double U = f.nome * E, V = f.nome * W, U2 = U * U, V2 = V * V;
    // 2 e^{−|X|} q'^{n(n+1)} cosh((2n+1)X), and the same with sinh/(1 − E)
    const double c0 = 1 + E, c1 = V + U2, c2 = f.nome_squared * V2;
    const double s1 = V * (c0 + E * E), s2 = c2 * c0;
    const double theta1 = one_minus_E * (1 - s1 + s2);
    const double inverse_theta2 = 1 / (c0 + c1 + c2);
    // 2 q'^{n²} cosh(2nX)
    const double e0 = 1 + (V2 + f.nome_squared * U2), e1 = W + U;
    const double theta4 = d.exp * (e0 - e1);
    const double theta3 = d.exp * (e0 + e1);

    const double re = c0 * f.sin_Y[0] + c1 * f.sin_Y[1] + c2 * f.sin_Y[2];
    const double im = one_minus_E * (f.cos_Y[0] + s1 * f.cos_Y[1] + s2 * f.cos_Y[2]);
    const double cn = f.cn_over_root_p_sn * theta4;
    const bool odd = (std::bit_cast<std::uint64_t>(shifted) & 1) != 0;
    const double flipped = odd ? -inverse_theta2 : inverse_theta2;
    return {theta1 * flipped,      theta4 * flipped,      theta3 * inverse_theta2,
            re * cn + im * theta1, im * cn - re * theta1, half_periods};
  }

  // The limit q' → 0: sn = tanh u, cn = dn = sech u.
  [[gnu::always_inline]] static Theta theta_on_separatrix(const Formula& f, double u) {
    const double X = std::abs(u);
    const Decay d = decay(X < kLastDecay ? X : kLastDecay);
    const double E = d.exp * d.exp;
    const double sinh_theta1 = std::copysign(1.0, u) * d.one_minus_exp * (1 + d.exp);
    const double inverse_theta2 = 1 / (1 + E);
    const double re = (1 + E) * f.sin_Y[0];
    const double im = sinh_theta1 * f.cos_Y[0];
    const double cn = f.cn_over_root_p_sn * d.exp;
    return {sinh_theta1 * inverse_theta2, d.exp * inverse_theta2,     d.exp * inverse_theta2,
            re * cn + im * sinh_theta1,   im * cn - re * sinh_theta1, 0};
  }

  template <Series series>
  [[gnu::always_inline]] static Theta theta(const Formula& f, double v) {
    if constexpr (series == Series::in_nome) return theta_in_nome(f, v);
    if constexpr (series == Series::in_complementary_nome) return theta_in_complementary_nome(f, v);
    return theta_on_separatrix(f, v);
  }

  // Of vectors of the processor too, which std::clamp is not.
  [[gnu::always_inline]] static double clamped(double x, double bound) {
    const double not_above = x > bound ? bound : x;  // NaN stays NaN
    return not_above < -bound ? -bound : not_above;
  }

  [[gnu::always_inline]] static double scaled_time(const Formula& f, double t_s) {
    return clamped(t_s * f.time_scale, f.last_time);
  }

  [[gnu::always_inline]] void set_w(const Formula& f, const Theta& theta) {
    w_a = f.w[0] * theta.cn;
    w_b = f.w[1] * theta.sn;
    w_c = f.w[2] * theta.dn;
  }

  // q_c(Ψ) q_P, not normalised, in the axes a, b, c. The square root of the direction β: half its angle.
  [[gnu::always_inline]] void set_shape(const Formula& f, const Theta& theta, double t) {
    const double norm = std::sqrt(theta.cos_beta * theta.cos_beta + theta.sin_beta * theta.sin_beta);
    const double larger = norm + std::abs(theta.cos_beta), smaller = std::abs(theta.sin_beta);
    const double sign = f.sigma * std::copysign(1.0, theta.sin_beta);
    const double half_cos = theta.cos_beta >= 0 ? larger : smaller;
    const double half_sin = sign * (theta.cos_beta >= 0 ? smaller : larger);

    // ω may be known when Ψ is lost: a near-sphere turns 10¹⁵ times in a period. Any Ψ keeps L in space.
    const double psi = f.psi_rate * t - f.psi_per_half_period * theta.half_periods;
    const SinCos linear = sincos_quarter_turns(clamped(psi, kLargestQuarterTurns));
    const double cosine = linear.cos * half_cos - linear.sin * half_sin;
    const double sine = linear.sin * half_cos + linear.cos * half_sin;
    const double m_a = f.m_over_w[0] * w_a, m_b = f.m_over_w[1] * w_b, m_c = f.m_over_w[2] * w_c;
    q_w = cosine * (1 + m_c);
    q_a = cosine * m_b + sine * m_a;
    q_b = sine * m_b - cosine * m_a;
    q_c = sine * (1 + m_c);
  }

  // From the start's attitude; unit.
  [[gnu::always_inline]] void turn_from_start(const Formula& f) {
    const auto [w, a, b, c] = f.q0;
    const double r_w = w * q_w - a * q_a - b * q_b - c * q_c;
    const double r_a = w * q_a + a * q_w + b * q_c - c * q_b;
    const double r_b = w * q_b + b * q_w + c * q_a - a * q_c;
    const double r_c = w * q_c + c * q_w + a * q_b - b * q_a;
    const double inverse_norm = 1 / std::sqrt(r_w * r_w + r_a * r_a + r_b * r_b + r_c * r_c);
    q_w = r_w * inverse_norm;
    q_a = r_a * inverse_norm;
    q_b = r_b * inverse_norm;
    q_c = r_c * inverse_norm;
  }

  // For the setup, where time does not matter.
  static Theta theta(const Formula& f, double v) {
    switch (f.series) {
      case Series::in_nome:
        return theta_in_nome(f, v);
      case Series::in_complementary_nome:
        return theta_in_complementary_nome(f, v);
      case Series::separatrix:
        break;
    }
    return theta_on_separatrix(f, v);
  }

  // The shape of the attitude at t = 0, not normalised.
  static Evaluation of_shape(const Formula& f) {
    const Theta at_start = theta(f, f.v0);
    Evaluation e{};
    e.set_w(f, at_start);
    e.set_shape(f, at_start, 0.0);
    return e;
  }

  template <Series series>
  [[gnu::always_inline]] static Evaluation of_w(const Formula& f, double t_s) {
    Evaluation e{};
    e.set_w(f, theta<series>(f, f.v0 + f.v_rate * scaled_time(f, t_s)));
    return e;
  }

  template <Series series>
  [[gnu::always_inline]] static Evaluation of_state(const Formula& f, double t_s) {
    const double t = scaled_time(f, t_s);
    const Theta at_t = theta<series>(f, f.v0 + f.v_rate * t);
    Evaluation e{};
    e.set_w(f, at_t);
    e.set_shape(f, at_t, t);
    e.turn_from_start(f);
    return e;
  }

  Vec3 w_B(const Formula& f) const {
    Vec3 w;
    w[f.axes[0]] = f.w_scales[0] * w_a;
    w[f.axes[1]] = f.w_scales[1] * w_b;
    w[f.axes[2]] = f.w_scales[2] * w_c;
    return w;
  }

  RigidBodyState state(const Formula& f) const {
    RigidBodyState result{Quat::Identity(), w_B(f)};
    auto& q = result.q_SB.coeffs();
    q[f.axes[0]] = f.signs[0] * q_a;
    q[f.axes[1]] = f.signs[1] * q_b;
    q[f.axes[2]] = f.signs[2] * q_c;
    q[3] = q_w;
    return result;
  }

  template <Series series>
  POLHODE_VECTOR_CLONES static void of_states(const Formula& f, const RigidBodyState& start,
                                              std::span<const double> t_s, std::span<RigidBodyState> states) {
    constexpr std::size_t kBlock = 64;
    std::size_t i = 0;
    for (; i + kBlock <= t_s.size(); i += kBlock) {
      std::array<double, kBlock> w_a, w_b, w_c, q_w, q_a, q_b, q_c;
      for (std::size_t k = 0; k < kBlock; ++k) {
        const Evaluation e = of_state<series>(f, t_s[i + k]);
        w_a[k] = e.w_a;
        w_b[k] = e.w_b;
        w_c[k] = e.w_c;
        q_w[k] = e.q_w;
        q_a[k] = e.q_a;
        q_b[k] = e.q_b;
        q_c[k] = e.q_c;
      }
      const auto [axis_a, axis_b, axis_c] = f.axes;
      for (std::size_t k = 0; k < kBlock; ++k) {
        double* w = states[i + k].w_B.data();
        double* q = states[i + k].q_SB.coeffs().data();
        w[axis_a] = f.w_scales[0] * w_a[k];
        w[axis_b] = f.w_scales[1] * w_b[k];
        w[axis_c] = f.w_scales[2] * w_c[k];
        q[axis_a] = f.signs[0] * q_a[k];
        q[axis_b] = f.signs[1] * q_b[k];
        q[axis_c] = f.signs[2] * q_c[k];
        q[3] = q_w[k];
      }
      for (std::size_t k = 0; k < kBlock; ++k)
        if (t_s[i + k] == 0) states[i + k] = start;
    }
    for (; i < t_s.size(); ++i) states[i] = t_s[i] == 0 ? start : of_state<series>(f, t_s[i]).state(f);
  }
};

// From the start to the constants of the formula. Rates are in units of w_unit = 2^e_w, about |ω|; in
// Extended, moments and ω need no scaling, and a component 10³⁰⁸ times smaller than the largest is still
// there.
struct AsymmetricMotion::Setup {
  Vec3Extended I, w_B;
  PolhodeConstants p;
  Extended G, K, Kp;
  Extended d_ca, d_cb, d_ba;
  Extended inverse_root_p, alpha;

  Setup(const PrincipalMoments& I_given, const Vec3& w_given_B, Extended w_unit);
  Formula formula(const Quat& q_SB) const;

 private:
  void set_rates(Formula& f) const;
  void set_series(Formula& f) const;
  void set_series_in_nome(Formula& f, double nome) const;
  void set_series_in_complementary_nome(Formula& f) const;
  void set_amplitudes(Formula& f, double flip) const;
};

}  // namespace polhode
