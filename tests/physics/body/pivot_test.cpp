// SPDX-License-Identifier: MIT
#include "physics/body/pivot.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();

TEST(OnItsPivot, AShapeHangsByItsMomentsAboutThePivot) {
  const Body disc = make_body("disc", ShapeKind::cylinder, Vec3(0.2, 0.2, 0.02), 2.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto hung = on_its_pivot(disc, {HeavyTop{2.0 * kStandardGravity * 0.1, Vec3::Unit(axis)}});
    ASSERT_TRUE(hung);
    const Vec3 steiner = 2.0 * 0.01 * (Vec3::Ones() - Vec3::Unit(axis));  // m l², but not along l
    EXPECT_LT((hung->moments.vector() - disc.moments.vector() - steiner).norm(), kRounding);
    EXPECT_EQ(hung->shape, disc.shape);
  }
}

TEST(OnItsPivot, WhatHangsNowhereKeepsItsMoments) {
  const Body disc = make_body("disc", ShapeKind::cylinder, Vec3(0.2, 0.2, 0.02), 2.0);
  EXPECT_EQ(*on_its_pivot(disc, {}), disc);
  EXPECT_EQ(*on_its_pivot(disc, {SpaceTorque{Vec3(1, 2, 3)}, LinearDamping{0.1}}), disc);
  const Body textbook = find_body("textbook").value();
  EXPECT_EQ(*on_its_pivot(textbook, {HeavyTop{1.0, Vec3::UnitZ()}}), textbook) << "about the pivot as given";
  const auto askew = on_its_pivot(disc, {HeavyTop{1.0, Vec3(0.6, 0.8, 0)}});
  ASSERT_FALSE(askew);
  EXPECT_EQ(askew.error(),
            "the moments of \"disc\" about the pivot: its weight hangs on no principal axis, so that 1, 2, 3 "
            "are not principal at the pivot");
  const auto far = on_its_pivot(disc, {HeavyTop{1e300, Vec3::UnitX()}});
  ASSERT_FALSE(far);
  EXPECT_EQ(
      far.error(),
      "the moments of \"disc\" about the pivot: I2 = inf is not finite: no rigid body has these moments");
}

TEST(WeightAt, HangsOppositeToThePivot) {
  const HeavyTop top = weight_at(2.0, Vec3(0, -0.1, 0));
  EXPECT_NEAR(top.mgr, 2.0 * kStandardGravity * 0.1, kRounding);
  EXPECT_EQ(top.axis_B, Vec3::UnitY());
  for (double l_m : {1e-300, 1e-12, 1e200}) EXPECT_EQ(weight_at(1.0, Vec3(l_m, 0, 0)).axis_B, -Vec3::UnitX());
  EXPECT_LT((center_from_pivot_B(2.0, {LinearDamping{1}, top}) - Vec3(0, 0.1, 0)).norm(), kRounding);
  EXPECT_EQ(center_from_pivot_B(2.0, {}), Vec3::Zero());
}

TEST(AboutPivot, MovesTheMomentsOfAnyBody) {
  const Body plate{"plate", PrincipalMoments(1.0, 2.0, 2.9), std::nullopt, 3.0};
  const auto held = about_pivot(plate, {weight_at(3.0, Vec3(-0.5, 0, 0))});
  ASSERT_TRUE(held);
  EXPECT_LT((held->moments.vector() - Vec3(1.0, 2.75, 3.65)).norm(), kRounding);  // m l² = 3/4
  EXPECT_EQ(*about_pivot(plate, {}), plate);
}

}  // namespace
}  // namespace polhode
