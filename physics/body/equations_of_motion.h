// SPDX-License-Identifier: MIT
// Equations of motion of a rigid body under any torque, as the integrators evaluate them: plain numbers in,
// plain numbers out, no memory asked for, nothing looked up twice.
//
//     ω̇_1 = g_1 ω_2 ω_3 + M_1/I_1 and cyclic,   g_1 = (I_2 − I_3)/I_1   (Euler; |g_i| ≤ 1)
//     q̇_SB = ½ q_SB ⊗ (0, ω + s)
//     M = N_B + L×s,   s = c (L×ω)/|L|
//
// N_B: sum of the torques of torque.h; s: slip of an EnergySink, zero without one. Equations and sources:
// euler.h, torque.h, which have them in vectors, term by term; a test holds one to the other. A torque that
// depends on attitude uses the direction of q alone, q/|q|, so that a method under which |q| drifts turns
// nothing else.
#pragma once

#include "physics/body/problem.h"

namespace polhode {

/// y = (ω_B, q_SB as x, y, z, w), rad/s and 1, and an eighth number that stays 0: four pairs, which a
/// processor takes two or four at a time. A rate ẏ has the same form.
struct alignas(16) MotionVector {
  static constexpr int kSize = 8;
  double v[kSize] = {};

  double operator[](int i) const { return v[i]; }
  double& operator[](int i) { return v[i]; }
};

/// The state as a vector, and back; q is taken as it is, not normalised.
inline MotionVector packed(const RigidBodyState& state) {
  const auto& q = state.q_SB.coeffs();
  return {{state.w_B[0], state.w_B[1], state.w_B[2], q[0], q[1], q[2], q[3], 0.0}};
}
inline RigidBodyState unpacked(const MotionVector& y) {
  return {Quat(y[6], y[3], y[4], y[5]), {y[0], y[1], y[2]}};
}

class EquationsOfMotion {
 public:
  EquationsOfMotion(const PrincipalMoments& I, const Torque& torque);

  /// ẏ(y).
  void rate(const MotionVector& y, MotionVector& rate) const {
    const double* w = y.v;
    const double* q = y.v + 3;
    double slip[3] = {};
    if (!torque_free_) add_slip(w, slip);
    w_rate(w, q, slip, rate.v);

    const double a = 0.5 * (w[0] + slip[0]), b = 0.5 * (w[1] + slip[1]), c = 0.5 * (w[2] + slip[2]);
    rate.v[3] = q[3] * a + q[1] * c - q[2] * b;
    rate.v[4] = q[3] * b + q[2] * a - q[0] * c;
    rate.v[5] = q[3] * c + q[0] * b - q[1] * a;
    rate.v[6] = -(q[0] * a + q[1] * b + q[2] * c);
    rate.v[7] = 0.0;
  }

  /// ω̇(ω), the same numbers as rate gives; only for torques that do not depend on attitude.
  void rate(const double (&w)[3], double (&rate)[3]) const {
    constexpr double kUpright[4] = {0, 0, 0, 1};
    double slip[3] = {};
    if (!torque_free_) add_slip(w, slip);
    w_rate(w, kUpright, slip, rate);
  }

  bool depends_on_attitude() const { return depends_on_attitude_; }

 private:
  void w_rate(const double* w, const double* q, const double* slip, double* rate) const {
    rate[0] = g_[0] * w[1] * w[2];
    rate[1] = g_[1] * w[2] * w[0];
    rate[2] = g_[2] * w[0] * w[1];
    if (!torque_free_) add_torque(w, q, slip, rate);
  }

  void add_slip(const double* w, double* slip) const;
  void add_torque(const double* w, const double* q, const double* slip, double* w_rate) const;

  double I_[3], g_[3];
  double N_S_[3] = {}, N_B_[3] = {};  // sums over the terms
  double weight_arm_B_[3] = {};       // Σ mgr a_B
  double damping_ = 0.0, sink_ = 0.0;
  bool torque_free_, depends_on_attitude_;
};

}  // namespace polhode
