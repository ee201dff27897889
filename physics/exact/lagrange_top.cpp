// SPDX-License-Identifier: MIT
#include "physics/exact/lagrange_top.h"

#include "physics/exact/elementary.h"
#include "physics/exact/elliptic.h"
#include "physics/exact/uniform_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace polhode {
namespace {

using DD = DoubleDouble;
using Complex = std::complex<double>;

// std::complex multiplies with a look for infinities, which are none here.
Complex product(Complex x, Complex y) {
  return {x.real() * y.real() - x.imag() * y.imag(), x.real() * y.imag() + x.imag() * y.real()};
}
Complex direction(Complex z) {  // 0 stays 0
  const double size = std::hypot(z.real(), z.imag());
  return size == 0 ? z : z / size;
}
Complex turn(double quarter_turns) {
  const SinCos x =
      sincos_quarter_turns(std::clamp(quarter_turns, -kLargestQuarterTurns, kLargestQuarterTurns));
  return {x.cos, x.sin};
}
double sum_of(const ThetaSeries& c) { return std::accumulate(c.begin(), c.end(), 0.0); }
double sign_of(const DD& x) { return x < 0 ? -1.0 : 1.0; }
DD positive(const DD& x) { return x < 0 ? DD{} : x; }

std::optional<TopAxis> axis_of_weight(const Torque& torque) {
  Vec3 arm_B = Vec3::Zero();
  for (const TorqueTerm& term : torque) {
    const auto* top = std::get_if<HeavyTop>(&term);
    if (!top) return std::nullopt;
    arm_B += top->mgr * top->axis_B;
  }
  if (arm_B.isZero(0.0)) return TopAxis{-1, 1, 0};
  int c = 0;
  const double mgl = arm_B.cwiseAbs().maxCoeff(&c);
  if (arm_B[(c + 1) % 3] != 0 || arm_B[(c + 2) % 3] != 0) return std::nullopt;
  return TopAxis{c, std::copysign(1.0, arm_B[c]), mgl};
}

/// From the axes (a, b, c) of the top to those of the body: the cyclic change of names, and where the centre
/// of mass lies on the negative side of c half a turn about a. Space does not turn with them.
Quat axes_of_top(const TopAxis& top) {
  const double half = top.axis == 0 ? 0.5 : -0.5;
  const Quat names = top.axis == 2 ? Quat::Identity() : Quat(0.5, half, half, half);
  return top.sign < 0 ? names * Quat(0, 1, 0, 0) : names;
}

bool is_symmetric_about(const PrincipalMoments& I, int c) { return I[(c + 1) % 3] == I[(c + 2) % 3]; }

// The largest root of x³ + b x² + c x + d, of which all roots are real: Newton's method from Fujiwara's bound
// goes down to it without a jump over it, by a third at least of the way to the next root.
DD largest_root(const DD& b, const DD& c, const DD& d) {
  constexpr int kZero = -(1 << 20);
  const auto exponent = [](const DD& x) { return x == 0 ? kZero : ilogb(x) + 1; };
  const auto part = [](int e, int n) { return e > 0 ? (e + n - 1) / n : e / n; };  // of 2^(e/n), from above
  DD x = scalbn(DD{1}, 1 + std::max({exponent(b), part(exponent(c), 2), part(exponent(d), 3)}));
  constexpr int kMost = 400;
  for (int i = 0; i < kMost; ++i) {
    const DD value = ((x + b) * x + c) * x + d, slope = (3 * x + 2 * b) * x + c;
    if (!(value > 0) || !(slope > 0)) break;
    const DD next = x - value / slope;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

// Roots r1 ≥ 0 ≥ −r2 of x² − sum x − product, the product ≥ 0: none cancels.
struct TwoRoots {
  DD positive, minus_negative;
};
TwoRoots roots_of(const DD& sum, const DD& product) {
  const DD root = sqrt(sum * sum + 4 * product);
  const DD larger = scalbn(abs(sum) + root, -1), smaller = larger == 0 ? larger : product / larger;
  return sum < 0 ? TwoRoots{smaller, larger} : TwoRoots{larger, smaller};
}

}  // namespace

std::optional<std::string> why_no_top(const PrincipalMoments& I, const Torque& torque) {
  const bool weight_alone = std::all_of(torque.begin(), torque.end(), [](const TorqueTerm& term) {
    return std::holds_alternative<HeavyTop>(term);
  });
  if (!weight_alone) return "it serves weight alone";
  const auto top = axis_of_weight(torque);
  if (!top) return "the weight acts on no principal axis";
  if (top->axis >= 0 && !is_symmetric_about(I, top->axis))
    return "the two moments across the axis of the weight are not equal";
  if (top->axis < 0 && !is_symmetric_about(I, 0) && !is_symmetric_about(I, 1) && !is_symmetric_about(I, 2))
    return "no two moments are equal";
  return std::nullopt;
}

TopAxis top_axis(const PrincipalMoments& I, const Torque& torque) {
  if (const auto why = why_no_top(I, torque)) throw std::domain_error(*why);
  TopAxis top = *axis_of_weight(torque);
  if (top.axis < 0) top.axis = is_symmetric_about(I, 2) ? 2 : is_symmetric_about(I, 1) ? 1 : 0;
  return top;
}

// What the series give at one time, without the factors that turn with it.
struct LagrangeTopMotion::Shape {
  Complex P, Q, E;
  double half_periods = 0;  // those counted off, in_complementary_nome
};

LagrangeTopMotion::Shape LagrangeTopMotion::shape(const Formula& f, double v) {
  if (f.series == Series::in_nome) {
    const SinCos x = sincos_quarter_turns(2 * v);
    const double s = f.from_top ? x.cos : x.sin, c = f.from_top ? -x.sin : x.cos;
    const double s2 = s * s, c2 = c * c;
    const auto turned = [s, c](double multiple, Complex z) {
      return multiple == 0 ? z : product({c, multiple * s}, z);
    };
    const Complex P{s * polynomial(f.P.re, s2), -c * polynomial(f.P.im, c2)};
    const Complex Q{c * polynomial(f.Q.re, c2), s * polynomial(f.Q.im, s2)};
    const Complex E = turned(f.x_turn_E, {c * polynomial(f.E.re, c2), s * polynomial(f.E.im, s2)});
    return {turned(f.x_turn_P, P), turned(f.x_turn_Q, Q), turned(-f.x_turn_P, turned(f.x_turn_Q, E)), 0};
  }
  // Distances from the nearest lowest and highest point, the nearer one accurate as a number.
  double half_periods = 0, r = v, d = 0;
  if (f.series == Series::in_complementary_nome) {
    const double shifted = v + kRounder;
    half_periods = shifted - kRounder;
    const double near = v - half_periods;
    const double far = near < 0 ? near + 0.5 : near - 0.5;
    if (f.from_top && !(near < 0)) half_periods += 1;
    r = f.from_top ? far : near;
    d = f.from_top ? near : far;
  }
  const bool to_bottom = f.series == Series::separatrix || std::abs(r) <= std::abs(d);
  const double X = f.X_per_v * std::abs(to_bottom ? r : d);
  const Decay decayed = decay(X < kLastDecay ? X : kLastDecay);
  const double other = f.root_nome * decayed.inverse;
  const double one_minus = decayed.one_minus_exp * (1 + decayed.exp),
               one_minus_other = (1 - other) * (1 + other);
  const double root_E = to_bottom ? decayed.exp : other, root_W = to_bottom ? other : decayed.exp;
  const double E = root_E * root_E, W = root_W * root_W;
  const double one_minus_E = to_bottom ? one_minus : one_minus_other,
               one_minus_W = to_bottom ? one_minus_other : one_minus;
  const double q = f.nome, q2 = q * q;

  // θ_1(Y + iX; q') or θ_4, but for factors that go into the amplitudes and the start: divided by what is
  // zero first, which keeps its relative accuracy, (1 − E e^{2iY}) [1 − q'² − (1 − q'⁴) q'W e^{−2iY} − q'²E
  // e^{2iY} + q'⁴W² e^{−4iY}], in Y or in −Y. Left out: q'⁶ < ε/3.
  const auto theta = [q, q2](const Theta& t, double side, double E_, double one_minus_E_, double W_) {
    const double sin2 = side * t.e2.imag(), cos2 = t.e2.real();
    const double sin4 = side * t.e4.imag(), cos4 = t.e4.real();
    const double V = (1 - q2 * q2) * q * W_, U = q2 * E_, S = q2 * q2 * W_ * W_;
    const Complex lead{one_minus_E_ + 2 * E_ * t.sin_Y2, -E_ * sin2};
    const Complex rest{1 - q2 - (V + U) * cos2 + S * cos4, (V - U) * sin2 - S * sin4};
    return product(lead, rest);
  };
  const double sign = r < 0 ? -1.0 : 1.0;
  Complex P = product(std::conj(f.P.e1), theta(f.P, 1, E, one_minus_E, W));
  Complex Q = root_E * theta(f.Q, -1, W, one_minus_W, E);
  Complex across = root_E * theta(f.E, -1, W, one_minus_W, E);
  P = {sign * P.real(), P.imag()};
  Q = {Q.real(), sign * Q.imag()};
  across = {across.real(), sign * across.imag()};
  return {P, Q, across, half_periods};
}

// From the start to the constants of the formula, in double-double up to the roots.
struct LagrangeTopMotion::Setup {
  const RigidBodyState& start;
  Formula f;
  TopFacts facts;

  DD w_c, alpha, gamma, spin;      // spin = ω_c − α
  DD P, Q, u_rate, v0, w0;         // v = 1 − u, w = 1 + u
  DD x1, x2, D21, v1, v2, w1, w2;  // |u1 − u0|, u2 − u0, u2 − u1
  DD N3, D31, D32;                 // γ(u3 − 1), γ(u3 − u1), γ(u3 − u2)
  DD E1, E2, E3;                   // γ|u_E − u_i|: |ω_a + iω_b|² at u1, u2
  Complex at_P, at_Q, at_E;        // the start's components
  Extended kp, K, Kp, lambda;
  // A zero of a theta function in complex time: the imaginary part of its u, of K' at most.
  struct Zero {
    double sign = 1;
    Extended F{0};
    bool infinite = false;  // as K' where nothing nutates
  };
  Zero zero_P, zero_Q, zero_E;

  Setup(const Problem& problem, const TopAxis& top, const RigidBodyState& start_given);

 private:
  DD c_, d_, c0_, c1_;
  Extended unit_ = 1;

  bool axis_stays() const { return at_E == 0.0 && (at_P == 0.0 || at_Q == 0.0 || gamma == 0); }
  void rotate();
  void find_roots();
  void set_pair_of_lower_roots();
  void set_pair_of_upper_roots();
  void set_phase();
  void set_zeros();
  void set_rates();
  void set_theta(Theta& theta, const Zero& zero) const;
  void set_amplitudes();
  void set_start();
};

LagrangeTopMotion::Setup::Setup(const Problem& problem, const TopAxis& top, const RigidBodyState& start_given)
    : start(start_given) {
  const auto c = static_cast<std::size_t>(top.axis);
  f.axes = {static_cast<int>((c + 1) % 3), static_cast<int>((c + 2) % 3), top.axis};
  f.sign = top.sign;
  f.to_top = axes_of_top(top);
  const Quat q = start.q_SB * f.to_top;
  const auto& w = start.w_B;
  at_P = {q.w(), q.z()};
  at_Q = {q.x(), q.y()};
  at_E = {w[f.axes[0]], f.sign * w[f.axes[1]]};
  f.w_c = f.sign * w[f.axes[2]];

  const DD I1 = problem.I[f.axes[0]], I3 = problem.I[f.axes[2]];
  w_c = f.w_c;
  alpha = I3 * w_c / I1;
  spin = (I1 - I3) * w_c / I1;
  gamma = 2 * DD{top.mgl} / I1;
  const auto square = [](Complex z) { return DD{z.real()} * z.real() + DD{z.imag()} * z.imag(); };
  const DD P2 = square(at_P), Q2 = square(at_Q), q2 = P2 + Q2, k = square(at_E);
  v0 = 2 * Q2 / q2;
  w0 = 2 * P2 / q2;
  // Vertical in the body, its part across the axis: 2i P̄Q/|q|².
  const DD Pr = at_P.real(), Pi = at_P.imag(), Qr = at_Q.real(), Qi = at_Q.imag();
  const DD Z_a = -2 * (Pr * Qi - Pi * Qr) / q2, Z_b = 2 * (Pr * Qr + Pi * Qi) / q2;
  const DD w_a = at_E.real(), w_b = at_E.imag();
  const DD p = w_a * Z_a + w_b * Z_b;
  u_rate = w_b * Z_a - w_a * Z_b;
  P = p + alpha * w0;
  Q = p - alpha * v0;
  const DD e = k - gamma * v0;
  c_ = 2 * gamma - e - alpha * alpha;
  d_ = 2 * (e - alpha * Q);
  c0_ = u_rate * u_rate;
  c1_ = 2 * alpha * p - gamma * v0 * w0 - (w0 - v0) * k;
  E2 = e;  // where u2 = 1

  int exponent = gamma == 0 ? std::numeric_limits<int>::min() : ilogb(gamma) >> 1;
  for (const double rate : {at_E.real(), at_E.imag(), f.w_c})
    if (rate != 0) exponent = std::max(exponent, std::ilogb(rate));
  exponent = std::clamp(exponent, -1070, 1020);
  f.unit = std::scalbn(1.0, exponent);
  unit_ = f.unit;
  if (axis_stays()) {
    rotate();
    return;
  }
  find_roots();
  set_phase();
  set_zeros();
  set_rates();
  set_theta(f.P, zero_P);
  set_theta(f.Q, zero_Q);
  set_theta(f.E, zero_E);
  set_amplitudes();
  set_start();
}

// The axis rests in the vertical, or nothing turns it.
void LagrangeTopMotion::Setup::rotate() {
  f.series = Series::rotation;
  const double theta = 2 * std::atan2(std::abs(at_Q), std::abs(at_P));
  facts = {theta, theta, std::numeric_limits<double>::infinity(), 0, f.w_c};
}

// N = γ(u − 1) solves N³ + cN² − dγN − Q²γ² = 0, in which no weight is no special case. At the inflection,
// the mean of the roots, the sign tells which root is the lone one: of the two others the distances from what
// they are near to come from a quadratic equation.
void LagrangeTopMotion::Setup::find_roots() {
  const DD mean = -c_ / 3, linear = -d_ * gamma, constant = -Q * Q * gamma * gamma;
  const DD at_mean = ((mean + c_) * mean + linear) * mean + constant;
  if (at_mean > 0) {
    set_pair_of_upper_roots();
  } else {
    if (constant == 0) {
      N3 = positive(roots_of(-c_, positive(-linear)).positive);
      if (linear > 0) N3 = c_ < 0 ? -c_ : DD{};  // then Q = 0 < v2: u3 = 1
    } else {
      N3 = largest_root(c_, linear, constant);
    }
    set_pair_of_lower_roots();
  }
  w1 = P * P / (w2 * (2 * gamma + N3));
  D32 = N3 + gamma * v2;
  D31 = D32 + gamma * D21;
  if (v2 > 0) {
    const DD level = Q + alpha * v2;
    E2 = level * level / (v2 * w2);
  } else {
    E2 = positive(E2);
  }
  E1 = E2 + gamma * D21;
  const DD beyond = Q * gamma - alpha * N3;
  E3 = N3 > 0 ? beyond * beyond / (N3 * (2 * gamma + N3)) : positive(D32 - E2);
}

// u3 alone: u1 and u2 about u0, which lies between.
void LagrangeTopMotion::Setup::set_pair_of_lower_roots() {
  const DD G3 = N3 + gamma * v0, product = c0_ / G3;  // γ(u3 − u0); |x1| x2
  const TwoRoots x = roots_of((c1_ + gamma * product) / G3, product);
  x2 = x.positive;
  x1 = x.minus_negative;
  D21 = x1 + x2;
  v1 = v0 + x1;
  w2 = w0 + x2;
  const DD by_difference = positive(v0 - x2);
  v2 = N3 > 0 && 2 * x2 > v0 ? Q * Q / (N3 * v1) : by_difference;
}

// u1 alone: u2 and u3 about 1, which lies between.
void LagrangeTopMotion::Setup::set_pair_of_upper_roots() {
  const DD V1 = largest_root(-c_, -d_ * gamma, Q * Q * gamma * gamma);
  v1 = V1 / gamma;
  const DD product = Q * Q / (V1 * gamma) * gamma;  // v2 (u3 − 1)
  const TwoRoots v = roots_of((product - d_ / gamma) / v1, product);
  v2 = v.positive;
  N3 = gamma * v.minus_negative;
  w2 = 2 - v2;
  const DD G3 = N3 + gamma * v0;
  x2 = positive(v0 - v2);
  x1 = positive(v1 - v0);
  if (x1 > x2)
    x2 = c0_ / (x1 * G3);
  else
    x1 = c0_ / (x2 * G3);
  D21 = x1 + x2;
}

void LagrangeTopMotion::Setup::set_phase() {
  lambda = sqrt(to_extended(D31)) / 2;
  kp = D32 == 0 ? Extended{0} : std::min(Extended{1}, sqrt(to_extended(D32 / D31)));
  const Extended k = std::min(Extended{1}, sqrt(to_extended(gamma * D21 / D31)));
  K = kp == 0 ? Extended{0} : complete_elliptic_K(kp);
  Kp = complete_elliptic_K(k);
  if (D21 == 0) {
    f.v0 = 0;
    return;
  }
  const Extended s = sqrt(to_extended(x1 / D21)), c = sqrt(to_extended(x2 / D21));
  const bool rising = !(u_rate < 0);
  if (kp == 0) {
    f.v0 = (rising ? 1 : -1) * double(asinh(s / c));
    return;
  }
  const Extended dn = sqrt(c * c + kp * kp * s * s);
  f.from_top = x2 < x1;
  const Extended u =
      f.from_top ? c * carlson_RF_of_squares(kp * s, kp, dn) : s * carlson_RF_of_squares(c, dn, 1);
  f.v0 = (rising != f.from_top ? 1 : -1) * double(u / (2 * K));
}

// Which of the zeros lie above the real axis follows from the signs of φ̇ at u1 and u2, where u̇ = 0.
void LagrangeTopMotion::Setup::set_zeros() {
  facts.theta_least_rad = 2 * std::atan2(double(sqrt(to_extended(v2))), double(sqrt(to_extended(w2))));
  facts.theta_most_rad = 2 * std::atan2(double(sqrt(to_extended(v1))), double(sqrt(to_extended(w1))));
  const auto zero = [](double sign, const DD& sin2, const DD& cos2, const DD& delta2) {
    if (delta2 == 0) return Zero{sign, 0, true};
    const Extended s = sqrt(to_extended(sin2));
    return Zero{sign, s * carlson_RF_of_squares(sqrt(to_extended(cos2)), sqrt(to_extended(delta2)), 1),
                false};
  };
  const DD k2 = gamma * D21 / D31;
  zero_P = zero(sign_of(P), w1 / w2, D21 / w2, D21 / w2 + k2 * w1 / w2);
  zero_Q.sign = sign_of(Q);
  const double sign_1 = w1 == 0 ? zero_P.sign : sign_of(P - alpha * w1);
  const double sign_2 = v2 == 0 ? zero_Q.sign : sign_of(Q + alpha * v2);
  const bool is_Q_farther = !(v2 * D31 < w1 * N3);
  f.x_turn_E = zero_P.sign != zero_Q.sign || is_Q_farther ? zero_Q.sign : -zero_Q.sign;
  f.C_E = -zero_P.sign * sign_1;
  zero_E.sign = f.C_E * f.x_turn_E * zero_Q.sign * sign_2;
  if (kp == 0) return;  // they meet where u = 1, at infinity
  zero_Q = zero(zero_Q.sign, v2 * D31 / (v1 * D32), D21 * N3 / (v1 * D32), D21 / v1);
  zero_E = E1 == 0
               ? Zero{zero_E.sign, 0, true}
               : zero(zero_E.sign, E2 * D31 / (E1 * D32), gamma * D21 * E3 / (E1 * D32), gamma * D21 / E1);
}

void LagrangeTopMotion::Setup::set_rates() {
  const Extended half_spin = to_extended(spin) / 2, quarter = unit_ * kPi / 2;
  if (kp == 0) {
    const Extended half_P = to_extended(P) / 4;  // half of P/(1 + u) where u = 1
    f.series = Series::separatrix;
    f.v_rate = double(lambda / unit_);
    f.turn_P = double((half_spin + half_P) / quarter);
    f.turn_Q = double(-half_spin / quarter);
    f.last_time = 0x1p49 / f.v_rate;
    facts.nutation_period_s = std::numeric_limits<double>::infinity();
    facts.mean_precession = double(half_P);
    facts.mean_spin = double(2 * half_spin + half_P);
    return;
  }
  constexpr double kLargestNome = 0.21;  // five terms to here, three beyond
  f.series =
      std::exp(double(-kPi * Kp / K)) <= kLargestNome ? Series::in_nome : Series::in_complementary_nome;
  const bool counted = f.series == Series::in_complementary_nome;
  const Extended x_rate = kPi * lambda / (2 * K);
  // Half the means of |P|/(1 + u) and |Q|/(1 − u), and those less what the theta functions turn by
  // themselves.
  const auto half_mean = [&](const DD& squared, const DD& p) {
    const Extended root_p = sqrt(to_extended(p));
    return sqrt(to_extended(squared)) * bulirsch_cel(kp, root_p, root_p, 1) / (2 * K);
  };
  // One or the other is turned by x, whichever leaves less to the linear phase.
  const auto own = [&](const Zero& zero, const Extended& mean, double& x_turn) {
    if (counted) return x_rate * (1 - zero.F / Kp);
    if (2 * mean > x_rate) return x_rate;
    x_turn = -zero.sign;
    return Extended{0};
  };
  Extended mean_P = 0, mean_Q = 0, rest_P = 0, rest_Q = 0;
  if (w1 > 0) {
    mean_P = half_mean(2 * gamma + N3, w2 / w1);
    rest_P = mean_P - own(zero_P, mean_P, f.x_turn_P);
  }
  if (v2 > 0) {
    mean_Q = half_mean(N3, v2 / v1);
    rest_Q = mean_Q - own(zero_Q, mean_Q, f.x_turn_Q);
  }
  f.turn_P = double((half_spin + zero_P.sign * rest_P) / quarter);
  f.turn_Q = double((zero_Q.sign * rest_Q - half_spin) / quarter);
  if (counted) {
    f.jump_P = 2 * (zero_P.sign * double(zero_P.F / Kp) - 1);
    f.jump_Q = 2 * (zero_Q.sign * double(zero_Q.F / Kp) - 1);
  }
  f.v_rate = double(lambda / (2 * K) / unit_);
  f.last_time = std::min(0x1p49 / f.v_rate, std::numeric_limits<double>::max());
  facts.nutation_period_s = double(2 * K / lambda);
  facts.mean_precession = double(zero_P.sign * mean_P + zero_Q.sign * mean_Q);
  facts.mean_spin = double(2 * half_spin + zero_P.sign * mean_P - zero_Q.sign * mean_Q);
}

void LagrangeTopMotion::Setup::set_theta(Theta& t, const Zero& zero) const {
  if (f.series != Series::in_nome) {
    double sin_Y = 0, cos_Y = 1;
    if (f.series == Series::in_complementary_nome) {
      const double Y = double(kPi * zero.F / (2 * Kp));
      sin_Y = std::sin(Y);
      cos_Y = std::cos(Y);
    } else if (&t == &f.P) {
      sin_Y = double(sqrt(to_extended(w1 / 2)));
      cos_Y = double(sqrt(to_extended(v1 / 2)));
    }
    t.e1 = {cos_Y, zero.sign * sin_Y};
    t.e2 = product(t.e1, t.e1);
    t.e4 = product(t.e2, t.e2);
    t.sin_Y2 = sin_Y * sin_Y;
    return;
  }
  const double nome = std::exp(double(-kPi * Kp / K));
  const double y2 = zero.infinite ? std::numeric_limits<double>::infinity() : double(kPi * zero.F / K);
  const double g =
      zero.infinite ? 0.0 : std::min(1.0, std::exp(double(kPi * (zero.F - Kp) / K)));  // q e^{2y}
  const double e = std::exp(-y2), one_minus_e = -std::expm1(-y2);
  ThetaSeries re{}, im{};
  double side = 1, q_n = 1, q_nn = 1, g_n = 1;  // (−1)ⁿ, qⁿ, q^{n²}, gⁿ
  double e_odd = e, e_sum = 1;                  // e^{2n+1}, 1 + e + … + e^{2n}
  for (std::size_t n = 0; n < re.size(); ++n) {
    re[n] = side * q_nn * g_n * (1 + e_odd) / (1 + e);
    im[n] = zero.sign * q_nn * g_n * e_sum * one_minus_e / (1 + e);
    side = -side;
    q_nn *= q_n * q_n * nome;
    q_n *= nome;
    g_n *= g;
    e_sum += e_odd * (1 + e);
    e_odd *= e * e;
  }
  t.re = odd_harmonics(re);
  t.im = odd_harmonics(im);
}

// From u = u2 for P, from u = u1 for Q and E, where the series are largest. What is common to all three goes
// with the length of q.
void LagrangeTopMotion::Setup::set_amplitudes() {
  double P_2 = 1, Q_1 = 1, E_1 = 1, theta4_1 = 1, theta4_2 = 1;
  if (f.series == Series::in_nome) {
    const double q = std::exp(double(-kPi * Kp / K)), q4 = q * q * q * q, q9 = q4 * q4 * q;
    const double even = 1 + 2 * q4 * (1 + q4 * q4 * q4), odd = 2 * q + 2 * q9;
    theta4_1 = even - odd;
    theta4_2 = even + odd;
    P_2 = sum_of(f.P.re);
    Q_1 = sum_of(f.Q.re);
    E_1 = sum_of(f.E.re);
  } else {
    if (f.series == Series::in_complementary_nome) {
      const Extended X = kPi * K / Kp;
      f.X_per_v = double(X);
      // Times what the rounding of so large an exponent leaves out.
      f.root_nome = std::exp(-0.5 * f.X_per_v) * (1 - 0.5 * double(X - f.X_per_v));
      f.nome = f.root_nome * f.root_nome;
    }
    const double q = f.nome, q2 = q * q, q4 = q2 * q2;
    theta4_1 = 2 + 2 * q2;
    theta4_2 = 1 + 2 * q + 2 * q4;
    Formula from_bottom = f;
    from_bottom.from_top = false;
    const Shape lowest = shape(from_bottom, 0);
    from_bottom.from_top = true;
    // At u2, W = 1 and E = q'; on the separatrix that is at infinity.
    const Shape highest = f.series == Series::separatrix ? Shape{f.P.e1, 0, 0, 0} : shape(from_bottom, 0);
    P_2 = std::abs(highest.P);
    Q_1 = lowest.Q.real();
    E_1 = lowest.E.real();
  }
  f.C_P = double(sqrt(to_extended(w2 / 2))) * theta4_2 / P_2;
  f.C_Q = double(sqrt(to_extended(v1 / 2))) * theta4_1 / Q_1;
  f.C_E *= double(sqrt(to_extended(E1)) / unit_) * theta4_1 / E_1;
}

void LagrangeTopMotion::Setup::set_start() {
  const Shape at = shape(f, f.v0);
  // ω_a + iω_b turns with the second over the first: where one of these is zero, it tells its direction.
  f.start_P = product(direction(at_P), direction(std::conj(at.P)));
  f.start_Q = product(direction(at_Q), direction(std::conj(at.Q)));
  const Complex relative = direction(product(direction(at_E), std::conj(f.C_E * at.E)));
  if (f.start_P == 0.0) f.start_P = product(f.start_Q, std::conj(relative));
  if (f.start_Q == 0.0) f.start_Q = product(f.start_P, relative);
  // Half periods counted off at the start.
  if (f.series != Series::in_complementary_nome) return;
  const Complex back_P = turn(f.jump_P * at.half_periods), back_Q = turn(f.jump_Q * at.half_periods);
  f.start_P = product(f.start_P, back_P);
  f.start_Q = product(f.start_Q, back_Q);
}

LagrangeTopMotion::LagrangeTopMotion(const Problem& problem) : start_(checked(problem).start) {
  Setup setup(problem, top_axis(problem.I, problem.torque), start_);
  f_ = setup.f;
  facts_ = setup.facts;
}

RigidBodyState LagrangeTopMotion::at(double t_s) const {
  if (t_s == 0) return start_;
  const Formula& f = f_;
  if (f.series == Series::rotation) return {start_.q_SB * rotation_by(start_.w_B, t_s), start_.w_B};
  const double t = std::clamp(t_s * f.unit, -f.last_time, f.last_time);
  const Shape at = shape(f, f.v0 + f.v_rate * t);
  const Complex turn_P = product(f.start_P, turn(f.turn_P * t - f.jump_P * at.half_periods));
  const Complex turn_Q = product(f.start_Q, turn(f.turn_Q * t - f.jump_Q * at.half_periods));
  const Complex P = f.C_P * product(turn_P, at.P), Q = f.C_Q * product(turn_Q, at.Q);
  const double inverse = 1 / std::sqrt(std::norm(P) + std::norm(Q));
  const Complex across = (f.C_E * inverse) * product(product(std::conj(turn_P), turn_Q), at.E);

  RigidBodyState state;
  const Quat in_top(inverse * P.real(), inverse * Q.real(), inverse * Q.imag(), inverse * P.imag());
  state.q_SB = in_top * f.to_top.conjugate();
  state.w_B[f.axes[0]] = f.unit * across.real();
  state.w_B[f.axes[1]] = f.sign * f.unit * across.imag();
  state.w_B[f.axes[2]] = start_.w_B[f.axes[2]];
  return state;
}

}  // namespace polhode
