// SPDX-License-Identifier: MIT
// What the physics tests share: reference cases, random bodies, measures of error.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/exact/double_double.h"
#include "physics/motion.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::test {

/// Unit roundoff, the ε of every tolerance here.
inline constexpr double kEps = 0x1p-53;

struct ReferenceState {
  double t_s;
  RigidBodyState state;   ///< rounded from 25 digits
  double cond_w, cond_q;  ///< structured condition numbers, see `conventions` in the file
};

struct ReferenceCase {
  std::string name, kind;  ///< kind: periodic, separatrix, steady
  PrincipalMoments I;
  RigidBodyState start;
  double period_s;  ///< NaN if there is none
  std::vector<ReferenceState> states;
};

/// tests/reference/torque_free.json, 52 bodies.
const std::vector<ReferenceCase>& reference_cases();
const ReferenceCase& reference_case(std::string_view name);
/// tests/reference/unseen.json, 60 more, made after the formulas.
const std::vector<ReferenceCase>& unseen_cases();

/// The default motion without torque, as every command makes it.
std::unique_ptr<const Motion> exact_motion(const PrincipalMoments& I, const RigidBodyState& start);

/// |Δω|/|ω| and |Δq| up to sign.
double w_error(const Vec3& w, const Vec3& truth);
double q_error(const Quat& q, const Quat& truth);

/// Relative changes of T and |L|, and the angle between L in space then and now; computed in double-double,
/// whatever the units. What storing a subnormal ω on its grid of 2⁻¹⁰⁷⁴ explains is taken off.
struct Drift {
  double T, L, direction;
};
Drift drift(const PrincipalMoments& I, const RigidBodyState& start, const RigidBodyState& now);

/// q̇_SB = ½ q_SB ⊗ (0, ω_B), as Eigen coefficients (x, y, z, w), 1/s.
Eigen::Vector4d attitude_rate(const Quat& q_SB, const Vec3& w_B);

/// Functions of 100 bits, for truths: by Taylor's series. Absolute error (sin, cos) and relative error (exp)
/// of about 2⁻¹⁰³(1 + |x|), relative error of expm1 about 2⁻¹⁰⁰.
struct SinCosTruth {
  DoubleDouble sin, cos;
};
SinCosTruth sin_cos(const DoubleDouble& x);
DoubleDouble exp(const DoubleDouble& x);
DoubleDouble expm1(const DoubleDouble& x);

bool same_bits(const RigidBodyState& x, const RigidBodyState& y);

/// Possible bodies in any axis order, ω in any octant, attitudes of any direction.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int uniform_int(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  Vec3 vector(double size);
  Quat attitude();
  PrincipalMoments moments();
  PrincipalMoments symmetric_moments();
  RigidBodyState state() { return {attitude(), vector(2.0)}; }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_;
};

}  // namespace polhode::test
