// SPDX-License-Identifier: MIT
// The figures of the lecture that are made for one of its stages, as draw lists.
#include "render/figure/make_figure.h"
#include "render/palette.h"
#include "render/scene/model/translation.h"
#include "render/scene/model/turn_orders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using O = Overlay;

constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr double kAspect = 16.0 / 9.0;

const Arrow* arrow_of(const DrawList& list, const Color& color) {
  const auto found = std::find_if(list.arrows.begin(), list.arrows.end(),
                                  [&](const Arrow& arrow) { return arrow.color == color; });
  return found == list.arrows.end() ? nullptr : &*found;
}

std::vector<std::string> texts_of(const DrawList& list) {
  std::vector<std::string> texts;
  for (const Label& label : list.labels) texts.push_back(label.text);
  return texts;
}

Scene thrown_book() {
  Scene scene;
  scene.body = find_body("book").value();
  scene.w0_B = Vec3(2.0, 5.0, 3.0);
  scene.v0_S = Vec3(0.3, 1.3, 2.2);
  scene.F_S = Vec3(0.0, 0.0, -7.85);
  scene.duration_s = 0.4;
  scene.show = {O::shape, O::p, O::v, O::F, O::axes_space, O::labels};
  return scene;
}

bool is_in_picture(const Camera& camera, const Vec3& point) {
  const auto pixel = project(camera, point, 160, 90);
  return pixel && pixel->x() > 0 && pixel->x() < 160 && pixel->y() > 0 && pixel->y() < 90;
}

/// The middle of what the meshes of a list have in the first colour of the body's parts.
std::vector<Vec3> middles_of(const DrawList& list, std::size_t parts) {
  std::vector<Vec3> middles;
  for (std::size_t first = 0; first + parts <= list.meshes.size(); first += parts) {
    Vec3 low = list.meshes[first].positions.front(), high = low;
    for (std::size_t i = first; i < first + parts; ++i)
      for (const Vec3& p : list.meshes[i].positions) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    middles.push_back(0.5 * (low + high));
  }
  return middles;
}

TEST(Poses, LieOnTheWayOfTheCentreAndNotBeforeTheStart) {
  Scene scene = thrown_book();
  scene.body = find_body("box").value();  // one mesh, symmetric about its centre
  const double t_s = 0.3;
  const std::size_t alone = make_figure(make_model(scene), t_s, kAspect).panes[0].list.meshes.size();
  scene.poses = {.count = 4, .over_s = 0.4};
  const SceneModel model = make_model(scene);
  const DrawList list = make_figure(model, t_s, kAspect).panes[0].list;
  ASSERT_EQ(list.meshes.size(), alone + 3) << "the fourth would be 0.1 s before the throw";
  const std::vector<Vec3> middles = middles_of(list, 1);
  const Vec3 now_S = translation_at(scene, t_s).r_S, first_S = translation_at(scene, 0.0).r_S;
  const double scale = (middles[1] - middles[0]).norm() / (first_S - now_S).norm();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 then_S = translation_at(scene, 0.1 * static_cast<double>(i)).r_S;
    EXPECT_LT((middles[i + 1] - middles[0] - scale * (then_S - now_S)).norm(), 1e3 * kRounding) << i;
  }
  EXPECT_NE(list.meshes[1].color, list.meshes[0].color);
}

TEST(Looks, OfNamedBodiesTellTheirFacesApartAndKeepTheirSize) {
  for (const char* name : {"book", "phone"}) {
    Scene scene;
    scene.body = find_body(name).value();
    scene.show = {O::shape};
    scene.w0_B.setZero();
    scene.views = {View::body};
    const DrawList list = make_figure(make_model(scene), 0.0, kAspect).panes[0].list;
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    Color front, back;  // of what is widest on either side of the middle
    double widest_front = 0.0, widest_back = 0.0;
    for (const Mesh& mesh : list.meshes) {
      Vec3 least = mesh.positions.front(), most = least;
      for (const Vec3& p : mesh.positions) {
        least = least.cwiseMin(p);
        most = most.cwiseMax(p);
      }
      low = low.cwiseMin(least);
      high = high.cwiseMax(most);
      const double wide = most.x() - least.x();
      if (least.z() > 0.0 && wide > widest_front) {
        widest_front = wide;
        front = mesh.color;
      }
      if (most.z() < 0.0 && wide > widest_back) {
        widest_back = wide;
        back = mesh.color;
      }
    }
    EXPECT_NE(front, back) << name;
    // A band or a camera stands out from the faces a little.
    const Vec3 size = high - low, wanted = scene.body.shape->size_m;
    EXPECT_NEAR(size.y() / size.x(), wanted.y() / wanted.x(), 0.04) << name;
    EXPECT_NEAR(size.z() / size.x(), wanted.z() / wanted.x(), 0.04) << name;
  }
}

TEST(ThrownBody, HasItsMomentumOnItsVelocity) {
  const SceneModel model = make_model(thrown_book());
  for (double t_s : {0.0, 0.13, 0.4}) {
    const DrawList list = make_figure(model, t_s, kAspect).panes[0].list;
    const Arrow *v = arrow_of(list, kOmegaRole.paint), *p = arrow_of(list, kLRole.paint),
                *F = arrow_of(list, kNRole.paint);
    ASSERT_TRUE(v && p && F);
    const Vec3 now_S = translation_at(model.scene, t_s).v_S.normalized();
    EXPECT_LT(((v->tip - v->tail).normalized() - now_S).norm(), kRounding);
    EXPECT_LT(((p->tip - p->tail).normalized() - now_S).norm(), kRounding);
    EXPECT_LT(((F->tip - F->tail).normalized() + Vec3::UnitZ()).norm(), kRounding);
    EXPECT_THAT(texts_of(list), testing::IsSupersetOf({"$\\vec p$", "$\\vec v$", "$\\vec F$"}));
  }
}

// Seen from the camera the origin of S stands still, and the centre of mass goes r away from it.
TEST(ThrownBody, GoesItsWayThroughAPictureThatStands) {
  const SceneModel model = make_model(thrown_book());
  const Figure start = make_figure(model, 0.0, kAspect), later = make_figure(model, 0.3, kAspect);
  const auto origin_of = [](const Figure& figure) {
    return arrow_of(figure.panes[0].list, kAxesRole.paint)->tail;
  };
  const Vec3 from_start = start.panes[0].camera.eye - origin_of(start);
  const Vec3 from_later = later.panes[0].camera.eye - origin_of(later);
  EXPECT_LT((from_start - from_later).norm(), kRounding * from_start.norm());
  // True to scale: the book's longest diagonal is 2 × 0.95 scene units.
  const double units_per_m = 1.9 / model.scene.body.shape->size_m.norm();
  const Vec3 way_S = origin_of(start) - origin_of(later);
  EXPECT_LT((way_S - units_per_m * translation_at(model.scene, 0.3).r_S).norm(), kRounding * way_S.norm());
}

TEST(ThrownBody, StaysInThePicture) {
  for (double aspect : {kAspect, 4.0 / 3.0, 0.7}) {
    const SceneModel model = make_model(thrown_book());
    for (int n = 0; n <= 20; ++n) {
      const Pane pane = make_figure(model, 0.4 * n / 20, aspect).panes[0];
      for (const Mesh& mesh : pane.list.meshes)
        for (const Vec3& p : mesh.positions) {
          const auto pixel = project(pane.camera, p, 90 * aspect, 90);
          ASSERT_TRUE(pixel && pixel->x() > 0 && pixel->x() < 90 * aspect && pixel->y() > 0 &&
                      pixel->y() < 90)
              << n << ' ' << aspect;
        }
    }
  }
}

TEST(ThrownBody, ThatStaysShowsNoArrows) {
  Scene scene = thrown_book();
  scene.v0_S = scene.F_S = Vec3::Zero();
  const SceneModel model = make_model(scene);
  const DrawList list = make_figure(model, 0.1, kAspect).panes[0].list;
  EXPECT_EQ(arrow_of(list, kLRole.paint), nullptr);
  EXPECT_EQ(arrow_of(list, kNRole.paint), nullptr);
}

TEST(ThrownBody, IsRefusedWhereItWouldBeASpeck) {
  Scene scene = thrown_book();
  scene.v0_S = Vec3(1e5, 0, 0);
  EXPECT_THROW(check_scene(scene), std::domain_error);
  scene.v0_S = Vec3(1e308, 1e308, 1e308);
  EXPECT_THROW(check_scene(scene), std::domain_error);
}

TEST(Puck, SlidesWhileTheBodyStays) {
  Scene scene = thrown_book();
  scene.F_S = Vec3::Zero();
  scene.v0_S = Vec3(0.8, 0.4, 0.0);
  scene.show = {O::shape, O::omega, O::puck, O::p, O::v};
  const SceneModel model = make_model(scene);
  const Figure start = make_figure(model, 0.0, kAspect), end = make_figure(model, 0.4, kAspect);
  EXPECT_EQ(start.panes[0].camera.eye, end.panes[0].camera.eye);
  const Vec3 way_S =
      arrow_of(end.panes[0].list, kLRole.paint)->tail - arrow_of(start.panes[0].list, kLRole.paint)->tail;
  const double units_per_m = 1.9 / scene.body.shape->size_m.norm();
  EXPECT_LT((way_S - units_per_m * 0.4 * scene.v0_S).norm(), kRounding * 10);
  for (const Figure& figure : {start, end})
    for (const Mesh& mesh : figure.panes[0].list.meshes)
      for (const Vec3& p : mesh.positions) ASSERT_TRUE(is_in_picture(figure.panes[0].camera, p));
}

TEST(TurnOrders, AreTwoPanesThatEndDifferently) {
  Scene scene;
  scene.body = find_body("book").value();
  scene.show = {O::turn_orders, O::axes_body, O::omega, O::L, O::labels};
  scene.duration_s = 4.0;
  const SceneModel model = make_model(scene);
  EXPECT_FALSE(model.drawn.contains(O::omega));
  const auto axis_1 = [&](double t_s, std::size_t pane) {
    return arrow_of(make_figure(model, t_s, kAspect).panes.at(pane).list, kBodyAxisRoles[0].paint)->tip;
  };
  const Figure figure = make_figure(model, 4.0, kAspect);
  ASSERT_EQ(figure.panes.size(), 2U);
  EXPECT_EQ(figure.panes[0].title, title_of(TurnOrder::x_then_y).in(Language::en));
  EXPECT_EQ(figure.panes[1].title, title_of(TurnOrder::y_then_x).in(Language::en));
  EXPECT_EQ(figure.panes[1].x, 0.5);
  EXPECT_EQ(make_figure(model, 4.0, 0.7).panes[1].y, 0.5);  // in an upright picture one above the other
  EXPECT_LT((axis_1(0.0, 0) - axis_1(0.0, 1)).norm(), kRounding);
  EXPECT_GT((axis_1(4.0, 0) - axis_1(4.0, 1)).norm(), 1.0);
}

Scene turning(OverlaySet show) {
  Scene scene;
  scene.w0_B = Vec3(0.7, 0.4, 1.1);
  scene.show = show;
  return scene;
}

TEST(Transport, ClosesATriangleAtTheTipOfA) {
  Scene scene = turning({O::transport, O::labels});
  scene.arrow = ArrowHeld::free;
  scene.views = {View::space, View::body};
  const SceneModel model = make_model(scene);
  for (const Pane& pane : make_figure(model, 0.8, kAspect).panes) {
    const DrawList& list = pane.list;
    const Arrow *A = arrow_of(list, kTRole.paint), *star = arrow_of(list, kPolhodeRole.paint),
                *turning = arrow_of(list, kOmegaRole.paint), *sum = arrow_of(list, kHerpolhodeRole.paint);
    ASSERT_TRUE(A && star && turning && sum);
    EXPECT_EQ(star->tail, A->tip);
    EXPECT_LT((turning->tail - star->tip).norm(), kRounding);
    EXPECT_EQ(sum->tail, A->tip);
    EXPECT_LT((sum->tip - turning->tip).norm(), 1e-10);  // difference quotients: transport_arrow_test.cpp
  }
}

// The tip's path is seen in the frame of the view: its last step lies along the derivative of that frame.
TEST(Transport, TheTrailEndsAlongTheDerivativeOfItsFrame) {
  Scene scene = turning({O::transport});
  scene.arrow = ArrowHeld::free;
  scene.views = {View::space, View::body};
  const Figure figure = make_figure(make_model(scene), 0.8, kAspect);
  const auto along = [&](std::size_t pane, const Role& role) {
    const DrawList& list = figure.panes[pane].list;
    const std::vector<Vec3>& trail = list.tubes.back().points;
    const Vec3 step = (trail.back() - trail[trail.size() - 2]).normalized();
    const Arrow* rate = arrow_of(list, role.paint);
    return step.dot((rate->tip - rate->tail).normalized());
  };
  EXPECT_GT(along(0, kHerpolhodeRole), 0.999);
  EXPECT_LT(along(0, kPolhodeRole), 0.9);
  EXPECT_GT(along(1, kPolhodeRole), 0.999);
}

TEST(Terms, AddUpToTheTorqueAtTheTipOfL) {
  Scene scene = turning({O::terms, O::L, O::N, O::labels});
  scene.torque = {SpaceTorque{Vec3(0.5, 0.3, 0.1)}};
  scene.at_s = 0.5;
  const DrawList list = make_figure(make_model(scene), 0.5, kAspect).panes[0].list;
  const Arrow *L = arrow_of(list, kLRole.paint), *inertial = arrow_of(list, kPolhodeRole.paint),
              *gyroscopic = arrow_of(list, kOmegaRole.paint), *N = arrow_of(list, kNRole.paint);
  ASSERT_TRUE(L && inertial && gyroscopic && N);
  EXPECT_EQ(inertial->tail, L->tip);
  EXPECT_LT((gyroscopic->tail - inertial->tip).norm(), kRounding);
  EXPECT_EQ(N->tail, L->tip);
  EXPECT_LT((N->tip - gyroscopic->tip).norm(), 1e-6);  // DP8 at its tolerance over h: euler_terms_test.cpp
  const Vec3 N_S = Vec3(0.5, 0.3, 0.1).normalized();
  EXPECT_LT(((N->tip - N->tail).normalized() - N_S).norm(), 1e-9);
  const auto named_N = texts_of(list);
  EXPECT_EQ(std::count(named_N.begin(), named_N.end(), "$\\vec N$"), 1);
}

double on_ellipsoid(const GlassEllipsoid& e, const Vec3& p) {
  return (e.rotation.conjugate() * (p - e.center)).cwiseQuotient(e.semi_axes).squaredNorm();
}

// The polhode is where T and |L| have both their values: in L-space on a sphere, in ω-space on two
// ellipsoids.
TEST(Surfaces, MeetInThePolhodeAndItsMirrorImage) {
  for (const O energy : {O::momentum_ellipsoid, O::energy_ellipsoid}) {
    const DrawList list =
        make_figure(make_model(turning({energy, O::momentum_sphere, O::polhode})), 0.4, kAspect)
            .panes[0]
            .list;
    ASSERT_EQ(list.ellipsoids.size(), 2U);
    ASSERT_EQ(list.tubes.size(), 2U);
    for (const Tube& tube : list.tubes)
      for (const Vec3& p : tube.points)
        for (const GlassEllipsoid& e : list.ellipsoids) ASSERT_NEAR(on_ellipsoid(e, p), 1.0, 1e-12);
    EXPECT_LT((list.tubes[0].points[3] + list.tubes[1].points[3]).norm(), kRounding);
  }
}

Scene gyroscope() {
  Scene scene;
  scene.body = {"gyroscope", PrincipalMoments(0.0125, 0.0125, 0.005), std::nullopt};
  scene.w0_B = Vec3(0.0, 3.84, 51.84);
  scene.attitude = Quat(0.8, 0.6, 0.0, 0.0);
  scene.torque = {HeavyTop{0.980665, Vec3::UnitZ()}};
  scene.duration_s = 1.0;
  scene.show = {O::shape, O::pivot, O::L, O::labels};
  return scene;
}

TEST(Pivot, HoldsTheRotorAtTheLeverOfItsWeight) {
  const SceneModel model = make_model(gyroscope());
  const DrawList list = make_figure(model, 0.3, kAspect).panes[0].list;
  const Arrow* weight = arrow_of(list, kNRole.paint);
  ASSERT_TRUE(weight);
  const Vec3 axis_S = model.motion->at(0.3).q_SB * Vec3::UnitZ();
  EXPECT_LT((weight->tail.normalized() - axis_S).norm(), kRounding);  // at the centre of mass
  EXPECT_NEAR((weight->tip - weight->tail).normalized().z(), -1.0, kRounding);
  EXPECT_EQ(list.meshes.size(), 3U);  // rotor, axle, stand
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : list.meshes[0].positions) middle += p;
  middle /= static_cast<double>(list.meshes[0].positions.size());
  EXPECT_LT((middle - weight->tail).norm(), 1e-3);
}

// 2026-11-27: of an upright top the word stood upon the stand.
TEST(Pivot, TheWeightsNameStandsBesideTheStandOfAnUprightTop) {
  const auto stands_beside = [](const Scene& scene) {
    const DrawList list = make_figure(make_model(scene), 0.0, kAspect).panes[0].list;
    const auto named = std::find_if(list.labels.begin(), list.labels.end(),
                                    [](const Label& label) { return label.text == "weight"; });
    return named != list.labels.end() && named->beside;
  };
  Scene upright = gyroscope();
  upright.attitude = Quat::Identity();
  EXPECT_TRUE(stands_beside(upright));
  EXPECT_FALSE(stands_beside(gyroscope()));
}

// Before the stand, which would hide it, and not inside.
TEST(Pivot, TheWeightOfAnUprightTopIsDrawnBeforeItsStand) {
  Scene scene = gyroscope();
  scene.attitude = Quat::Identity();
  scene.w0_B = Vec3(0, 0, 52);
  const Figure figure = make_figure(make_model(scene), 0.0, kAspect);
  const Arrow* weight = arrow_of(figure.panes[0].list, kNRole.paint);
  ASSERT_TRUE(weight);
  const Camera& camera = figure.panes[0].camera;
  EXPECT_GT(weight->tip.head<2>().norm(), 0.05) << "clear of the stand's axis";
  EXPECT_GT(weight->tip.head<2>().dot((camera.eye - camera.target).head<2>()), 0.0) << "on the viewer's side";
  EXPECT_NEAR((weight->tip - weight->tail).normalized().z(), -1.0, kRounding);
}

TEST(Spin, GoesRoundAxis3AsTheBodyDoesWhereItIsSeen) {
  for (const double spin : {5.0, -5.0})
    for (const bool is_turned_over : {false, true}) {
      Scene scene;
      scene.body = {"plate", PrincipalMoments(1, 1, 2), std::nullopt};
      scene.w0_B = Vec3(0.3, 0.2, spin);
      scene.attitude = is_turned_over ? Quat(0, 1, 0, 0) : Quat(0.96, 0.28, 0, 0);
      scene.show = {O::shape, O::spin};
      const SceneModel model = make_model(scene);
      const Figure figure = make_figure(model, 0.1, kAspect);
      const Arrow* arrow = arrow_of(figure.panes[0].list, kOmegaRole.paint);
      ASSERT_TRUE(arrow);
      const Vec3 axis_S = model.motion->at(0.1).q_SB * Vec3::UnitZ();
      const Vec3 from_axis = arrow->tip - arrow->tip.dot(axis_S) * axis_S;
      EXPECT_GT((arrow->tip - arrow->tail).dot(spin * axis_S.cross(from_axis)), 0.0);
      EXPECT_GT(arrow->tip.dot(axis_S) * figure.panes[0].camera.eye.dot(axis_S), 0.0)
          << "on the side that is seen";
    }
}

TEST(Spin, IsNotDrawnWhereNothingTurnsAboutAxis3) {
  Scene scene;
  scene.w0_B = Vec3(1, 0, 0);
  scene.show = {O::shape, O::spin};
  EXPECT_FALSE(arrow_of(make_figure(make_model(scene), 0.0, kAspect).panes[0].list, kOmegaRole.paint));
}

TEST(Pivot, NeedsAHeavyTop) {
  Scene scene = gyroscope();
  scene.torque = {};
  EXPECT_FALSE(make_model(scene).drawn.contains(O::pivot));
}

Scene computed_badly() {
  Scene scene = turning({O::shape, O::omega, O::L, O::labels});
  scene.body.name = "plain";  // not a book of several parts
  scene.motion = {.method = Method::explicit_midpoint, .step_s = 0.3, .ghost = true};
  return scene;
}

TEST(Ghost, IsTheExactBodyBesideTheComputedOne) {
  const SceneModel model = make_model(computed_badly());
  ASSERT_TRUE(model.needs.ghost && model.exact);
  EXPECT_EQ(model.exact->method(), "exact");
  const DrawList list = make_figure(model, 9.0, kAspect).panes[0].list;
  ASSERT_EQ(list.meshes.size(), 2U);
  EXPECT_EQ(list.meshes[0].color.a, 1.0F);
  EXPECT_LT(list.meshes[1].color.a, 0.6F);
  const Quat apart = model.exact->at(9.0).q_SB * model.motion->at(9.0).q_SB.conjugate();
  constexpr double kLarger = 1.004;  // so that coinciding faces show no specks
  for (std::size_t i = 0; i < list.meshes[0].positions.size(); ++i)
    ASSERT_LT((kLarger * (apart * list.meshes[0].positions[i]) - list.meshes[1].positions[i]).norm(), 1e-12);
  EXPECT_THAT(texts_of(list), testing::IsSupersetOf({"exact motion", "explicit midpoint"}));
}

const Label& label_of(const DrawList& list, const std::string& text) {
  return *std::ranges::find(list.labels, text, &Label::text);
}

TEST(Ghost, NamesBothBodiesWhereTheyStandOutOfTheOther) {  // 2026-11-22: names stood between both
  const SceneModel model = make_model(computed_badly());
  for (double t_s : {3.0, 9.0, 14.0}) {
    const Pane pane = make_figure(model, t_s, kAspect).panes[0];
    ASSERT_EQ(pane.list.meshes.size(), 2U);
    const Mat3 axes = pane.camera.view().topLeftCorner<3, 3>();  // right, up, towards the eye
    const Vec3 eye = pane.camera.eye, ahead = pane.camera.target - eye;
    const auto seen = [&](const Vec3& p) -> Vec3 {
      return eye + ahead.squaredNorm() / (p - eye).dot(ahead) * (p - eye);
    };
    const auto outside = [&](const Vec3& place, const Mesh& body) {
      double most = -1.0;
      for (int k = 0; k < 360; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 360;
        const Vec3 way = axes.transpose() * Vec3(std::cos(angle), std::sin(angle), 0.0);
        double reach = -1e9;
        for (const Vec3& p : body.positions) reach = std::max(reach, seen(p).dot(way));
        most = std::max(most, seen(place).dot(way) - reach);
      }
      return most;
    };
    EXPECT_GT(outside(label_of(pane.list, "explicit midpoint").anchor, pane.list.meshes[1]), 0.01) << t_s;
    EXPECT_GT(outside(label_of(pane.list, "exact motion").anchor, pane.list.meshes[0]), 0.01) << t_s;
  }
}

TEST(Ghost, IsNotMadeWhereItWouldHide) {
  Scene scene = computed_badly();
  scene.motion = {.method = Method::exact, .ghost = true};
  EXPECT_FALSE(make_model(scene).exact);
  scene = computed_badly();
  scene.motion.ghost = false;
  EXPECT_FALSE(make_model(scene).exact);
  scene = computed_badly();
  scene.show = {O::energy_ellipsoid, O::polhode};
  EXPECT_FALSE(make_model(scene).exact);
}

TEST(SpecialFigures, OfABodyAtRestAreFinite) {
  for (O overlay : {O::transport, O::terms, O::puck, O::turn_orders, O::pivot, O::p}) {
    Scene scene = turning({overlay, O::shape, O::labels});
    scene.w0_B.setZero();
    scene.torque = {HeavyTop{0.5, Vec3::UnitZ()}};
    const Figure figure = make_figure(make_model(scene), 0.0, kAspect);
    for (const Pane& pane : figure.panes) {
      EXPECT_TRUE(pane.camera.eye.allFinite());
      for (const Arrow& arrow : pane.list.arrows) EXPECT_TRUE((arrow.tip - arrow.tail).allFinite());
    }
  }
}

}  // namespace
}  // namespace polhode
