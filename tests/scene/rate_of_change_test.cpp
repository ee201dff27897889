// SPDX-License-Identifier: MIT
#include "render/scene/rate_of_change.h"

#include "physics/euler.h"
#include "physics/method.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

const PrincipalMoments kI(1.0, 1.75, 2.5);

TEST(RateOfChange, IsWhatEulersEquationsGive) {
  for (double speed : {1e-6, 1.0, 1e5}) {
    const Problem problem{kI, {Quat::Identity(), speed * Vec3(0.6, 0.5, 0.62)}, {}};
    const auto motion = make_motion(problem, {});
    for (double turns : {-3.0, 0.0, 0.4, 12.0}) {
      const double t_s = turns / speed;
      const Vec3 expected = angular_acceleration_B(kI, motion->w_B_at(t_s));
      // truncation and rounding, as the header has them, times 1000 for f⁽⁷⁾ of this body and its closed form
      EXPECT_LT((w_rate_B(*motion, t_s, speed) - expected).norm(), 1e-11 * speed * speed) << t_s;
    }
  }
}

TEST(RateOfChange, OfABodyAtRestIsZero) {
  const auto motion = make_motion({kI, {Quat::Identity(), Vec3::Zero()}, {}}, {});
  EXPECT_EQ(w_rate_B(*motion, 1.0, 0.0), Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace polhode
