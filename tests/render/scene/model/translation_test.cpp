// SPDX-License-Identifier: MIT
#include "render/scene/model/translation.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Scene thrown() {
  Scene scene;
  scene.body.mass_kg = 2.5;
  scene.v0_S = Vec3(1.5, -0.4, 3.0);
  scene.F_S = Vec3(0.3, 0.2, -24.5);
  return scene;
}

TEST(Translation, StartsWithTheVelocityOfTheScene) {
  const Translation start = translation_at(thrown(), 0.0);
  EXPECT_EQ(start.r_S, Vec3::Zero());
  EXPECT_EQ(start.v_S, thrown().v0_S);
}

TEST(Translation, MomentumIsMassTimesVelocityAtAllTimes) {
  for (double t_s : {-2.0, 0.0, 0.3, 7.0}) {
    const Translation d = translation_at(thrown(), t_s);
    EXPECT_EQ(d.mass_kg, 2.5);
    EXPECT_EQ(d.p_S, Vec3(2.5 * d.v_S));
  }
}

// The motion is of second degree in t, so that central differences over any h are exact but for rounding,
// which is that of numbers of size |r| + |v|h, over h.
TEST(Translation, ObeysNewtonsLaw) {
  constexpr double h = 0.5;
  for (double t_s : {-2.0, 0.3, 7.0}) {
    const Translation before = translation_at(thrown(), t_s - h), now = translation_at(thrown(), t_s),
                      after = translation_at(thrown(), t_s + h);
    const double r_size = after.r_S.norm() + before.r_S.norm() + now.v_S.norm();
    const double p_size = after.p_S.norm() + before.p_S.norm() + now.p_S.norm();
    EXPECT_LT(((after.r_S - before.r_S) / (2 * h) - now.v_S).norm(), 16 * kEpsilon * r_size / h);
    EXPECT_LT(((after.p_S - before.p_S) / (2 * h) - now.F_S).norm(), 16 * kEpsilon * p_size / h);
  }
}

TEST(Translation, ASceneWithoutVelocityAndForceStays) {
  EXPECT_FALSE(drifts(Scene{}));
  EXPECT_EQ(translation_at(Scene{}, 3.0).r_S, Vec3::Zero());
  Scene pushed;
  pushed.F_S = Vec3(0, 0, 1);
  EXPECT_TRUE(drifts(pushed));
  EXPECT_TRUE(drifts(thrown()));
}

}  // namespace
}  // namespace polhode
