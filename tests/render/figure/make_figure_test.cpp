// SPDX-License-Identifier: MIT
#include "render/figure/make_figure.h"

#include "physics/body/euler.h"
#include "render/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

using O = Overlay;

/// RK4 at 2000 steps a period errs by some 1e-11 of a turn in the first periods; scene units are of order 1.
constexpr double kMotionTolerance = 1e-9;

Scene poinsot_scene() {
  Scene scene;
  scene.w0_B = Vec3(0.2, 1.1, 1.6);
  scene.show = {O::energy_ellipsoid, O::omega, O::L, O::polhode, O::herpolhode, O::plane, O::labels};
  return scene;
}

const Arrow& arrow_of(const DrawList& list, const Role& role) {
  for (const Arrow& arrow : list.arrows)
    if (arrow.color == role.paint) return arrow;
  throw std::runtime_error("no such arrow");
}

const Tube& tube_of(const DrawList& list, const Role& role) {
  for (const Tube& tube : list.tubes)
    if (tube.color == role.paint) return tube;
  throw std::runtime_error("no such tube");
}

double on_ellipsoid(const GlassEllipsoid& e, const Vec3& p) {
  return (e.rotation.conjugate() * (p - e.center)).cwiseQuotient(e.semi_axes).squaredNorm();
}

TEST(Figure, OmegasTipLiesOnTheEllipsoidAndOnThePlane) {
  const SceneModel model = make_model(poinsot_scene());
  for (double t_s : {0.0, 0.4, 1.3, 7.7}) {
    const DrawList list = make_figure(model, t_s, 16.0 / 9.0).panes[0].list;
    const Vec3 tip = arrow_of(list, kOmegaRole).tip;
    ASSERT_EQ(list.ellipsoids.size(), 1U);
    ASSERT_EQ(list.floors.size(), 1U);
    EXPECT_NEAR(on_ellipsoid(list.ellipsoids[0], tip), 1.0, kMotionTolerance);
    EXPECT_NEAR(tip.z(), list.floors[0].z, kMotionTolerance);
  }
}

TEST(Figure, ThePlaneTouchesTheEllipsoidThere) {
  const SceneModel model = make_model(poinsot_scene());
  const DrawList list = make_figure(model, 2.1, 1.5).panes[0].list;
  const GlassEllipsoid& e = list.ellipsoids[0];
  const Vec3 tip = arrow_of(list, kOmegaRole).tip;
  const Vec3 own = e.rotation.conjugate() * tip;
  const Vec3 normal = (e.rotation * Vec3(own.cwiseQuotient(e.semi_axes.cwiseAbs2()))).normalized();
  EXPECT_NEAR(normal.z(), -1.0, kMotionTolerance);
}

TEST(Figure, TheCurvesPassThroughOmegasTip) {
  const SceneModel model = make_model(poinsot_scene());
  const DrawList list = make_figure(model, 1.9, 1.5).panes[0].list;
  const Vec3 tip = arrow_of(list, kOmegaRole).tip;
  const auto distance = [](const Tube& tube, const Vec3& point) {
    double nearest = 1e9;
    for (std::size_t i = 0; i + (tube.closed ? 0 : 1) < tube.points.size(); ++i) {
      const Vec3 &a = tube.points[i], &b = tube.points[(i + 1) % tube.points.size()];
      const double f = std::clamp((point - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
      nearest = std::min(nearest, (a + f * (b - a) - point).norm());
    }
    return nearest;
  };
  constexpr double kChord = kChordTolerance;  // scene units: the largest semi-axis is one
  EXPECT_LT(distance(tube_of(list, kPolhodeRole), tip), kChord + kMotionTolerance);
  const Tube& herpolhode = tube_of(list, kHerpolhodeRole);
  const Vec3 on_plane =
      tip + Vec3(0, 0, herpolhode.radius);  // where the tube's middle is: it lies on the plane
  EXPECT_LT(distance(herpolhode, on_plane), kChord + kMotionTolerance);
}

/// Bars of two points in a colour, or black as the long ones are: middle, and from end to end.
struct Bar {
  Vec3 middle, along;
  double radius;
};
std::vector<Bar> ticks_of(const DrawList& list, const Role& role) {
  std::vector<Bar> ticks;
  for (const Tube& tube : list.tubes)
    if ((tube.color == role.paint || tube.color == kTRole.paint) && tube.points.size() == 2)
      ticks.push_back(
          {0.5 * (tube.points[0] + tube.points[1]), tube.points[1] - tube.points[0], tube.radius});
  return ticks;
}

TEST(Figure, TheContactHasADotOnThePlane) {
  const SceneModel model = make_model(poinsot_scene());
  for (const double t_s : {0.0, 1.7}) {
    const DrawList list = make_figure(model, t_s, 1.5).panes[0].list;
    const Vec3 tip = arrow_of(list, kOmegaRole).tip;
    EXPECT_TRUE(std::any_of(list.balls.begin(), list.balls.end(), [&](const Ball& ball) {
      return (ball.center - Vec3(0, 0, ball.radius) - tip).norm() < kMotionTolerance;
    }));
  }
}

// Rolling without slipping, seen: ticks of the polhode are carried onto those of the herpolhode, which rest.
TEST(Figure, TicksOfThePolhodeMeetThoseOfTheHerpolhodeInTheContact) {
  Scene scene = poinsot_scene();
  scene.show.insert(O::rolling_ticks);
  scene.at_s = 1.3;
  const SceneModel model = make_model(scene);
  ASSERT_EQ(model.ticks.times_s.size(), static_cast<std::size_t>(kRollingTicks));
  const DrawList still = make_figure(model, scene.at_s, 1.5).panes[0].list;
  const std::vector<Bar> on_plane = ticks_of(still, kHerpolhodeRole);
  EXPECT_GE(ticks_of(still, kPolhodeRole).size(), static_cast<std::size_t>(kRollingTicks));
  ASSERT_GT(on_plane.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    const double t_s = model.ticks.times_s[k];
    const DrawList list = make_figure(model, t_s, 1.5).panes[0].list;
    const Vec3 tip = arrow_of(list, kOmegaRole).tip;
    const auto meets = [&](const Bar& bar, double radii) {
      return (bar.middle - tip - Vec3(0, 0, radii * bar.radius)).norm() < kMotionTolerance;
    };
    const std::vector<Bar> rolling = ticks_of(list, kPolhodeRole);
    const auto own = std::find_if(rolling.begin(), rolling.end(), [&](const Bar& b) { return meets(b, 0); });
    const auto laid =
        std::find_if(on_plane.begin(), on_plane.end(), [&](const Bar& b) { return meets(b, 1); });
    ASSERT_NE(own, rolling.end()) << k;
    ASSERT_NE(laid, on_plane.end()) << k << ": it was there before";
    EXPECT_LT((own->along - laid->along).norm(), kMotionTolerance) << "one lies on the other";
    EXPECT_NEAR(laid->along.z(), 0.0, kMotionTolerance) << "in the plane";
  }
}

TEST(Figure, TicksStandWhereThereIsAPeriodAlone) {
  Scene scene = poinsot_scene();
  scene.show.insert(O::rolling_ticks);
  scene.w0_B = Vec3(0, 0, 2);
  EXPECT_TRUE(make_model(scene).ticks.times_s.empty()) << "steady rotation";
  EXPECT_TRUE(ticks_of(make_figure(make_model(scene), 0.3, 1.5).panes[0].list, kPolhodeRole).empty());
}

TEST(Figure, DependsOnTheModelAndTheTimeAlone) {
  const SceneModel model = make_model(poinsot_scene());
  const Vec3 first = arrow_of(make_figure(model, 3.0, 1.5).panes[0].list, kOmegaRole).tip;
  for (double t_s : {-2.0, 50.0, 0.1}) make_figure(model, t_s, 1.5);
  EXPECT_EQ(arrow_of(make_figure(model, 3.0, 1.5).panes[0].list, kOmegaRole).tip, first);
  EXPECT_EQ(arrow_of(make_figure(make_model(poinsot_scene()), 3.0, 1.5).panes[0].list, kOmegaRole).tip,
            first);
}

TEST(Figure, BothViewsShowTheSameVectorsTurnedByTheAttitude) {
  Scene scene = poinsot_scene();
  scene.views = {View::space, View::body};
  const SceneModel model = make_model(scene);
  const double t_s = 1.234;
  const Figure figure = make_figure(model, t_s, 2.0);
  ASSERT_EQ(figure.panes.size(), 2U);
  const Quat q_SB = model.motion->at(t_s).q_SB;
  for (const Role& role : {kOmegaRole, kLRole}) {
    const Vec3 in_space = arrow_of(figure.panes[0].list, role).tip,
               in_body = arrow_of(figure.panes[1].list, role).tip;
    EXPECT_LT((in_space - q_SB * in_body).norm(), 1e-14);
  }
}

TEST(Figure, TurningTheStartAboutTheVerticalTurnsThePicture) {
  Scene scene = poinsot_scene();
  const SceneModel model = make_model(scene);
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  Scene turned = scene;
  turned.attitude = turn * model.q0_SB;
  const Vec3 tip = arrow_of(make_figure(model, 1.1, 1.5).panes[0].list, kOmegaRole).tip;
  const Vec3 turned_tip = arrow_of(make_figure(make_model(turned), 1.1, 1.5).panes[0].list, kOmegaRole).tip;
  EXPECT_LT((turned_tip - turn * tip).norm(), 1e-13);
}

TEST(Figure, ThePlaneIsNotDrawnWhereItIsNotInvariable) {
  Scene scene = poinsot_scene();
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_TRUE(make_figure(make_model(scene), 0.5, 1.5).panes[0].list.floors.empty());
}

TEST(Figure, AMethodThatDoesNotKeepTheEnergyLeavesTheSurfaces) {  // 2026-11-22: they swelled with it
  Scene scene = poinsot_scene();
  scene.motion = {.method = Method::explicit_euler, .step_s = 0.1};
  scene.show = {O::energy_ellipsoid, O::momentum_sphere, O::omega};
  const SceneModel model = make_model(scene);
  const double t_s = 5.0, rounding = 1e-12;
  const PrincipalMoments& I = scene.body.moments;
  const DrawList start = make_figure(model, 0.0, 1.5).panes[0].list,
                 later = make_figure(model, t_s, 1.5).panes[0].list;
  ASSERT_EQ(later.ellipsoids.size(), 2U);
  const Vec3 tip = arrow_of(later, kOmegaRole).tip, w_B = model.motion->w_B_at(t_s);
  const double T_ratio = kinetic_energy(I, w_B) / kinetic_energy(I, scene.w0_B);
  const double L_ratio = angular_momentum_B(I, w_B).norm() / angular_momentum_B(I, scene.w0_B).norm();
  EXPECT_GT(T_ratio, 1.1);
  EXPECT_NEAR(on_ellipsoid(later.ellipsoids[0], tip), T_ratio, rounding);
  EXPECT_NEAR(on_ellipsoid(later.ellipsoids[1], tip), L_ratio * L_ratio, rounding);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(later.ellipsoids[i].semi_axes, start.ellipsoids[i].semi_axes);
}

// 2026-11-27: the name stood in a corner, and its leader pointed out of the picture.
TEST(Figure, ACurveThatLeavesThePictureIsNamedWhereItIsSeen) {
  Scene scene = poinsot_scene();
  scene.show = {O::omega, O::plane, O::L, O::herpolhode, O::labels};
  scene.motion = {.method = Method::explicit_euler, .step_s = 0.1};
  scene.duration_s = 60;
  const SceneModel model = make_model(scene);
  const Pane pane = make_figure(model, 0.5, 1.0).panes[0];
  int names = 0;
  for (const Label& label : pane.list.labels) {
    if (label.text != "herpolhode") continue;
    ++names;
    const auto at = project(pane.camera, label.anchor, 1.0, 1.0);
    ASSERT_TRUE(at);
    EXPECT_TRUE(at->x() > 0 && at->x() < 1 && at->y() > 0 && at->y() < 1) << at->transpose();
  }
  EXPECT_EQ(names, 1);
}

TEST(Figure, ATrailOfAComputedMotionBeginsWithIt) {  // 2026-11-23: it showed what the method does backwards
  Scene scene = poinsot_scene();
  scene.views = {View::body};
  scene.show = {O::omega, O::trail_omega};
  const double t_s = 0.3;
  const auto begins_at = [&] {
    const DrawList list = make_figure(make_model(scene), t_s, 1.5).panes[0].list;
    return tube_of(list, kOmegaRole).points.front();
  };
  const SceneModel model = make_model(scene);
  const auto tip_at = [&](double s) {
    return arrow_of(make_figure(model, s, 1.5).panes[0].list, kOmegaRole).tip;
  };
  EXPECT_LT((begins_at() - tip_at(t_s - model.span_s)).norm(), kMotionTolerance);
  scene.motion = {.method = Method::explicit_euler, .step_s = 0.01};
  EXPECT_LT((begins_at() - tip_at(0.0)).norm(), kMotionTolerance);
}

TEST(Figure, ATrailEndsAtItsArrowsTipAndOverItsCurve) {  // 2026-11-22: it ended up to a sample short of it
  Scene scene = poinsot_scene();
  scene.views = {View::body};
  scene.show = {O::omega, O::polhode, O::trail_omega};
  for (double t_s : {0.3, 1.1, 2.9}) {
    const DrawList list = make_figure(make_model(scene), t_s, 1.5).panes[0].list;
    const Vec3 tip = arrow_of(list, kOmegaRole).tip;
    const auto trail =
        std::ranges::find_if(list.tubes, [](const Tube& tube) { return tube.color == kOmegaRole.paint; });
    ASSERT_NE(trail, list.tubes.end());
    EXPECT_NEAR((trail->points.back() - tip).norm(), trail->radius, kMotionTolerance) << t_s;
    EXPECT_GT(trail->radius, tube_of(list, kPolhodeRole).radius);
  }
}

TEST(Figure,
     UnderTorqueTheTrailOfLRunsAlongN) {  // 2026-11-21: L was drawn at one length, its trail on a sphere
  Scene scene = poinsot_scene();
  scene.attitude = LPoints::up;
  scene.torque = {SpaceTorque{Vec3(2.0, 0, 0)}};
  scene.show = {O::L, O::N, O::trail_L};
  scene.at_s = 0.8;
  const DrawList list = make_figure(make_model(scene), scene.at_s, 1.5).panes[0].list;
  const std::vector<Vec3>& trail = tube_of(list, kLRole).points;
  const Vec3 way = (trail.back() - trail[trail.size() / 2]).normalized();
  EXPECT_NEAR(way.x(), 1.0, 1e-9);  // dL/dt = N, a constant along x: a straight line, but for RK4's error
}

TEST(Figure, UnderTorqueTheFamilyStaysOnTheEllipsoid) {  // 2026-11-21: it kept the size of t = 0
  Scene scene = poinsot_scene();
  scene.torque = {LinearDamping{0.5}};
  scene.show = {O::energy_ellipsoid, O::polhode_family, O::separatrix};
  const DrawList list = make_figure(make_model(scene), 0.7, 1.5).panes[0].list;
  for (const Tube& tube : list.tubes)
    for (const Vec3& p : tube.points) ASSERT_NEAR(on_ellipsoid(list.ellipsoids[0], p), 1.0, kMotionTolerance);
}

TEST(Figure, HighlightDrawsBolder) {
  Scene scene = poinsot_scene();
  const double plain = arrow_of(make_figure(make_model(scene), 0.7, 1.5).panes[0].list, kOmegaRole).radius;
  scene.highlight = {"omega"};
  EXPECT_GT(arrow_of(make_figure(make_model(scene), 0.7, 1.5).panes[0].list, kOmegaRole).radius, 1.2 * plain);
}

TEST(Figure, TheCameraStandsStill) {
  const SceneModel model = make_model(poinsot_scene());
  EXPECT_EQ(make_figure(model, 0.3, 1.5).panes[0].camera.eye,
            make_figure(model, 2.9, 1.5).panes[0].camera.eye);
}

TEST(Figure, RestIsAPictureToo) {
  Scene scene = poinsot_scene();
  scene.show = {O::energy_ellipsoid, O::omega,       O::L,     O::polhode, O::polhode_family,
                O::separatrix,       O::herpolhode,  O::plane, O::cones,   O::momentum_sphere,
                O::trail_L,          O::trail_omega, O::shape, O::values,  O::labels};
  scene.w0_B.setZero();
  const Figure figure = make_figure(make_model(scene), 1.0, 1.5);
  EXPECT_TRUE(figure.panes[0].list.ellipsoids.empty());
  for (const Arrow& arrow : figure.panes[0].list.arrows) EXPECT_TRUE(arrow.tip.allFinite());
}

TEST(Figure, ExtremeBodiesGiveFiniteLists) {
  for (const char* name : {"needle", "slender-rod", "earth", "sphere", "disc"}) {
    Scene scene = poinsot_scene();
    scene.body = find_body(name).value();
    scene.show.insert(O::shape);
    scene.show.insert(O::polhode_family);
    const DrawList list = make_figure(make_model(scene), 0.3, 1.5).panes[0].list;
    for (const Tube& tube : list.tubes)
      for (const Vec3& p : tube.points) ASSERT_TRUE(p.allFinite()) << name;
    for (const Mesh& mesh : list.meshes)
      for (const Vec3& p : mesh.positions) ASSERT_TRUE(p.allFinite()) << name;
  }
}

}  // namespace
}  // namespace polhode
