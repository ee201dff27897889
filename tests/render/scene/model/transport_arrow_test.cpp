// SPDX-License-Identifier: MIT
#include "render/scene/model/transport_arrow.h"

#include "physics/analysis/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Of rates of A: nothing changes faster than at three times |ω|; twice the rounding of unit numbers over h.
const double kDifferenceError =
    std::pow(3 * kDifferenceAngle, 6) / 140 * 3 + 64 * kEpsilon / kDifferenceAngle;

Scene scene_with(ArrowHeld held) {
  Scene scene;
  scene.w0_B = Vec3(0.7, 0.4, 1.1);
  scene.show = {Overlay::transport};
  scene.arrow = held;
  return scene;
}

class EveryArrow : public testing::TestWithParam<ArrowHeld> {};

TEST_P(EveryArrow, ClosesTheTriangle) {
  Scene driven = scene_with(GetParam());
  driven.torque = {SpaceTorque{Vec3(0.3, -0.2, 0.1)}};
  // The attitude of DP8 between its steps is as exact as its tolerance, and a difference divides that by h.
  const double kOfTolerance = 4 * kDefaultTolerance / kDifferenceAngle;
  for (const auto& [scene, tolerance] :
       {std::pair{scene_with(GetParam()), kDifferenceError}, {driven, kOfTolerance}}) {
    const SceneModel model = make_model(scene);
    for (double t_s : {0.0, 0.6, 2.3, 9.1}) {
      const ArrowRates rates = arrow_rates(model, t_s);
      const double speed = model.motion->w_B_at(t_s).norm();
      EXPECT_LT((rates.star_rate_S + rates.turning_S - rates.rate_S).norm(), tolerance * speed) << t_s;
      EXPECT_EQ(rates.A_S, arrow_A_S(model, t_s));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Held, EveryArrow,
                         testing::Values(ArrowHeld::in_space, ArrowHeld::in_body, ArrowHeld::free));

TEST(Arrow, AllStartAlike) {
  const Vec3 start_S = arrow_A_S(make_model(scene_with(ArrowHeld::in_space)), 0.0);
  EXPECT_NEAR(start_S.norm(), 1.0, 4 * kEpsilon);
  for (ArrowHeld held : {ArrowHeld::in_body, ArrowHeld::free})
    EXPECT_LT((arrow_A_S(make_model(scene_with(held)), 0.0) - start_S).norm(), 8 * kEpsilon);
}

TEST(Arrow, RestsWhereItIsHeldAndMovesElsewhere) {
  const ArrowRates in_space = arrow_rates(make_model(scene_with(ArrowHeld::in_space)), 0.8);
  EXPECT_EQ(in_space.rate_S, Vec3::Zero());
  EXPECT_GT(in_space.star_rate_S.norm(), 0.3);
  const ArrowRates in_body = arrow_rates(make_model(scene_with(ArrowHeld::in_body)), 0.8);
  EXPECT_LT(in_body.star_rate_S.norm(), 64 * kEpsilon / kDifferenceAngle);
  EXPECT_GT(in_body.rate_S.norm(), 0.3);
  const ArrowRates free = arrow_rates(make_model(scene_with(ArrowHeld::free)), 0.8);
  EXPECT_GT(free.star_rate_S.norm(), 0.1);
  EXPECT_GT(free.rate_S.norm(), 0.1);
}

}  // namespace
}  // namespace polhode
