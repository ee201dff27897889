// SPDX-License-Identifier: MIT
#include "physics/analysis/conditioning.h"

#include "physics/exact/extended.h"
#include "physics/exact/lagrange_top.h"
#include "physics/exact/polhode_constants.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/exact/uniform_motion.h"
#include "physics/geometry/poinsot.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

// ∂/∂ln of I_a, I_b, I_c, ω_a, ω_b, ω_c
using LogGradient = Eigen::Matrix<Extended, 6, 1>;
enum Input { I_a, I_b, I_c, w_a, w_b, w_c };

double middle_of(const Vec3& x) {
  return std::max(std::min(x[0], x[1]), std::min(std::max(x[0], x[1]), x[2]));
}

LogGradient of(Input x) { return LogGradient::Unit(x); }

LogGradient of_difference(const Vec3& I, Input larger, Input smaller) {
  const Extended x = I[larger], y = I[smaller];
  return (x * of(larger) - y * of(smaller)) / (x - y);
}

// d ln P, see the header. I and w along the axes a, b, c.
LogGradient of_log_period(const PolhodeConstants& p, const Vec3& I, const Vec3& w) {
  const LogGradient d_ca = of_difference(I, I_c, I_a), d_cb = of_difference(I, I_c, I_b),
                    d_ba = of_difference(I, I_b, I_a);
  const auto size = [&](int i, int j, int k) {  // I_i |I_j − I_k| ω_i²
    return Extended{I[i]} * abs(Extended{I[j]} - I[k]) * w[i] * w[i];
  };
  const Extended R2 = size(1, 1, 0) + size(2, 2, 0);
  const LogGradient log_R =
      (size(1, 1, 0) * (of(I_b) + d_ba + 2 * of(w_b)) + size(2, 2, 0) * (of(I_c) + d_ca + 2 * of(w_c))) /
      (2 * R2);
  const Extended D = p.kp * p.kp * R2 * abs((Extended{I[2]} - I[1]) / (Extended{I[2]} - I[0]));
  const LogGradient log_D =
      (size(2, 2, 1) * (of(I_c) + d_cb + 2 * of(w_c)) - size(0, 1, 0) * (of(I_a) + d_ba + 2 * of(w_a))) / D;
  const LogGradient log_kp = (log_D + d_ca - d_cb) / 2 - log_R;
  const LogGradient log_lambda = log_R + (d_cb - of(I_a) - of(I_b) - of(I_c)) / 2;
  const Extended B_over_K = bulirsch_cel(p.kp, 1, 1, 0) / complete_elliptic_K(p.kp);
  return -B_over_K * log_kp - log_lambda;
}

std::optional<Extended> sum_of_log_derivatives(const PrincipalMoments& I, const Vec3& w_B) {
  if (w_B.isZero(0.0)) return std::nullopt;
  if (is_steady(I, w_B)) return Extended{1};
  if (const auto c = symmetry_axis(I)) {  // P = 2π/|ν|
    const Extended I_c = I[*c], I_a = I[(*c + 1) % 3];
    return 1 + 2 * abs(I_c / (I_c - I_a));
  }
  const PolhodeConstants p = *polhode_constants(I, w_B);
  if (p.separatrix()) return std::nullopt;
  const LogGradient gradient = of_log_period(p, {I[p.a], I[p.b], I[p.c]}, {w_B[p.a], w_B[p.b], w_B[p.c]});
  return gradient.cwiseAbs().sum();
}

}  // namespace

double Conditioning::horizon_periods(double phase_rad) const {
  return phase_rad / (0x1p-53 * phase_per_period);
}

std::optional<Conditioning> conditioning(const PrincipalMoments& I, const Vec3& w_B) {
  const auto sum = sum_of_log_derivatives(I, w_B);
  if (!sum) return std::nullopt;
  return Conditioning{static_cast<double>(2 * kPi * *sum)};
}

double closed_form_error(const PrincipalMoments& I, const Vec3& w_B, double t_s) {
  const auto number = conditioning(I, w_B);
  const auto period_s = polhode_period(I, w_B);
  const double periods = period_s ? std::abs(t_s) / *period_s : 0;
  const double phase = number ? number->phase_per_period * periods : 0;
  const Vec3 relative = I.vector() / middle_of(I.vector());  // 2 at most
  const double rate = w_B.stableNorm() + relative.cwiseProduct(w_B).stableNorm();
  return 0x1p-53 * (4 + 5 * rate * std::abs(t_s) + phase);
}

// Moments and weight enlarged alike change nothing: the derivative by I1 is at most those by I3 and the
// weight.
double top_error(const Problem& problem, double t_s) {
  constexpr double kApart = 0x1p-40;
  const RigidBodyState now = LagrangeTopMotion(problem).at(t_s);
  double cond_w = 0, cond_q = 0;
  const auto add = [&](const Problem& changed, double t, int times = 1) {
    const RigidBodyState then = LagrangeTopMotion(changed).at(t);
    const double size = now.w_B.stableNorm();
    if (size > 0) cond_w += times * (then.w_B - now.w_B).stableNorm() / (size * kApart);
    cond_q += times * now.q_SB.angularDistance(then.q_SB) / kApart;
  };
  add(problem, t_s * (1 + kApart));
  for (int i = 0; i < 3; ++i) {
    Problem changed = problem;
    changed.start.w_B[i] *= 1 + kApart;
    add(changed, t_s);
  }
  for (int i = 0; i < 4; ++i) {
    Problem changed = problem;
    changed.start.q_SB.coeffs()[i] *= 1 + kApart;
    add(changed, t_s);
  }
  Vec3 I = problem.I.vector();
  I[top_axis(problem.I, problem.torque).axis] *= 1 - kApart;  // less, for no moment exceeds the two others
  add({PrincipalMoments(I[0], I[1], I[2]), problem.start, problem.torque}, t_s, 2);
  Problem heavier = problem;
  for (TorqueTerm& term : heavier.torque) std::get<HeavyTop>(term).mgr *= 1 + kApart;
  add(heavier, t_s, 2);
  return 4 * 0x1p-53 * (1 + std::max(cond_w, cond_q));
}

}  // namespace polhode
