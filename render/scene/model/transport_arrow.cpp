// SPDX-License-Identifier: MIT
#include "render/scene/model/transport_arrow.h"

#include "physics/analysis/difference.h"
#include "physics/exact/powers_of_two.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

/// Seen by the camera of a scene that says nothing else, to the right and up.
Vec3 start_S() { return Vec3(-0.48, 0.7, 0.53).normalized(); }

double pace(const SceneModel& model) {
  const double speed = model.scene.w0_B.stableNorm();
  return speed > 0.0 ? speed : 1.0;
}

Vec3 free_arrow_S(double angle) {
  constexpr double kTurning = 0.7, kSwinging = 1.1, kSwing = 0.2;
  static const Vec3 kAxis_S = Vec3(1.0, -0.5, 0.4).normalized();
  return (1.0 + kSwing * std::sin(kSwinging * angle)) *
         (Eigen::AngleAxisd(kTurning * angle, kAxis_S) * start_S());
}

}  // namespace

Vec3 arrow_A_S(const SceneModel& model, double t_s, const Quat& q_SB) {
  switch (model.scene.arrow) {
    case ArrowHeld::in_body:
      return q_SB * (model.q0_SB.conjugate() * start_S());
    case ArrowHeld::free:
      return free_arrow_S(pace(model) * t_s);
    case ArrowHeld::in_space:
      break;
  }
  return start_S();
}

Vec3 arrow_A_S(const SceneModel& model, double t_s) {
  return arrow_A_S(model, t_s, model.motion->at(t_s).q_SB);
}

ArrowRates arrow_rates(const SceneModel& model, double t_s) {
  const RigidBodyState now = model.motion->at(t_s);
  const double h_s = kDifferenceAngle / std::max(pace(model), norm_of(now.w_B));
  const auto A_B = [&](double at_s) -> Vec3 {
    const Quat q_SB = model.motion->at(at_s).q_SB;
    return q_SB.conjugate() * arrow_A_S(model, at_s, q_SB);
  };
  const auto A_S = [&](double at_s) { return arrow_A_S(model, at_s); };
  const Vec3 A_now_S = arrow_A_S(model, t_s, now.q_SB);
  return {.A_S = A_now_S,
          .rate_S = derivative_at(A_S, t_s, h_s),
          .star_rate_S = now.q_SB * derivative_at(A_B, t_s, h_s),
          .turning_S = (now.q_SB * now.w_B).cross(A_now_S)};
}

}  // namespace polhode
