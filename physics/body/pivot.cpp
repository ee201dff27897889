// SPDX-License-Identifier: MIT
#include "physics/body/pivot.h"

#include "physics/exact/powers_of_two.h"

#include <cmath>
#include <utility>

namespace polhode {

HeavyTop weight_at(double mass_kg, const Vec3& pivot_B) {
  const Vec3 direction =
      times_two_to(-exponent_of(pivot_B), pivot_B);  // its length is in the range of numbers
  return {mass_kg * kStandardGravity * norm_of(pivot_B), Vec3::Zero() - direction.normalized()};
}

Vec3 center_from_pivot_B(double mass_kg, const Torque& torque) {
  Vec3 weight_arm_B = Vec3::Zero();
  for (const TorqueTerm& term : torque)
    if (const auto* top = std::get_if<HeavyTop>(&term)) weight_arm_B += top->mgr * top->axis_B;
  return weight_arm_B / (mass_kg * kStandardGravity);
}

Result<Body> about_pivot(Body body, const Torque& torque) {
  const Vec3 l_B = center_from_pivot_B(body.mass_kg, torque);
  if (l_B.isZero(0.0)) return body;
  const std::string of_body = "the moments of \"" + body.name + "\" about the pivot: ";
  constexpr double kOnAxis = 1e-9;  // of what an author writes with nine digits
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

Result<Body> on_its_pivot(Body body, const Torque& torque) {
  return body.shape ? about_pivot(std::move(body), torque) : Result<Body>(std::move(body));
}

}  // namespace polhode
