// SPDX-License-Identifier: MIT
#include "render/scene/model/drawn_marks.h"

#include "render/scene/model/model.h"
#include "tests/support/mark_vectors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using test::body_axis;
using test::mark_vector;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

Scene scene_with(Marks marks) {
  Scene scene;
  scene.w0_B = Vec3(0.4, 1.1, 1.6);
  scene.marks = std::move(marks);
  return scene;
}

const MarkVector kZero = mark_vector("zero", [](const RigidBodyState&) { return Vec3(Vec3::Zero()); });
const MarkVector kNone = mark_vector("none", [](const RigidBodyState&) {
  return Vec3(Vec3::Constant(std::numeric_limits<double>::infinity()));
});

TEST(DrawnMarks, AreFollowedOverTheDuration) {
  const Scene scene =
      scene_with({.arrows = {{.of = test::rate_of_e3()}, {.of = body_axis(2)}, {.of = kNone}}});
  const SceneModel model = make_model(scene);
  double longest = 0.0;
  for (int n = 0; n <= 64; ++n) {
    const Vec3 w_B = model.motion->w_B_at(model.span_s * n / 64);
    longest = std::max(longest, std::hypot(w_B.x(), w_B.y()));  // |ω × ê3|
  }
  EXPECT_NEAR(model.courses.at("v").longest, longest, kRounding * longest);
  EXPECT_NEAR(model.courses.at("e_3").longest, 1.0, kRounding);
  EXPECT_EQ(model.courses.at("none").longest, 0.0);
}

TEST(DrawnMarks, NeedTheWholeMotion) {
  const Requirements needs = requirements(scene_with({.notes = {{"a note", body_axis(0)}}}));
  EXPECT_TRUE(needs.marks && needs.omega && needs.attitude);
  EXPECT_FALSE(requirements(scene_with({})).marks);
  Scene turned = scene_with({.notes = {{"a note", body_axis(0)}}});
  turned.show = {Overlay::turn_orders};
  EXPECT_FALSE(requirements(turned).marks);
}

TEST(DrawnMarks, ThatShowNothingAreSaid) {
  const Marks marks{.trails = {{kZero, true}},
                    .arrows = {{.of = kZero}, {.of = body_axis(0), .at = kNone}},
                    .angles = {{body_axis(1), mark_vector("minus e2",
                                                          [](const RigidBodyState& s) {
                                                            return Vec3(s.q_SB * Vec3(0, -2, 0));
                                                          })}},
                    .areas = {{kZero, body_axis(0)}, {body_axis(0), body_axis(0)}},
                    .lines = {{body_axis(0), kNone}},
                    .planes = {{.normal = kZero}, {.normal = body_axis(0), .through = kNone}},
                    .notes = {{"lost", kNone}}};
  EXPECT_THAT(
      unseen_marks(make_model(scene_with(marks))),
      ElementsAre("the trail of \"zero\" shows nothing: \"zero\" is 0 throughout",
                  "the arrow of \"zero\" shows nothing: \"zero\" is 0 throughout",
                  "the arrow of \"e_1\" shows nothing: \"none\" has no value on this motion",
                  "the angle from \"e_2\" to \"minus e2\" shows nothing: they are parallel throughout, "
                  "or within 0.6° of it",
                  "the area from \"zero\" to \"e_1\" shows nothing: \"zero\" is 0 throughout",
                  "the area from \"e_1\" to \"e_1\" shows nothing: they are parallel throughout",
                  "the line from \"e_1\" to \"none\" shows nothing: \"none\" has no value on this motion",
                  "the plane normal to \"zero\" shows nothing: \"zero\" is 0 throughout",
                  "the plane normal to \"e_1\" shows nothing: \"none\" has no value on this motion",
                  "the note \"lost\" shows nothing: \"none\" has no value on this motion"));
  const Marks seen{.trails = {{body_axis(0), true}},
                   .arrows = {{.of = body_axis(0), .at = kZero}},
                   .angles = {{body_axis(0), body_axis(1)}},
                   .areas = {{body_axis(0), body_axis(1)}},
                   .lines = {{body_axis(0), kZero}},
                   .planes = {{.normal = body_axis(0), .through = kZero}},
                   .notes = {{"centre", kZero}}};
  EXPECT_THAT(unseen_marks(make_model(scene_with(seen))), IsEmpty()) << "the tip of 0 is the centre";
  Scene turned = scene_with(seen);
  turned.show = {Overlay::turn_orders};
  EXPECT_EQ(unseen_marks(make_model(turned)).size(), 1U);
}

TEST(DrawnPoses, AreOfABodyThatIsSeenToFly) {
  Scene scene;
  scene.poses = {.count = 4, .over_s = 1.0};
  scene.show = {Overlay::shape};
  EXPECT_FALSE(draws_poses(scene));
  EXPECT_EQ(unseen_marks(make_model(scene)).size(), 1U);
  scene.v0_S = Vec3(0, 1, 2);
  EXPECT_TRUE(draws_poses(scene));
  EXPECT_THAT(unseen_marks(make_model(scene)), IsEmpty());
  scene.views = {View::body};
  EXPECT_FALSE(draws_poses(scene));
  scene.views = {View::space};
  scene.show = {Overlay::omega};
  EXPECT_FALSE(draws_poses(scene));
}

TEST(ArcBetween, IsThatOfTheDirections) {
  EXPECT_NEAR(*arc_between(Vec3::UnitX(), Vec3(0, 7, 0)), std::numbers::pi / 2, kRounding);
  EXPECT_NEAR(*arc_between(1e300 * Vec3(1, 0, 0), 1e-300 * Vec3(1, 1, 0)), std::numbers::pi / 4, kRounding);
  EXPECT_NEAR(*arc_between(Vec3::UnitX(), Vec3(-1, 1e-3, 0)), std::numbers::pi - 1e-3, 1e-9);
  EXPECT_FALSE(arc_between(Vec3::UnitX(), Vec3::Zero()));
  EXPECT_FALSE(arc_between(Vec3::UnitX(), 3 * Vec3::UnitX()));
  EXPECT_FALSE(arc_between(Vec3::UnitX(), -Vec3::UnitX())) << "through which plane?";
  EXPECT_FALSE(arc_between(Vec3::UnitX(), Vec3(1, 1e-4, 0))) << "shorter than its line is thick";
}

}  // namespace
}  // namespace polhode
