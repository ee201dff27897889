// SPDX-License-Identifier: MIT
#include "physics/body/equations_of_motion.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

void add(const Vec3& v, double (&sum)[3]) {
  for (int i = 0; i < 3; ++i) sum[i] += v[i];
}

void add_cross(const double* a, const double* b, double* sum) {
  sum[0] += a[1] * b[2] - a[2] * b[1];
  sum[1] += a[2] * b[0] - a[0] * b[2];
  sum[2] += a[0] * b[1] - a[1] * b[0];
}

// Rows of R_SB, that is the axes of S in body components, of q/|q|.
struct SpaceAxes {
  explicit SpaceAxes(const double* q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double s = 2.0 / (x * x + y * y + z * z + w * w);
    e[0][0] = 1 - s * (y * y + z * z), e[0][1] = s * (x * y - w * z), e[0][2] = s * (x * z + w * y);
    e[1][0] = s * (x * y + w * z), e[1][1] = 1 - s * (z * z + x * x), e[1][2] = s * (y * z - w * x);
    e[2][0] = s * (x * z - w * y), e[2][1] = s * (y * z + w * x), e[2][2] = 1 - s * (x * x + y * y);
  }
  double e[3][3];
};

}  // namespace

EquationsOfMotion::EquationsOfMotion(const PrincipalMoments& I, const Torque& torque)
    : I_{I[0], I[1], I[2]},
      g_{(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]},
      torque_free_(torque.empty()),
      depends_on_attitude_(polhode::depends_on_attitude(torque)) {
  struct Add {
    EquationsOfMotion& sums;
    void operator()(const SpaceTorque& term) const { add(term.N_S, sums.N_S_); }
    void operator()(const BodyTorque& term) const { add(term.N_B, sums.N_B_); }
    void operator()(const HeavyTop& term) const { add(term.mgr * term.axis_B, sums.weight_arm_B_); }
    void operator()(const LinearDamping& term) const { sums.damping_ += term.c; }
    void operator()(const EnergySink& term) const { sums.sink_ += term.c; }
  };
  for (const TorqueTerm& term : torque) std::visit(Add{*this}, term);
}

// s = c (L/|L|)×ω; L is scaled by its largest component lest its square leave the range.
void EquationsOfMotion::add_slip(const double* w, double* slip) const {
  if (sink_ == 0.0) return;
  double L[3] = {I_[0] * w[0], I_[1] * w[1], I_[2] * w[2]};
  const double largest = std::max({std::abs(L[0]), std::abs(L[1]), std::abs(L[2])});
  if (largest == 0.0) return;
  for (double& component : L) component /= largest;
  const double size = std::sqrt(L[0] * L[0] + L[1] * L[1] + L[2] * L[2]);
  for (double& component : L) component *= sink_ / size;
  add_cross(L, w, slip);
}

void EquationsOfMotion::add_torque(const double* w, const double* q, const double* slip,
                                   double* w_rate) const {
  double N[3];
  for (int i = 0; i < 3; ++i) N[i] = N_B_[i] - damping_ * w[i];
  if (depends_on_attitude_) {
    const SpaceAxes axes(q);
    for (int i = 0; i < 3; ++i)
      N[i] += N_S_[0] * axes.e[0][i] + N_S_[1] * axes.e[1][i] + N_S_[2] * axes.e[2][i];
    add_cross(axes.e[2], weight_arm_B_, N);  // arm × (−e_z) = e_z × arm
  }
  if (sink_ != 0.0) {
    const double L[3] = {I_[0] * w[0], I_[1] * w[1], I_[2] * w[2]};
    add_cross(L, slip, N);
  }
  for (int i = 0; i < 3; ++i) w_rate[i] += N[i] / I_[i];
}

}  // namespace polhode
