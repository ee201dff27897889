// SPDX-License-Identifier: MIT
#include "physics/body/pivot.h"

#include <cmath>

namespace polhode {

Result<Body> on_its_pivot(Body body, const Torque& torque) {
  Vec3 weight_arm_B = Vec3::Zero();
  for (const TorqueTerm& term : torque)
    if (const auto* top = std::get_if<HeavyTop>(&term)) weight_arm_B += top->mgr * top->axis_B;
  if (!body.shape || weight_arm_B.isZero(0.0)) return body;
  const std::string of_body = "the moments of \"" + body.name + "\" about the pivot: ";
  constexpr double kOnAxis = 1e-9;  // of what an author writes with nine digits
  const Vec3 l_B = weight_arm_B / (body.mass_kg * kStandardGravity);
  Eigen::Index along = 0;
  const double l_m = l_B.cwiseAbs().maxCoeff(&along);
  for (int i = 0; i < 3; ++i)
    if (i != along && std::abs(l_B[i]) > kOnAxis * l_m)
      return failure(of_body +
                     "its weight hangs on no principal axis, so that 1, 2, 3 are not principal at the pivot");
  Vec3 I = body.moments.vector();
  for (int i = 0; i < 3; ++i)
    if (i != along) I[i] += body.mass_kg * l_m * l_m;
  if (auto why = why_impossible(I[0], I[1], I[2])) return failure(of_body + *why);
  body.moments = PrincipalMoments(I[0], I[1], I[2]);
  return body;
}

}  // namespace polhode
