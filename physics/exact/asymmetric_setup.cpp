// SPDX-License-Identifier: MIT
#include "physics/exact/asymmetric_evaluation.h"
#include "physics/exact/elliptic.h"

#include <algorithm>
#include <numeric>

namespace polhode {
namespace {

// u_0 = offset + (0 or 2K), |offset| ≤ K; half a period flips the signs of sn and cn.
struct InitialPhase {
  Extended offset;
  double flip;
};

// From s = sn u_0 and c = cn u_0: u_0 = s R_F(c², dn² u_0, 1), DLMF 22.15.12 and 19.25.5. The sign of c tells
// the half period; an arctangent would round to π/2 where |c| < ε.
InitialPhase initial_phase(Extended s, Extended c, Extended kp) {
  const double flip = c < 0 ? -1.0 : 1.0;
  const Extended norm = flip * sqrt(s * s + c * c);
  s /= norm;
  c /= norm;
  if (kp == 0) return {asinh(s / c), flip};
  return {s * carlson_RF_of_squares(c, sqrt(c * c + kp * kp * s * s), 1), flip};
}

PolhodeConstants in_units(PolhodeConstants p, Extended w_unit) {
  for (Extended* rate : {&p.A, &p.B, &p.C, &p.lambda}) *rate /= w_unit;
  return p;
}

}  // namespace

AsymmetricMotion::Setup::Setup(const PrincipalMoments& I_given, const Vec3& w_given_B, Extended w_unit)
    : I(I_given.vector().cast<Extended>()),
      w_B(w_given_B.cast<Extended>() / w_unit),
      p(in_units(*polhode_constants(I_given, w_given_B), w_unit)),
      G(I.cwiseProduct(w_B).norm()),
      K(p.separatrix() ? 0 : complete_elliptic_K(p.kp)),
      Kp(complete_elliptic_K(p.k)),
      d_ca(abs(I[p.c] - I[p.a])),
      d_cb(abs(I[p.c] - I[p.b])),
      d_ba(abs(I[p.b] - I[p.a])),
      // √p to 10¹⁵⁰: the square of a direction must not underflow. Less than rounding but within 10⁻¹⁵⁰ of sn
      // = 0.
      inverse_root_p(std::max<Extended>(0x1p-500, sqrt(I[p.a] / I[p.b]) * sqrt(d_cb / d_ca))) {
  const Extended part = d_ba * I[p.c] / (d_ca * I[p.b]);  // (p − 1)/p
  const Extended k_part = p.k * inverse_root_p;
  alpha = carlson_RF_of_squares(sqrt(part), sqrt(part + k_part * k_part), 1) * inverse_root_p;
}

AsymmetricMotion::Formula AsymmetricMotion::Setup::formula(const Quat& q_SB) const {
  Formula f;
  f.axes = {p.a, p.b, p.c};
  f.signs = {1.0, p.sign_b, p.sign_c};
  f.sigma = p.sigma;
  for (std::size_t i = 0; i < 3; ++i) f.m_over_w[i] = double(I[f.axes[i]] / G);
  set_series(f);
  set_rates(f);
  const InitialPhase u0 = initial_phase(p.sigma * p.sign_b * w_B[p.b] / p.B, w_B[p.a] / p.A, p.kp);
  f.v0 = double(p.separatrix() ? u0.offset : u0.offset / (2 * K));
  set_amplitudes(f, u0.flip);

  const Evaluation start = Evaluation::of_shape(f);
  const Quat shape = Quat(start.q_w, start.q_a, start.q_b, start.q_c).normalized();
  const auto& q = q_SB.coeffs();
  const Quat q_start(q.w(), f.signs[0] * q[p.a], f.signs[1] * q[p.b], f.signs[2] * q[p.c]);
  const Quat q0 = q_start * shape.conjugate();
  f.q0 = {q0.w(), q0.x(), q0.y(), q0.z()};
  return f;
}

void AsymmetricMotion::Setup::set_rates(Formula& f) const {
  if (p.separatrix()) {
    f.v_rate = double(p.lambda);
    f.psi_rate = double(G / I[p.b] / kPi);
  } else {
    // λ C_ψ: 1/√(I_a I_b) taken out of cel, lest 1/I_a overflow
    const Extended root_ratio = sqrt(I[p.b] / I[p.a]), root_d = sqrt(d_ca / d_cb);
    const Extended lambda_C =
        G / sqrt(I[p.a] * I[p.b]) * bulirsch_cel(p.kp, root_ratio * root_d, root_ratio, root_d);
    const bool counted = f.series == Series::in_complementary_nome;
    const Extended jump = counted ? alpha / Kp : 0;
    f.v_rate = double(p.lambda / (2 * K));
    f.psi_rate = double((lambda_C / kPi - p.sigma * p.lambda * 0.5L * (1 - jump)) / K);
    f.psi_per_half_period = double(p.sigma * jump);
  }
  f.last_time = 0x1p49 / f.v_rate;
}

// Five terms serve q ≤ 0.21 (q²⁵ < ε/4) and three serve q' < 0.0018 beyond it (q'⁶ < ε/3).
void AsymmetricMotion::Setup::set_series(Formula& f) const {
  constexpr double kLargestNome = 0.21;
  const double nome = p.separatrix() ? 1.0 : std::exp(double(-kPi * Kp / K));
  if (nome <= kLargestNome)
    set_series_in_nome(f, nome);
  else
    set_series_in_complementary_nome(f);
}

void AsymmetricMotion::Setup::set_series_in_nome(Formula& f, double nome) const {
  f.series = Series::in_nome;
  const auto y = double(kPi * alpha / (2 * K));
  const double g = std::exp(double(kPi * (alpha - Kp) / K));  // q e^{2y} ≤ 1
  const double e = std::exp(-2 * y);
  const double one_minus_e = -std::expm1(-2 * y);
  ThetaSeries theta1{}, theta4{}, im{}, re{};
  double sign = 1, q_n = 1, q_nn = 1, g_n = 1;  // (−1)ⁿ, qⁿ, q^{n²}, gⁿ
  double e_odd = e, e_sum = 1;                  // e^{2n+1}, 1 + e + … + e^{2n}
  for (std::size_t n = 0; n < theta1.size(); ++n) {
    theta1[n] = sign * q_nn * q_n;
    theta4[n] = (n == 0 ? 1 : 2) * sign * q_nn;
    im[n] = sign * q_nn * g_n * (1 + e_odd) / (1 + e);
    re[n] = q_nn * g_n * e_sum * one_minus_e / (1 + e);
    sign = -sign;
    q_nn *= q_n * q_n * nome;
    q_n *= nome;
    g_n *= g;
    e_sum += e_odd * (1 + e);
    e_odd *= e * e;
  }
  f.E = odd_harmonics(theta1);
  f.F = even_harmonics(theta4);
  f.im = odd_harmonics(im);
  f.re = odd_harmonics(re);
}

void AsymmetricMotion::Setup::set_series_in_complementary_nome(Formula& f) const {
  f.series = p.separatrix() ? Series::separatrix : Series::in_complementary_nome;
  if (!p.separatrix()) {
    f.X_per_v = double(kPi * K / Kp);
    f.nome = std::exp(-f.X_per_v);
    f.nome_squared = f.nome * f.nome;
    f.root_nome = std::exp(-0.5 * f.X_per_v);
  }
  const auto Y = double(kPi * alpha / (2 * Kp));
  f.sin_Y = {std::sin(Y), -std::sin(3 * Y), std::sin(5 * Y)};
  f.cos_Y = {std::cos(Y), -std::cos(3 * Y), std::cos(5 * Y)};
}

namespace {

// sn K, cn 0, dn 0 as the series of the formula give them, but without their rounding, which would stay in ω
// at all times.
struct ThetaConstants {
  Extended sn_K, cn_0, dn_0;
};

ThetaConstants constants_in_nome(const ThetaSeries& E, const ThetaSeries& F) {
  const auto at_1 = [](const ThetaSeries& c) { return std::accumulate(c.rbegin(), c.rend(), Extended{0}); };
  return {at_1(E) / at_1(F), at_1(E) / F[0], at_1(F) / F[0]};
}

ThetaConstants constants_in_complementary_nome(Extended q) {
  const Extended q4 = q * q * q * q;
  const Extended theta3 = 1 + 2 * q + 2 * q4, theta2 = 2 + 2 * q * q;
  return {(1 - q) * (1 - q * (1 + q + q * q) + q4 * (1 + q)) / theta3, (1 - 2 * q + 2 * q4) / theta2,
          theta3 / theta2};
}

}  // namespace

// The theta functions' own factors follow from sn K = cn 0 = dn 0 = 1.
void AsymmetricMotion::Setup::set_amplitudes(Formula& f, double flip) const {
  const ThetaConstants at =
      f.series == Series::in_nome ? constants_in_nome(f.E, f.F) : constants_in_complementary_nome(f.nome);
  f.w = {flip * double(p.A / at.cn_0), flip * p.sigma * double(p.B / at.sn_K), double(p.C / at.dn_0)};
  f.cn_over_root_p_sn = double(inverse_root_p * at.sn_K / at.cn_0);
}

}  // namespace polhode
