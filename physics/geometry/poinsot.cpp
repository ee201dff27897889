// SPDX-License-Identifier: MIT
#include "physics/geometry/poinsot.h"

#include "physics/body/euler.h"
#include "physics/exact/elliptic.h"
#include "physics/exact/polhode_constants.h"
#include "physics/exact/powers_of_two.h"
#include "physics/geometry/curve_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace polhode {
namespace {

constexpr double kFinestChord = 0x1p-26;  // of the curve's size
constexpr int kFirstPiecesOfQuarter = 4;
constexpr std::size_t kMaxPointsOfQuarter = 1 << 14;
constexpr double kMaxTurnPerPiece = 0.5;  // rad, herpolhode

double checked_tolerance(double chord_tolerance) {
  if (!std::isfinite(chord_tolerance) || chord_tolerance <= 0) {
    throw std::domain_error("the chord tolerance must be finite and > 0");
  }
  return chord_tolerance;
}

double checked_energy(double two_T) {
  if (!std::isfinite(two_T) || two_T <= 0) throw std::domain_error("the energy must be finite and > 0");
  return two_T;
}

// A body in units in which moments and ω are about 1. Both units are powers of two, that of the moments of
// four, so that square roots scale as exactly as all else.
struct InUnits {
  PrincipalMoments I;
  int eI, ew;
  double two_T;
};

InUnits in_units(const PrincipalMoments& I, const Vec3& w_B) {
  const int e = exponent_of(I.vector()), eI = e - (e & 1), ew = exponent_of(w_B);
  // A moment that falls out of the range is kept above 0: the body is possible.
  const Vec3 moments = times_two_to(-eI, I.vector()).cwiseMax(std::numeric_limits<double>::min());
  const PrincipalMoments J(moments[0], moments[1], moments[2]);
  return {J, eI, ew, 2.0 * kinetic_energy(J, times_two_to(-ew, w_B))};
}

void scale(int e, std::vector<Curve>& curves) {
  for (Curve& curve : curves)
    for (Vec3& point : curve.points) point = times_two_to(e, point);
}

// A quarter of any polhode, in its own axes (a, b, c): φ from 0 to π/2.
struct QuarterArc {
  double A, B, C, kp;

  Vec3 at(double phi) const {
    if (phi == 0.5 * std::numbers::pi) return {0, B, C * kp};  // the vertex, exactly
    const double cosine = std::cos(phi);
    const double sine = std::sin(phi);
    return {A * cosine, B * sine, C * std::hypot(cosine, kp * sine)};
  }
};

std::vector<Vec3> sample_quarter(const QuarterArc& arc, double chord_tolerance) {
  const double finest = std::max(kFinestChord * std::max(arc.A, arc.B), 0x1p-50 * arc.C);
  const Sampling sampling{.chord_tolerance = std::max(chord_tolerance, finest),
                          .first_pieces = kFirstPiecesOfQuarter,
                          .max_points = kMaxPointsOfQuarter};
  return sample_curve([&arc](double phi) { return arc.at(phi); }, 0.0, 0.5 * std::numbers::pi, sampling);
}

// Where the axes (a, b, c) of a quarter arc lie in the body, with their signs.
struct Placement {
  int a, b, c;
  double sign_a, sign_b, sign_c;

  Vec3 operator()(double x, double y, double z) const {
    Vec3 w_B;
    w_B[a] = sign_a * x;
    w_B[b] = sign_b * y;
    w_B[c] = sign_c * z;
    return w_B;
  }
};

// The quarter and its mirror images, in the order of growing φ; ω_c changes sign with ω_a on an ellipse only.
Curve unfold(const std::vector<Vec3>& quarter, const Placement& place, bool is_ellipse) {
  const auto n = static_cast<std::ptrdiff_t>(quarter.size()) - 1;
  const double back_c = is_ellipse ? -1.0 : 1.0;
  Curve curve;
  curve.closed = true;
  curve.points.reserve(4 * static_cast<std::size_t>(n));
  const auto add = [&](std::ptrdiff_t i, double sign_x, double sign_y, double sign_z) {
    const Vec3& p = quarter[static_cast<std::size_t>(i)];
    curve.points.push_back(place(sign_x * p[0], sign_y * p[1], sign_z * p[2]));
  };
  for (std::ptrdiff_t i = 0; i < n; ++i) add(i, 1, 1, 1);
  for (std::ptrdiff_t i = n; i > 0; --i) add(i, -1, 1, back_c);
  for (std::ptrdiff_t i = 0; i < n; ++i) add(i, -1, -1, back_c);
  for (std::ptrdiff_t i = n; i > 0; --i) add(i, 1, -1, 1);
  return curve;
}

// The separatrices' quarter arc for axes sorted by moment: the member L²/2T = I_b of the family.
QuarterArc separatrix_quarter(const PrincipalMoments& I, const std::array<int, 3>& axes, double two_T) {
  const auto [a, b, c] = axes;
  const double root = std::sqrt(two_T);
  return {root * std::sqrt((I[c] - I[b]) / (I[c] - I[a]) / I[a]), root / std::sqrt(I[b]),
          root * std::sqrt((I[b] - I[a]) / (I[c] - I[a]) / I[c]), 0.0};
}

// Both branches of the polhode L²/2T = J ≠ I_mid, strictly between the extreme moments.
std::vector<Curve> branches_of(const PrincipalMoments& I, double two_T, double J, double chord_tolerance) {
  const std::array<int, 3> axes = sorted_axes(I);
  const bool about_largest = J > I[axes[1]];
  const int a = about_largest ? axes[0] : axes[2];
  const int b = axes[1];
  const int c = about_largest ? axes[2] : axes[0];
  const double sigma = about_largest ? 1.0 : -1.0;

  // Every ratio is of differences with the same sign, and lies in (0, 1].
  const double to_c = (I[c] - J) / (I[c] - I[a]);
  const double to_a = (J - I[a]) / (I[c] - I[a]);
  const double root = std::sqrt(two_T);
  const double kp2 = (J - I[b]) / (J - I[a]) * ((I[c] - I[a]) / (I[c] - I[b]));
  const QuarterArc arc{root * std::sqrt(to_c / I[a]), root * std::sqrt((I[c] - J) / (I[c] - I[b]) / I[b]),
                       root * std::sqrt(to_a / I[c]), std::min(1.0, std::sqrt(kp2))};

  const std::vector<Vec3> quarter = sample_quarter(arc, chord_tolerance);
  std::vector<Curve> branches;
  for (const double sign_c : {1.0, -1.0}) {
    branches.push_back(unfold(quarter, {a, b, c, 1.0, sigma * parity(a, b) * sign_c, sign_c}, false));
  }
  return branches;
}

// Largest |ω| seen at a few times of the interval, rad/s.
double largest_rate(const Motion& motion, double t0_s, double t1_s) {
  constexpr int kLooks = 8;
  double largest = 0;
  for (int i = 0; i <= kLooks; ++i) {
    const double rate = norm_of(motion.w_B_at(t0_s + (t1_s - t0_s) * (double{1} * i / kLooks)));
    if (rate > largest) largest = rate;  // false for NaN
  }
  return largest;
}

}  // namespace

Vec3 energy_ellipsoid_semi_axes(const PrincipalMoments& I, double two_T) {
  return I.vector().unaryExpr([two_T](double I_i) { return std::sqrt(two_T) / std::sqrt(I_i); });
}

Vec3 momentum_ellipsoid_semi_axes(const PrincipalMoments& I, double two_T) {
  return I.vector().unaryExpr([two_T](double I_i) { return std::sqrt(two_T) * std::sqrt(I_i); });
}

Vec3 energy_ellipsoid_semi_axes(const PrincipalMoments& I, const Vec3& w_B) {
  const InUnits body = in_units(I, w_B);
  return times_two_to(body.ew, energy_ellipsoid_semi_axes(body.I, body.two_T));
}

Vec3 momentum_ellipsoid_semi_axes(const PrincipalMoments& I, const Vec3& w_B) {
  const InUnits body = in_units(I, w_B);
  return times_two_to(body.ew + body.eI, momentum_ellipsoid_semi_axes(body.I, body.two_T));
}

double invariable_plane_distance(const PrincipalMoments& I, const Vec3& w_B) {
  const double w = w_B.cwiseAbs().maxCoeff();
  if (w == 0) return 0.0;
  const Vec3 direction_B = w_B / w;
  const Vec3 L_B = (I.vector() / I.vector().maxCoeff()).cwiseProduct(direction_B);
  return w * (L_B.dot(direction_B) / L_B.norm());
}

Curve polhode_curve(const PrincipalMoments& I, const Vec3& w_B, double chord_tolerance) {
  checked_tolerance(chord_tolerance);
  const auto p = polhode_constants(I, w_B);
  if (!p) return {{w_B}, false};

  const std::vector<Vec3> quarter =
      sample_quarter({double(p->A), double(p->B), double(p->C), double(p->kp)}, chord_tolerance);
  const double sign_a = p->separatrix() && w_B[p->a] < 0 ? -1.0 : 1.0;  // which of the two ellipses
  return unfold(quarter, {p->a, p->b, p->c, sign_a, p->sigma * p->sign_b, p->sign_c}, p->separatrix());
}

std::vector<PolhodeOfFamily> polhode_family(const PrincipalMoments& I, double two_T,
                                            const std::vector<double>& L2_over_2T, double chord_tolerance) {
  checked_tolerance(chord_tolerance);
  checked_energy(two_T);
  const auto [a, b, c] = sorted_axes(I);
  std::vector<PolhodeOfFamily> family;
  for (const double J : L2_over_2T) {
    if (!(J > I[a] && J < I[c])) {
      throw std::domain_error("L²/2T of a polhode must lie strictly between the extreme moments");
    }
    family.push_back(
        {J, J == I[b] ? separatrices(I, two_T, chord_tolerance) : branches_of(I, two_T, J, chord_tolerance)});
  }
  return family;
}

std::vector<PolhodeOfFamily> polhode_family(const PrincipalMoments& I, const Vec3& w_B,
                                            const std::vector<double>& L2_over_2T, double chord_tolerance) {
  const InUnits body = in_units(I, w_B);
  std::vector<double> levels = L2_over_2T;
  for (double& level : levels) level = std::scalbn(level, -body.eI);
  auto family = polhode_family(body.I, body.two_T, levels, std::scalbn(chord_tolerance, -body.ew));
  for (std::size_t i = 0; i < family.size(); ++i) {
    family[i].L2_over_2T = L2_over_2T[i];
    scale(body.ew, family[i].branches);
  }
  return family;
}

std::vector<Curve> separatrices(const PrincipalMoments& I, const Vec3& w_B, double chord_tolerance) {
  const InUnits body = in_units(I, w_B);
  auto ellipses = separatrices(body.I, body.two_T, std::scalbn(chord_tolerance, -body.ew));
  scale(body.ew, ellipses);
  return ellipses;
}

std::vector<Curve> separatrices(const PrincipalMoments& I, double two_T, double chord_tolerance) {
  checked_tolerance(chord_tolerance);
  checked_energy(two_T);
  const auto axes = sorted_axes(I);
  const auto [a, b, c] = axes;
  if (I[a] == I[b] || I[b] == I[c]) return {};

  const std::vector<Vec3> quarter = sample_quarter(separatrix_quarter(I, axes, two_T), chord_tolerance);
  return {unfold(quarter, {a, b, c, 1.0, 1.0, 1.0}, true), unfold(quarter, {a, b, c, 1.0, 1.0, -1.0}, true)};
}

Curve herpolhode(const Motion& motion, double t0_s, double t1_s, double chord_tolerance) {
  checked_tolerance(chord_tolerance);
  if (!std::isfinite(t0_s) || !std::isfinite(t1_s)) throw std::domain_error("times must be finite");

  const auto tip_S = [&motion](double t_s) -> Vec3 {
    const RigidBodyState state = motion.at(t_s);
    return state.q_SB * state.w_B;
  };
  const double rate = largest_rate(motion, t0_s, t1_s);
  const double turns = std::abs(t1_s - t0_s) * rate / kMaxTurnPerPiece;
  const Sampling sampling{
      .chord_tolerance = std::max(chord_tolerance, kFinestChord * rate),
      .first_pieces = static_cast<int>(std::clamp(std::ceil(turns), 4.0, 0.25 * kMaxHerpolhodePoints)),
      .max_halvings = 20,
      .max_points = kMaxHerpolhodePoints / 2};
  Curve curve{sample_curve(tip_S, t0_s, t1_s, sampling), false};

  const auto is_near_start = [&](const Vec3& p) {
    return norm_of(p - curve.points.front()) <= chord_tolerance;
  };
  if (std::all_of(curve.points.begin(), curve.points.end(), is_near_start) && !curve.points.empty()) {
    curve.points.resize(1);
  }
  return curve;
}

std::optional<double> polhode_period(const PrincipalMoments& I, const Vec3& w_B) {
  const auto p = polhode_constants(I, w_B);
  if (!p || p->separatrix()) return std::nullopt;
  const auto period_s = static_cast<double>(4 * complete_elliptic_K(p->kp) / p->lambda);
  return std::isfinite(period_s) ? std::optional(period_s) : std::nullopt;
}

std::vector<double> equal_arc_times(const Motion& motion, const PrincipalMoments& I, double from_s,
                                    double period_s, int count) {
  constexpr int kPieces = 512, kNewtonSteps = 4;
  if (!std::isfinite(from_s) || !std::isfinite(period_s) || period_s <= 0 || count <= 0)
    throw std::domain_error("times must be finite, the period and the count > 0");

  const auto speed = [&](double t_s) { return norm_of(angular_acceleration_B(I, motion.w_B_at(t_s))); };
  const auto length = [&](double t0_s, double t1_s) {  // by Gauss's rule of three points
    const double middle = 0.5 * (t0_s + t1_s), half = 0.5 * (t1_s - t0_s), off = std::sqrt(0.6) * half;
    return half * (5 * speed(middle - off) + 8 * speed(middle) + 5 * speed(middle + off)) / 9;
  };
  const auto start_s = [&](int piece) { return from_s + period_s * (double{1} * piece / kPieces); };
  std::vector<double> gone = {0.0};
  for (int n = 0; n < kPieces; ++n) gone.push_back(gone.back() + length(start_s(n), start_s(n + 1)));

  std::vector<double> times_s;
  int n = 0;
  for (int k = 0; k < count; ++k) {
    const double wanted = gone.back() * (double{1} * k / count);
    while (n + 1 < kPieces && gone[static_cast<std::size_t>(n) + 1] < wanted) ++n;
    const double before = gone[static_cast<std::size_t>(n)], after = gone[static_cast<std::size_t>(n) + 1];
    const double low_s = start_s(n), high_s = start_s(n + 1);
    double t_s = after > before ? std::lerp(low_s, high_s, (wanted - before) / (after - before)) : low_s;
    for (int step = 0; step < kNewtonSteps; ++step) {
      const double v = speed(t_s);
      if (v > 0) t_s = std::clamp(t_s - (before + length(low_s, t_s) - wanted) / v, low_s, high_s);
    }
    times_s.push_back(t_s);
  }
  return times_s;
}

}  // namespace polhode
