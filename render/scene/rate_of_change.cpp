// SPDX-License-Identifier: MIT
#include "render/scene/rate_of_change.h"

#include "render/scene/difference.h"

namespace polhode {

Vec3 w_rate_B(const Motion& motion, double t_s, double speed) {
  const auto w_B = [&](double at_s) { return motion.w_B_at(at_s); };
  return derivative_at(w_B, t_s, speed > 0.0 ? kDifferenceAngle / speed : 1.0);
}

}  // namespace polhode
