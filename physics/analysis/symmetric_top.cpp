// SPDX-License-Identifier: MIT
#include "physics/analysis/symmetric_top.h"

#include "physics/body/euler.h"
#include "physics/exact/elliptic.h"
#include "physics/exact/powers_of_two.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace polhode {
namespace {

bool equal(double a, double b) { return std::abs(a - b) <= kEqualMoments * std::max(a, b); }

bool is_level(double cos_theta) { return std::abs(cos_theta) <= std::numeric_limits<double>::epsilon(); }

/// Where the sign of `cubic` changes between `low`, where it is not positive, and `high`, where it is not
/// negative; either may be the larger.
template <class Cubic>
double root_between(const Cubic& cubic, double low, double high) {
  constexpr int kHalvings = 1100;  // to neighbouring numbers, from anywhere
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::midpoint(low, high);
    if (middle == low || middle == high) break;
    (cubic(middle) < 0 ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::optional<FreePrecession> free_precession(const PrincipalMoments& I, const Vec3& w_B) {
  for (int axis = 0; axis < 3; ++axis) {
    const double I1 = I[(axis + 1) % 3], I3 = I[axis];
    if (!equal(I1, I[(axis + 2) % 3]) || equal(I1, I3)) continue;
    return FreePrecession{axis, norm_of(angular_momentum_B(I, w_B)) / I1, (I3 - I1) / I1 * w_B[axis]};
  }
  return std::nullopt;
}

std::optional<SymmetricTop> symmetric_top(const PrincipalMoments& I, const Torque& torque) {
  Vec3 arm_B = Vec3::Zero();
  for (const TorqueTerm& term : torque)
    if (const auto* top = std::get_if<HeavyTop>(&term)) arm_B += top->mgr * top->axis_B;
  if (arm_B.isZero(0.0) || !arm_B.allFinite()) return std::nullopt;
  int axis = 0;
  const double mgl = arm_B.cwiseAbs().maxCoeff(&axis);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  if (std::abs(arm_B[j]) > kEqualMoments * mgl || std::abs(arm_B[k]) > kEqualMoments * mgl ||
      !equal(I[j], I[k]))
    return std::nullopt;
  return SymmetricTop{I[j], I[axis], mgl, std::copysign(1.0, arm_B[axis]) * Vec3::Unit(axis)};
}

double least_spin(const SymmetricTop& top, double cos_theta) {
  return is_level(cos_theta) ? 0.0 : 2 * std::sqrt(top.I1 * top.mgl * std::max(cos_theta, 0.0)) / top.I3;
}

std::optional<SteadyPrecession> steady_precession(const SymmetricTop& top, double cos_theta, double w3) {
  const bool level = is_level(cos_theta);
  const double a = level ? 0.0 : top.I1 * cos_theta, b = top.I3 * w3, c = top.mgl;
  const double discriminant = b * b - 4 * a * c;
  const double larger = b + std::copysign(std::sqrt(discriminant), b);
  if (!(discriminant >= 0) || larger == 0) return std::nullopt;
  SteadyPrecession steady{2 * c / larger, {}};
  if (!level) steady.fast = larger / (2 * a);
  return steady;
}

// About u0 = cosθ now: f(u0 + x) = u̇0² + x (−β s − 2 u0 k + 2 a p) + x² (2 u0 β − k − a²) + β x³ with
// s = sin²θ, v = ω − ω3 e the part of ω across the axis e, k = |v|² = α − βu0 and p = v_z = b − a u0: no sum
// in it cancels where the axis is nearly upright or the top fast.
std::optional<Nutation> nutation(const SymmetricTop& top, const RigidBodyState& state) {
  const Vec3 e_S = state.q_SB * top.axis_B, w_S = state.q_SB * state.w_B;
  const double w3 = state.w_B.dot(top.axis_B);
  const Vec3 v_S = state.q_SB * (state.w_B - w3 * top.axis_B);
  const double u0 = std::clamp(e_S.z(), -1.0, 1.0), s = e_S.x() * e_S.x() + e_S.y() * e_S.y();
  const double k = v_S.squaredNorm(), p = v_S.z(), u_rate = w_S.cross(e_S).z();
  const double beta = 2 * top.mgl / top.I1, a = top.I3 / top.I1 * w3;
  const double c0 = u_rate * u_rate, c1 = -beta * s - 2 * u0 * k + 2 * a * p, c2 = 2 * u0 * beta - k - a * a;
  const auto f = [&](double x) { return c0 + x * (c1 + x * (c2 + x * beta)); };
  const double beyond = 1 + (std::abs(c0) + std::abs(c1) + std::abs(c2)) / beta;  // Cauchy's bound of roots
  if (!std::isfinite(beyond)) return std::nullopt;
  const double x1 = root_between(f, -1 - u0, 0), x2 = root_between(f, 1 - u0, 0);
  const double x3 = root_between(f, 1 - u0, std::max(beyond, 1 - u0));
  constexpr double kMeet = 1e-12;  // closer, the period is that of rounding
  if (!(x3 - x2 > kMeet * (x3 - x1))) return std::nullopt;
  Nutation nutation;
  const auto angle = [&](double x) { return std::acos(std::clamp(u0 + x, -1.0, 1.0)); };
  nutation.theta_least_rad = angle(x2);
  nutation.theta_most_rad = angle(x1);
  const auto K = static_cast<double>(complete_elliptic_K(std::sqrt((x3 - x2) / (x3 - x1))));
  nutation.rate = std::numbers::pi / 2 * std::sqrt(beta * (x3 - x1)) / K;
  return nutation;
}

}  // namespace polhode
