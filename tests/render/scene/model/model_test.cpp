// SPDX-License-Identifier: MIT
#include "render/scene/model/model.h"

#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace polhode {
namespace {

using O = Overlay;
using testing::HasSubstr;
using testing::Not;

Scene scene_with(OverlaySet show, std::vector<View> views = {View::space}) {
  Scene scene;
  scene.w0_B = Vec3(0.2, 1.1, 1.6);
  scene.show = show;
  scene.views = std::move(views);
  return scene;
}

TEST(Requirements, TheBodyViewOfAFreeBodyNeedsNoAttitude) {
  const Requirements needs =
      requirements(scene_with({O::energy_ellipsoid, O::omega, O::L, O::polhode}, {View::body}));
  EXPECT_TRUE(needs.omega);
  EXPECT_FALSE(needs.attitude);
}

TEST(Requirements, SpaceAxesInTheBodyViewNeedAttitude) {
  EXPECT_TRUE(requirements(scene_with({O::axes_space}, {View::body})).attitude);
}

TEST(Requirements, SpaceAxesInTheSpaceViewNeedNothing) {
  EXPECT_EQ(requirements(scene_with({O::axes_space})), Requirements{});
}

TEST(Requirements, NumbersNeedTheMotionAndNothingThatIsDrawn) {
  const Scene scene = scene_with({O::polhode, O::shape, O::method_table}, {View::body});
  EXPECT_EQ(requirements(scene, ModelFor::numbers), (Requirements{.omega = true, .attitude = true}));
}

TEST(Requirements, ATorqueThatDependsOnAttitudeNeedsIt) {
  Scene scene = scene_with({O::omega}, {View::body});
  scene.torque = {SpaceTorque{Vec3(1, 0, 0)}};
  EXPECT_TRUE(requirements(scene).attitude);
  scene.torque = {BodyTorque{Vec3(1, 0, 0)}};
  EXPECT_FALSE(requirements(scene).attitude);
}

TEST(Requirements, TheHerpolhodeLivesInSpaceOnly) {
  EXPECT_TRUE(requirements(scene_with({O::herpolhode})).herpolhode);
  EXPECT_FALSE(requirements(scene_with({O::herpolhode}, {View::body})).herpolhode);
}

TEST(Requirements, WhatPlotsNeedIsOfPagesAlone) {
  Scene scene = scene_with({O::energy_ellipsoid, O::omega}, {View::body});
  const Requirements figure = requirements(scene);
  EXPECT_FALSE(figure.meters);
  EXPECT_FALSE(figure.attitude);
  scene.meters = std::vector<PlotSpec>{Meter::omega, Meter::energy, Meter::momentum};
  EXPECT_TRUE(requirements(scene, ModelFor::page).meters);
  EXPECT_FALSE(requirements(scene, ModelFor::page).attitude) << "|L| is that of the body's frame";
  scene.meters.emplace_back(Meter::drift);
  EXPECT_TRUE(requirements(scene, ModelFor::page).attitude);
  EXPECT_EQ(requirements(scene), figure);
  scene.meters = std::vector<PlotSpec>{Meter::momentum};
  scene.torque = {BodyTorque{Vec3(1, 0, 0)}};
  EXPECT_TRUE(requirements(scene, ModelFor::page).attitude) << "under torque L has components in space";
  scene.meters = std::vector<PlotSpec>{};
  EXPECT_EQ(requirements(scene, ModelFor::page), requirements(scene));
}

TEST(Requirements, NamesAreThoseThatAreNeeded) {
  Requirements needs;
  needs.omega = needs.herpolhode = true;
  EXPECT_EQ(names_of(needs), (std::vector<std::string>{"omega", "herpolhode"}));
}

/// Numbers a model holds: the memory, and with it the work, of the parts that overlays ask for.
std::size_t points_of(const SceneModel& model) {
  std::size_t n = model.polhode_B.points.size() + model.herpolhode_S.points.size();
  for (const PolhodeOfFamily& member : model.family_B)
    for (const Curve& branch : member.branches) n += branch.points.size();
  for (const Curve& ellipse : model.separatrices_B) n += ellipse.points.size();
  return n;
}

class RemovedOverlay : public testing::TestWithParam<Overlay> {};

TEST_P(RemovedOverlay, CostsNothing) {
  const OverlaySet all{O::energy_ellipsoid, O::omega,      O::L,     O::polhode, O::polhode_family,
                       O::separatrix,       O::herpolhode, O::plane, O::shape,   O::rolling_ticks};
  OverlaySet fewer = all;
  fewer.erase(GetParam());
  const SceneModel full = make_model(scene_with(all)), less = make_model(scene_with(fewer));
  EXPECT_EQ(names_of(less.needs).size() + 1, names_of(full.needs).size());
  EXPECT_TRUE(GetParam() == O::shape || GetParam() == O::rolling_ticks || points_of(less) < points_of(full));
}

INSTANTIATE_TEST_SUITE_P(Each, RemovedOverlay,
                         testing::Values(O::polhode, O::polhode_family, O::separatrix, O::herpolhode,
                                         O::shape, O::rolling_ticks),
                         [](const auto& row) {
                           std::string name(name_of(row.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Model, ChoosesTheCheapestMotionThatServes) {
  Scene scene = scene_with({O::omega});
  EXPECT_EQ(make_model(scene).motion->method(), "exact");
  scene.w0_B = Vec3(0, 0, 2);
  EXPECT_EQ(make_model(scene).motion->method(), "uniform");
  scene.w0_B = Vec3(1, 0, 2);
  scene.body = find_body("disc").value();
  EXPECT_EQ(make_model(scene).motion->method(), "symmetric");
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_EQ(make_model(scene).motion->method(), "dormand-prince-8");
}

TEST(Model, SaysWhyItChose) {
  Scene scene = scene_with({O::omega}, {View::body});
  EXPECT_THAT(make_model(scene).why, HasSubstr("no overlay asks for attitude"));
  scene.motion = {.method = Method::rk4, .step_s = 0.01};
  EXPECT_THAT(make_model(scene).why, HasSubstr("asks for it"));
  scene.motion = {};
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_THAT(make_model(scene).why, HasSubstr("torque acts"));
}

TEST(Model, RefusesAMethodThatCannotServe) {
  Scene scene = scene_with({O::omega});
  scene.motion.method = Method::symmetric;
  EXPECT_THROW(make_model(scene), std::domain_error);
  scene.motion.method = Method::uniform;
  EXPECT_THROW(make_model(scene), std::domain_error);
  scene.w0_B = Vec3(0, 2, 0);
  EXPECT_NO_THROW(make_model(scene));
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_THROW(make_model(scene), std::domain_error);
  scene.motion.method = Method::exact;
  try {
    make_model(scene);
    FAIL() << "a closed form under a torque";
  } catch (const std::domain_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("what can: explicit-euler"));
  }
}

TEST(Model, TakesTheToleranceOfItsScene) {
  Scene scene = scene_with({O::omega});
  scene.motion = {.method = Method::dormand_prince_5, .tolerance = 1e-6};
  EXPECT_EQ(make_model(scene).motion->method(), "dormand-prince-5");
  scene.motion.tolerance = -1.0;
  EXPECT_THROW(make_model(scene), std::domain_error);
  scene.motion = {.tolerance = 1e-6};  // the default, exact, has none
  EXPECT_THROW(make_model(scene), std::domain_error);
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_NO_THROW(make_model(scene));
}

TEST(Model, RefusesATimeThatItsMethodCannotReach) {
  Scene scene = scene_with({O::omega});
  scene.motion = {.method = Method::rk4, .step_s = 1e-9};
  scene.at_s = 1.0;  // 10⁹ steps
  EXPECT_THROW(make_model(scene), std::domain_error);
}

TEST(Model, RefusesCurvesThatTakeTooManySteps) {  // 2026-11-21: lint hung on such a duration
  Scene scene = scene_with({O::herpolhode});
  scene.duration_s = 1e9;
  EXPECT_THROW(make_model(scene), std::domain_error);
  EXPECT_THROW(check_scene(scene), std::domain_error);
  scene.show = {O::omega};
  EXPECT_NO_THROW(make_model(scene));
}

const OverlaySet kCurves = {O::polhode, O::polhode_family, O::separatrix, O::herpolhode, O::cones};

TEST(Model, OfNearlyEqualMomentsHasItsCurves) {  // 2026-11-22: gaps of 2e-16 to 1e-15 were refused
  for (int ulps = 0; ulps < 16; ++ulps) {
    const double middle = 1.0 + ulps * std::numeric_limits<double>::epsilon();
    for (const PrincipalMoments& I : {PrincipalMoments(1.0, middle, 1.5), PrincipalMoments(0.6, middle, 1.0),
                                      PrincipalMoments(1.0, 1.0, middle)}) {
      Scene scene = scene_with(kCurves, {View::space, View::body});
      scene.body.moments = I;
      scene.duration_s = 20;  // a period of what is nearly a sphere has 1e16 turns
      SceneModel model;
      ASSERT_NO_THROW(model = make_model(scene)) << ulps;
      EXPECT_FALSE(model.polhode_B.points.empty()) << ulps;
      for (const PolhodeOfFamily& member : model.family_B) {
        EXPECT_GT(member.L2_over_2T, I.vector().minCoeff());
        EXPECT_LT(member.L2_over_2T, I.vector().maxCoeff());
      }
    }
  }
}

TEST(Model, OfAnyAngularVelocityHasTheSameCurvesToTheBit) {
  Scene scene = scene_with(kCurves, {View::space, View::body});
  const SceneModel plain = make_model(scene);
  for (const int e : {-900, -600, 500, 900}) {
    scene.w0_B = times_two_to(e, plain.scene.w0_B);
    const SceneModel fast = make_model(scene);
    const auto expect_same = [e](const Curve& is, const Curve& slow) {
      ASSERT_EQ(is.points.size(), slow.points.size()) << e;
      for (std::size_t i = 0; i < slow.points.size(); ++i)
        EXPECT_EQ(is.points[i], times_two_to(e, slow.points[i])) << e;
    };
    expect_same(fast.polhode_B, plain.polhode_B);
    expect_same(fast.herpolhode_S, plain.herpolhode_S);
    ASSERT_EQ(fast.family_B.size(), plain.family_B.size());
    for (std::size_t i = 0; i < plain.family_B.size(); ++i)
      expect_same(fast.family_B[i].branches[0], plain.family_B[i].branches[0]);
    ASSERT_EQ(fast.separatrices_B.size(), 2u);
    expect_same(fast.separatrices_B[1], plain.separatrices_B[1]);
  }
}

std::string refusal_of(const Scene& scene) {
  try {
    check_scene(scene);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "";
}

TEST(Model, RefusesNumbersThatNoDoubleHolds) {
  Scene scene = scene_with({O::omega, O::polhode});
  scene.w0_B = Vec3(1e300, 1e300, 1e300);
  EXPECT_EQ(refusal_of(scene), "");
  scene.show.insert(O::values);  // T in joules
  EXPECT_THAT(refusal_of(scene), HasSubstr("kinetic energy exceeds"));
  scene.show = {O::omega};
  scene.body.moments = PrincipalMoments(1e10, 1e10, 1.5e10);
  EXPECT_THAT(refusal_of(scene), HasSubstr("angular momentum exceeds"));
}

TEST(Model, RefusesHopelessStepsByTolerance) {  // 2026-11-22: 22 s, paid again by every part of lint
  Scene scene = scene_with({O::omega});
  scene.torque = {HeavyTop{1e3, Vec3::UnitZ()}};
  scene.duration_s = 1e6;
  scene.meters = {Meter::omega};
  EXPECT_THAT(refusal_of(scene), HasSubstr("takes more than 2000000 steps to get there"));
  scene.duration_s = 10;
  EXPECT_EQ(refusal_of(scene), "");
  scene.at_s = 1e7;
  EXPECT_THAT(refusal_of(scene), HasSubstr("the motion cannot be computed at t = "));
}

TEST(Model, RefusesAMotionWithoutAStateAtItsTimes) {  // 2026-11-22: only export found that
  Scene scene = scene_with({O::omega});
  scene.motion = {.method = Method::explicit_euler, .step_s = 0.01};
  scene.at_s = 1e4;
  EXPECT_THAT(refusal_of(scene), testing::AllOf(HasSubstr("cannot be computed at t = 10000"),
                                                HasSubstr("step is too long"), Not(HasSubstr("torque"))));
  scene.at_s = 1;
  EXPECT_EQ(refusal_of(scene), "");
  scene.still_s = 1e4;
  EXPECT_THAT(refusal_of(scene), HasSubstr("cannot be computed at t = 10000"));
}

TEST(Model, TellsWhatItCosts) {
  Scene scene = scene_with({O::omega, O::herpolhode});
  std::int64_t told = 0;
  const Effort effort = [&](std::int64_t n) { told += n; };
  const SceneModel closed = make_model(scene, ModelFor::figure, effort);
  EXPECT_GE(told, static_cast<std::int64_t>(closed.herpolhode_S.points.size()));
  scene.show = {O::method_table};
  scene.at_s = 5;
  told = 0;
  static_cast<void>(make_model(scene, ModelFor::figure, effort));
  EXPECT_GT(told, 1000);
  Budget budget(1000);
  EXPECT_THROW(make_model(scene, ModelFor::figure, budget.effort()), BudgetSpent);
}

TEST(DrawnOverlays, LeaveOutWhatThereIsNothingToSeeOf) {
  Scene scene = scene_with({O::plane, O::herpolhode, O::polhode, O::N, O::omega, O::cones});
  EXPECT_EQ(drawn_overlays(scene), (OverlaySet{O::plane, O::herpolhode, O::polhode, O::omega, O::cones}));
  scene.views = {View::body};
  EXPECT_EQ(drawn_overlays(scene), (OverlaySet{O::polhode, O::omega, O::cones}));
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_EQ(drawn_overlays(scene), (OverlaySet{O::N, O::omega}));
  scene = scene_with({O::plane, O::omega, O::shape});
  scene.attitude = LPoints::up;
  EXPECT_EQ(drawn_overlays(scene), (OverlaySet{O::omega, O::shape}));
  scene.w0_B.setZero();
  EXPECT_EQ(drawn_overlays(scene), OverlaySet{O::shape});
}

TEST(Model, LPointsWhereTheSceneSays) {
  const double eps = 4 * std::numeric_limits<double>::epsilon();
  for (const Vec3& w0_B :
       {Vec3(0.2, 1.1, 1.6), Vec3(0, 0, 2), Vec3(0, 0, -2), Vec3(1, 0, 0), Vec3(-1, -2, -3)})
    for (LPoints points : {LPoints::down, LPoints::up}) {
      Scene scene = scene_with({O::omega});
      scene.w0_B = w0_B;
      scene.attitude = points;
      const Vec3 L_S = angular_momentum_S(scene.body.moments, {make_model(scene).q0_SB, w0_B}).normalized();
      EXPECT_NEAR(L_S.z(), points == LPoints::down ? -1.0 : 1.0, eps) << w0_B.transpose();
    }
}

TEST(Model, LPointsDownWithAPlaneAndUpWithout) {
  const auto L_z = [](OverlaySet show) {
    const Scene scene = scene_with(show);
    return angular_momentum_S(scene.body.moments, {make_model(scene).q0_SB, scene.w0_B}).z();
  };
  EXPECT_LT(L_z({O::omega, O::plane}), 0.0);
  EXPECT_GT(L_z({O::omega}), 0.0);
}

TEST(Model, AnEmptySceneIsAModelToo) {
  Scene scene = scene_with({});
  scene.w0_B.setZero();
  const SceneModel model = make_model(scene);
  EXPECT_EQ(points_of(model), 0U);
  EXPECT_EQ(model.motion->method(), "uniform");
}

TEST(WhatIsUnseen, SaysWhy) {
  Scene scene = scene_with({O::polhode, O::cones, O::N, O::herpolhode, O::plane});
  EXPECT_EQ(what_is_unseen(O::polhode, scene), "");
  EXPECT_EQ(what_is_unseen(O::cones, scene), "");
  EXPECT_EQ(what_is_unseen(O::N, scene), "shows nothing: no torque acts");
  Scene german = scene;
  german.language = Language::de;
  EXPECT_EQ(what_is_unseen(O::N, german), "zeigt nichts: kein Drehmoment wirkt");
  EXPECT_EQ(what_is_unseen(O::p, scene),
            "shows nothing: the centre of mass is at rest: there is no velocity or force");
  EXPECT_EQ(what_is_unseen(O::pivot, scene), "shows nothing: the torque is not that of one heavy top");
  scene.views = {View::body};
  EXPECT_EQ(what_is_unseen(O::herpolhode, scene), "shows nothing: it is seen from space only");
  EXPECT_EQ(what_is_unseen(O::cones, scene), "") << "the body cone is seen in the body";
  scene.torque = {LinearDamping{0.1}};
  for (const O overlay : {O::polhode, O::herpolhode, O::cones, O::plane})
    EXPECT_EQ(what_is_unseen(overlay, scene),
              "shows nothing: it belongs to motion without torque, and a torque acts");
}

TEST(WhatIsUnseen, IsWhatIsNotDrawn) {
  const std::vector<View> space{View::space}, body{View::body};
  for (const auto& views : {space, body})
    for (const bool torque : {false, true})
      for (const bool rest : {false, true})
        for (int i = 0; i < kOverlayCount; ++i) {
          const auto overlay = static_cast<O>(i);
          Scene scene = scene_with({overlay}, views);
          if (torque) scene.torque = {LinearDamping{0.1}};
          if (rest) scene.w0_B = Vec3::Zero();
          EXPECT_EQ(what_is_unseen(overlay, scene).empty(), drawn_overlays(scene).contains(overlay))
              << name_of(overlay);
        }
}

}  // namespace
}  // namespace polhode
