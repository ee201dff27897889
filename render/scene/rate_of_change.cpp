// SPDX-License-Identifier: MIT
#include "render/scene/rate_of_change.h"

namespace polhode {

Vec3 w_rate_B(const Motion& motion, double t_s, double speed) {
  constexpr double kStep = 0.002;  // rad
  const double h_s = speed > 0.0 ? kStep / speed : 1.0;
  const Vec3 near_B = motion.w_B_at(t_s + h_s) - motion.w_B_at(t_s - h_s);
  const Vec3 far_B = motion.w_B_at(t_s + 2.0 * h_s) - motion.w_B_at(t_s - 2.0 * h_s);
  return (8.0 * near_B - far_B) / (12.0 * h_s);
}

}  // namespace polhode
