// SPDX-License-Identifier: MIT
#include "render/scene/model/heavy_top_body.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();

/// A disc of 1 kg on an axle: moments about the pivot by Steiner's theorem.
Scene top_of(const Vec3& size_m, double l_m) {
  const Vec3 I = cylinder_moments(size_m, 1.0).vector() + Vec3(l_m * l_m, l_m * l_m, 0.0);
  Scene scene;
  scene.body = {"top", PrincipalMoments(I[0], I[1], I[2]), std::nullopt};
  scene.torque = {HeavyTop{kStandardGravity * l_m, Vec3::UnitZ()}};
  return scene;
}

TEST(HeavyTopBody, IsTheDiscThatHasTheseMomentsAboutThePivot) {
  for (const Vec3& size_m : {Vec3(0.2, 0.2, 0.02), Vec3(0.3, 0.3, 0.1)})
    for (double l_m : {0.05, 0.12}) {
      const Scene scene = top_of(size_m, l_m);
      const HeavyTopBody body = heavy_top_body(scene, *heavy_top_of(scene));
      EXPECT_EQ(body.shape.kind, ShapeKind::cylinder);
      // The height is a difference of moments: l² and d² are up to 400 h² here.
      EXPECT_LT((body.shape.size_m - size_m).norm(), 400 * kRounding * size_m.norm());
      EXPECT_LT((body.center_B - l_m * Vec3::UnitZ()).norm(), kRounding);
    }
}

TEST(HeavyTopBody, WhereNoHeightIsLeftIsThin) {
  Scene scene = top_of(Vec3(0.2, 0.2, 0.02), 0.1);
  scene.torque = {HeavyTop{1.5 * kStandardGravity * 0.1, Vec3::UnitZ()}};
  const HeavyTopBody body = heavy_top_body(scene, *heavy_top_of(scene));
  EXPECT_NEAR(body.shape.size_m.z(), 0.2 / 20, kRounding);
}

TEST(HeavyTopBody, AShapeStays) {
  Scene scene;
  scene.body = find_body("book").value();
  scene.torque = {HeavyTop{0.5, Vec3(0, 2, 0)}};
  const HeavyTopBody body = heavy_top_body(scene, *heavy_top_of(scene));
  EXPECT_EQ(body.shape.size_m, scene.body.shape->size_m);
  const Vec3 center_B(0.0, 0.5 / (0.8 * kStandardGravity), 0.0);  // l = mgr/(m g), the book has 0.8 kg
  EXPECT_LT((body.center_B - center_B).norm(), kRounding);
}

TEST(HeavyTopBody, WithoutAShapeIsTheBoxAtItsDistanceThatHasTheMoments) {
  const Vec3 size_m(0.3, 0.2, 0.1), l2(0.01, 0.0, 0.01);  // along axis 2, 10 cm
  const double mass_kg = 2.0;
  const Vec3 I = box_moments(size_m, mass_kg).vector() + mass_kg * l2;
  Scene scene;
  scene.body = {"box", PrincipalMoments(I[0], I[1], I[2]), std::nullopt, mass_kg};
  scene.torque = {HeavyTop{mass_kg * kStandardGravity * 0.1, Vec3::UnitY()}};
  const HeavyTopBody body = heavy_top_body(scene, *heavy_top_of(scene));
  EXPECT_EQ(body.shape.kind, ShapeKind::box);
  // The shortest edge is a difference of moments 26 times its square.
  EXPECT_LT((body.shape.size_m - size_m).norm(), 26 * kRounding * size_m.norm());
}

TEST(HeavyTopBody, NeedsOneHeavyTopThatWeighsSomething) {
  Scene scene;
  EXPECT_EQ(heavy_top_of(scene), nullptr);
  scene.torque = {HeavyTop{0.0, Vec3::UnitZ()}};
  EXPECT_EQ(heavy_top_of(scene), nullptr);
  scene.torque = {HeavyTop{0.5, Vec3::UnitZ()}, HeavyTop{0.5, Vec3::UnitX()}};
  EXPECT_EQ(heavy_top_of(scene), nullptr) << "which of the two?";
  scene.torque.pop_back();
  EXPECT_NE(heavy_top_of(scene), nullptr);
  scene.torque.insert(scene.torque.begin(), LinearDamping{0.1});
  ASSERT_NE(heavy_top_of(scene), nullptr) << "a top that runs down hangs on its pivot all the same";
  EXPECT_EQ(heavy_top_of(scene)->mgr, 0.5);
}

}  // namespace
}  // namespace polhode
