// SPDX-License-Identifier: MIT
#include "render/scene/model/turn_orders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
const Quat kSomehow = Quat(0.8, 0.1, 0.5, -0.3).normalized();

Mat3 matrix(const Quat& q) { return q.toRotationMatrix(); }

TEST(TurnOrders, EndInTheProductsOfTheQuarterTurns) {
  Mat3 Rx, Ry;
  Rx << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  Ry << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  for (const Quat& q0_SB : {Quat(Quat::Identity()), kSomehow}) {
    const Mat3 x_then_y = matrix(turned(TurnOrder::x_then_y, q0_SB, 1.0).q_SB);
    const Mat3 y_then_x = matrix(turned(TurnOrder::y_then_x, q0_SB, 1.0).q_SB);
    EXPECT_LT((x_then_y - Ry * Rx * matrix(q0_SB)).norm(), kRounding);
    EXPECT_LT((y_then_x - Rx * Ry * matrix(q0_SB)).norm(), kRounding);
    EXPECT_GT((x_then_y - y_then_x).norm(), 1.0);  // they do not commute
  }
}

TEST(TurnOrders, StartInTheAttitudeGivenAndStayAtTheEnd) {
  for (TurnOrder order : kTurnOrders) {
    for (double progress : {-3.0, 0.0})
      EXPECT_LT(turned(order, kSomehow, progress).q_SB.angularDistance(kSomehow), kRounding);
    EXPECT_LT(turned(order, kSomehow, 5.0).q_SB.angularDistance(turned(order, kSomehow, 1.0).q_SB),
              kRounding);
  }
}

TEST(TurnOrders, HalfWayOneTurnIsDone) {
  const Quat about_x(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()));
  EXPECT_LT(turned(TurnOrder::x_then_y, kSomehow, 0.5).q_SB.angularDistance(about_x * kSomehow), kRounding);
}

TEST(TurnOrders, NeverJump) {
  constexpr int kFrames = 400;
  for (TurnOrder order : kTurnOrders)
    for (int n = 0; n < kFrames; ++n) {
      const Quat now = turned(order, kSomehow, static_cast<double>(n) / kFrames).q_SB;
      const Quat next = turned(order, kSomehow, static_cast<double>(n + 1) / kFrames).q_SB;
      // Both quarters in all frames on the average; a cubic easing with rests is twice as fast at most.
      EXPECT_LT(now.angularDistance(next), 2.0 * std::numbers::pi / kFrames);
    }
}

TEST(TurnOrders, TellWhichTurnGoesOn) {
  EXPECT_EQ(turned(TurnOrder::y_then_x, kSomehow, 0.2).present.axis_S, Vec3::UnitY());
  EXPECT_EQ(turned(TurnOrder::y_then_x, kSomehow, 0.7).present.axis_S, Vec3::UnitX());
  EXPECT_NEAR(turned(TurnOrder::y_then_x, kSomehow, 1.0).present.angle_rad, 0.5 * std::numbers::pi,
              kRounding);
}

}  // namespace
}  // namespace polhode
