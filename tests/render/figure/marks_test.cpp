// SPDX-License-Identifier: MIT
// What a lesson draws of vectors of its own.
#include "physics/body/euler.h"
#include "physics/geometry/curve_sampling.h"
#include "render/figure/make_figure.h"
#include "render/figure/omega_tip.h"
#include "render/palette.h"
#include "tests/support/mark_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

using O = Overlay;
using test::body_axis;
using test::mark_vector;
using test::omega_vector;
using test::rate_of_e3;
using test::space_axis;

constexpr double kAspect = 16.0 / 9.0;
/// Of vectors of order 1 that were turned a few times.
constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();

Scene scene_with(Marks marks, OverlaySet show = {}) {
  Scene scene;
  scene.w0_B = Vec3(0.4, 1.1, 1.6);
  scene.show = show;
  scene.marks = std::move(marks);
  return scene;
}

DrawList list_of(const Scene& scene, double t_s, std::size_t pane = 0) {
  return make_figure(make_model(scene), t_s, kAspect).panes[pane].list;
}

RigidBodyState state_of(const Scene& scene, double t_s) { return make_model(scene).motion->at(t_s); }

Vec3 along(const Arrow& arrow) { return arrow.tip - arrow.tail; }

TEST(Marks, AnArrowOfAUnitVectorHasTheLengthOne) {
  Scene scene = scene_with({.arrows = {{body_axis(2)}}});
  scene.views = {View::space, View::body};
  const Vec3 e3_S = state_of(scene, 0.7).q_SB * Vec3::UnitZ();
  const DrawList in_space = list_of(scene, 0.7, 0), in_body = list_of(scene, 0.7, 1);
  ASSERT_EQ(in_space.arrows.size(), 1U);
  EXPECT_EQ(in_space.arrows[0].tail, Vec3::Zero());
  EXPECT_LT((in_space.arrows[0].tip - e3_S).norm(), kRounding);
  ASSERT_EQ(in_body.arrows.size(), 1U);
  EXPECT_LT((in_body.arrows[0].tip - Vec3::UnitZ()).norm(), kRounding) << "the body stands still";
  ASSERT_EQ(in_space.labels.size(), 1U);
  EXPECT_EQ(in_space.labels[0].text, "$e_3$");
}

TEST(Marks, ArrowsAreNamedAsTheLessonSays) {
  const Scene scene =
      scene_with({.arrows = {{.of = body_axis(0), .tex = "n"}, {.of = body_axis(1), .tex = ""}}});
  const DrawList list = list_of(scene, 0.0);
  ASSERT_EQ(list.labels.size(), 1U) << "an empty name is none";
  EXPECT_EQ(list.labels[0].text, "$n$");
  EXPECT_EQ(list.arrows.size(), 2U);
}

TEST(Marks, WhatIsLongestOverTheDurationHasTheLengthAskedFor) {
  for (const double length : {0.1, 0.6, 3.0}) {
    Scene scene = scene_with({.arrows = {{.of = rate_of_e3(), .at = body_axis(2), .length = length}}});
    scene.duration_s = 6.4;
    const SceneModel model = make_model(scene);
    double longest = 0.0;
    for (int n = 0; n <= 64; ++n) {
      const DrawList list = make_figure(model, 0.1 * n, kAspect).panes[0].list;
      for (const Arrow& arrow : list.arrows) {
        longest = std::max(longest, along(arrow).norm());
        const Vec3 e3_S = model.motion->at(0.1 * n).q_SB * Vec3::UnitZ();
        EXPECT_LT((arrow.tail - e3_S).norm(), kRounding) << "it stands on the tip of e3";
        EXPECT_LT(std::abs(along(arrow).dot(e3_S)), 4 * kRounding) << "dê3/dt is normal to ê3";
      }
    }
    EXPECT_NEAR(longest, length, 4 * kRounding);
  }
}

// 2026-11-28: a hand took ω to another length, and an arrow of a given length stayed as long.
TEST(Marks, AHandThatTakesOmegaLeavesTheirScale) {
  Scene scene = scene_with({.arrows = {{.of = omega_vector(), .length = 1.4}, {.of = rate_of_e3()}}});
  const auto lengths = [](const Scene& drawn) {
    const DrawList list = list_of(drawn, 0.0);
    std::vector<double> found;
    for (const Arrow& arrow : list.arrows) found.push_back(along(arrow).norm());
    return found;
  };
  const std::vector<double> before = lengths(scene);
  scene.camera.fitted = CameraFit{scene.camera.azimuth_rad, scene.camera.elevation_rad, scene.w0_B};
  scene.w0_B *= 0.5;
  const std::vector<double> halved = lengths(scene);
  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(halved.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(halved[k], 0.5 * before[k], 4 * kRounding);
}

TEST(Marks, WithoutALengthItIsTheUsualOne) {
  Scene scene = scene_with({.arrows = {{.of = rate_of_e3()}}});
  scene.duration_s = 6.4;
  const SceneModel model = make_model(scene);
  double longest = 0.0;
  for (int n = 0; n <= 64; ++n) {
    const Figure figure = make_figure(model, 0.1 * n, kAspect);
    for (const Arrow& arrow : figure.panes[0].list.arrows) longest = std::max(longest, along(arrow).norm());
  }
  EXPECT_NEAR(longest, kArrowLength, 4 * kRounding);
}

TEST(Marks, NumbersAreDrawnAsTheyAreUnlessTheyAreLong) {
  const auto projected = mark_vector(
      "u", [](const RigidBodyState& s) { return Vec3((s.q_SB * Vec3::UnitZ()).z() * Vec3::UnitZ()); }, true);
  const auto huge = mark_vector(
      "h", [](const RigidBodyState&) { return Vec3(0.0, 0.0, 1e300); }, true);
  const Scene scene = scene_with({.arrows = {{projected}, {huge}}});
  const DrawList list = list_of(scene, 0.3);
  ASSERT_EQ(list.arrows.size(), 2U);
  EXPECT_NEAR(list.arrows[0].tip.z(), (state_of(scene, 0.3).q_SB * Vec3::UnitZ()).z(), kRounding);
  EXPECT_NEAR(list.arrows[1].tip.z(), kArrowLength, kRounding);
}

TEST(Marks, OmegaLooksAsItsOverlay) {
  const Scene scene = scene_with({.arrows = {{omega_vector()}}}, {O::omega});
  const DrawList list = list_of(scene, 0.9);
  ASSERT_EQ(list.arrows.size(), 2U);
  EXPECT_LT((list.arrows[0].tip - list.arrows[1].tip).norm(), kRounding);
  EXPECT_EQ(list.arrows[0].color, list.arrows[1].color);
  EXPECT_EQ(list.arrows[0].radius, list.arrows[1].radius);
}

TEST(Marks, LAndNStandAsTheirOverlaysDo) {
  const PrincipalMoments I = Scene{}.body.moments;
  MarkVector L =
      mark_vector("L", [I](const RigidBodyState& s) { return Vec3(s.q_SB * angular_momentum_B(I, s.w_B)); });
  L.overlay = O::L;
  MarkVector N = mark_vector("N", [](const RigidBodyState&) { return Vec3(0.3, -1.4, 0.4); });
  N.overlay = O::N;
  Scene scene =
      scene_with({.arrows = {{.of = L}, {.of = N, .at = L}}, .notes = {{"a torque", N}}}, {O::L, O::N});
  scene.torque = {SpaceTorque{Vec3(0.3, -1.4, 0.4)}};
  scene.at_s = 0.8;
  const DrawList list = list_of(scene, 0.8);
  ASSERT_EQ(list.arrows.size(), 4U);
  EXPECT_LT((list.arrows[0].tip - list.arrows[2].tip).norm(), kRounding);
  EXPECT_EQ(list.arrows[0].dash, list.arrows[2].dash);
  EXPECT_LT((list.arrows[1].tip - list.arrows[3].tip).norm(), kRounding);
  EXPECT_EQ(list.arrows[1].dash, list.arrows[3].dash);
  ASSERT_EQ(list.labels.size(), 3U) << "both names, and the note";
  EXPECT_LT((list.labels[2].anchor - list.arrows[1].tip).norm(), kRounding);

  scene.marks.arrows.clear();
  EXPECT_LT((list_of(scene, 0.8).labels[0].anchor - list.arrows[1].tip).norm(), kRounding)
      << "at the tip of the overlay's arrow";
}

TEST(Marks, PartsLikeAVectorAddUpToIt) {
  const auto part =
      mark_vector("p", [](const RigidBodyState& s) { return Vec3(s.q_SB * Vec3(0, 0, s.w_B.z())); });
  const auto rest =
      mark_vector("r", [](const RigidBodyState& s) { return Vec3(s.q_SB * Vec3(s.w_B.x(), s.w_B.y(), 0)); });
  const Scene scene = scene_with({.arrows = {{.of = part, .like = omega_vector()},
                                             {.of = rest, .at = part, .like = omega_vector()},
                                             {.of = omega_vector(), .length = 1.4}}});
  const DrawList list = list_of(scene, 1.3);
  ASSERT_EQ(list.arrows.size(), 3U);
  EXPECT_LT((list.arrows[1].tip - list.arrows[2].tip).norm(), kRounding)
      << "of the length that the arrow of ω is given";
  EXPECT_EQ(list.arrows[1].tail, list.arrows[0].tip);
}

TEST(Marks, ArrowsThatStandOnOneAnotherEnd) {
  // Only arrows above count as tails: the first stands on an e1 from the centre, the second on the first.
  const Scene scene = scene_with(
      {.arrows = {{.of = body_axis(2), .at = body_axis(0)}, {.of = body_axis(0), .at = body_axis(2)}}});
  const DrawList list = list_of(scene, 0.4);
  const Quat q_SB = state_of(scene, 0.4).q_SB;
  ASSERT_EQ(list.arrows.size(), 2U);
  EXPECT_LT((list.arrows[0].tip - q_SB * Vec3(1, 0, 1)).norm(), kRounding);
  EXPECT_LT((list.arrows[1].tip - q_SB * Vec3(2, 0, 1)).norm(), kRounding);
}

TEST(Marks, WhatIsZeroOrNothingDrawsNothing) {
  const auto zero = mark_vector("0", [](const RigidBodyState&) { return Vec3(Vec3::Zero()); });
  const auto none = mark_vector("none", [](const RigidBodyState&) {
    return Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  });
  for (const MarkVector& vector : {zero, none}) {
    const Scene scene = scene_with({.trails = {{vector, true}},
                                    .arrows = {{.of = vector}, {.of = vector, .length = 2.0}},
                                    .angles = {{vector, body_axis(0), "a"}, {body_axis(0), vector, "a"}},
                                    .areas = {{vector, body_axis(0)}, {body_axis(0), vector}},
                                    .lines = {{vector, vector}},
                                    .planes = {{.normal = vector}}});
    const DrawList list = list_of(scene, 0.5);
    EXPECT_TRUE(list.arrows.empty() && list.tubes.empty() && list.meshes.empty() && list.labels.empty() &&
                list.balls.empty())
        << vector.quantity.text;
  }
  const DrawList list = list_of(scene_with({.arrows = {{.of = body_axis(0), .at = none}},
                                            .angles = {{body_axis(0), body_axis(1), "a", none}},
                                            .lines = {{body_axis(0), none}},
                                            .planes = {{.normal = body_axis(0), .through = none}},
                                            .notes = {{"nowhere", none}}}),
                                0.5);
  EXPECT_TRUE(list.arrows.empty() && list.meshes.empty() && list.labels.empty());
}

// An area has the sides that its arrows show, and stands where the first of them does.
TEST(Marks, AnAreaIsSpannedByTheArrowsAsTheyAreDrawn) {
  const Scene scene =
      scene_with({.arrows = {{.of = body_axis(0), .length = 0.5},
                             {.of = body_axis(1), .at = body_axis(0)},
                             {.of = body_axis(2), .length = 2.0}},
                  .areas = {{body_axis(0), body_axis(2), "a"}, {body_axis(1), body_axis(2)}}});
  const DrawList list = list_of(scene, 0.4);
  const Mat3 R = state_of(scene, 0.4).q_SB.toRotationMatrix();
  const Vec3 first[] = {Vec3::Zero(), Vec3(0.5, 0, 0), Vec3(0.5, 0, 2), Vec3(0, 0, 2), Vec3::Zero()},
             second[] = {Vec3(0.5, 0, 0), Vec3(0.5, 1, 0), Vec3(0.5, 1, 2), Vec3(0.5, 0, 2), Vec3(0.5, 0, 0)};
  ASSERT_EQ(list.meshes.size(), 2U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_LT((list.meshes[0].positions[k + 1] - R * first[k]).norm(), kRounding) << k;
    EXPECT_LT((list.meshes[1].positions[k + 1] - R * second[k]).norm(), kRounding) << k;
  }
  const auto name = std::find_if(list.labels.begin(), list.labels.end(),
                                 [](const Label& label) { return label.text == "$a$"; });
  ASSERT_NE(name, list.labels.end());
  EXPECT_LT((name->anchor - R * Vec3(0.25, 0, 1)).norm(), kRounding);
  const auto colored = scene_with({.areas = {{body_axis(0), body_axis(1), "", "violet"}}});
  EXPECT_NE(list_of(colored, 0.4).meshes[0].color, list.meshes[0].color);
}

TEST(Marks, ALineGoesFromTipToTip) {
  const Scene scene =
      scene_with({.arrows = {{.of = body_axis(0), .length = 0.5}}, .lines = {{body_axis(0), body_axis(2)}}});
  const DrawList list = list_of(scene, 0.4);
  const Quat q_SB = state_of(scene, 0.4).q_SB;
  ASSERT_EQ(list.tubes.size(), 1U);
  ASSERT_EQ(list.tubes[0].points.size(), 2U);
  EXPECT_LT((list.tubes[0].points[0] - q_SB * Vec3(0.5, 0, 0)).norm(), kRounding);
  EXPECT_LT((list.tubes[0].points[1] - q_SB * Vec3(0, 0, 1)).norm(), kRounding);
  EXPECT_GT(list.tubes[0].dash, 0.0);
}

TEST(Marks, AnAngleStandsAtTheTipThatItNames) {
  const Scene centred = scene_with({.angles = {{body_axis(0), body_axis(1), "a"}}});
  const Scene moved = scene_with({.angles = {{body_axis(0), body_axis(1), "a", body_axis(2)}}});
  const DrawList there = list_of(moved, 0.4), here = list_of(centred, 0.4);
  const Vec3 tip = state_of(moved, 0.4).q_SB * Vec3(0, 0, 1);
  ASSERT_EQ(there.meshes.size(), 1U);
  EXPECT_LT((there.meshes[0].positions[0] - tip).norm(), kRounding);
  const auto from_corner = [](const DrawList& list, std::size_t k) {
    return Vec3((list.meshes[0].positions[k] - list.meshes[0].positions[0]).normalized());
  };
  for (std::size_t k = 1; k < there.meshes[0].positions.size(); ++k)
    EXPECT_LT((from_corner(there, k) - from_corner(here, k)).norm(), kRounding) << k;
}

TEST(Marks, ATrailOnTheSphereIsThePathOfTheDirection) {
  const auto twice = mark_vector("2e", [](const RigidBodyState& s) { return Vec3(s.q_SB * Vec3(0, 0, 2)); });
  Scene scene = scene_with({.trails = {{twice, true}}});
  scene.torque = {SpaceTorque{Vec3(0.3, -0.4, 0.2)}};
  scene.duration_s = 3.0;
  const SceneModel model = make_model(scene);
  const DrawList list = make_figure(model, 2.5, kAspect).panes[0].list;
  ASSERT_EQ(list.ellipsoids.size(), 1U);
  EXPECT_EQ(list.ellipsoids[0].semi_axes, Vec3(1, 1, 1));
  ASSERT_EQ(list.tubes.size(), 1U);
  const std::vector<Vec3>& points = list.tubes[0].points;
  const auto e3_S = [&](double t_s) -> Vec3 { return model.motion->at(t_s).q_SB * Vec3::UnitZ(); };
  EXPECT_LT((points.front() - e3_S(0.0)).norm(), kRounding) << "a driven motion begins at 0";
  EXPECT_LT((points.back() - e3_S(2.5)).norm(), kRounding);
  ASSERT_EQ(list.balls.size(), 1U) << "no arrow ends there: a point does";
  EXPECT_EQ(list.balls[0].center, points.back());
  for (const Vec3& p : points) EXPECT_NEAR(p.norm(), 1.0, kRounding);
  for (int n = 0; n <= 500; ++n) {
    const Vec3 p = e3_S(2.5 * n / 500);
    double nearest = 2.0;
    for (std::size_t i = 1; i < points.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(p, points[i - 1], points[i]));
    EXPECT_LE(nearest, kChordTolerance);
  }
  EXPECT_LE(points.size(), 2100U) << "its cost is bounded";
}

TEST(Marks, ATrailIsSeenFromTheFrameOfTheView) {
  Scene scene = scene_with({.trails = {{space_axis(2), false}}});
  scene.views = {View::space, View::body};
  scene.duration_s = 2.0;
  const SceneModel model = make_model(scene);
  const Figure figure = make_figure(model, 1.0, kAspect);
  EXPECT_TRUE(figure.panes[0].list.ellipsoids.empty());
  for (const Tube& tube : figure.panes[0].list.tubes)
    for (const Vec3& p : tube.points) EXPECT_EQ(p, Vec3::UnitZ()) << "it does not move in space";
  ASSERT_EQ(figure.panes[1].list.tubes.size(), 1U);
  const std::vector<Vec3>& points = figure.panes[1].list.tubes[0].points;
  EXPECT_LT((points.front() - model.motion->at(-1.0).q_SB.conjugate() * Vec3::UnitZ()).norm(), kRounding)
      << "a free motion has no beginning: the trail is as long as the duration";
  EXPECT_LT((points.back() - model.motion->at(1.0).q_SB.conjugate() * Vec3::UnitZ()).norm(), kRounding);
}

TEST(Marks, TheTrailOfAnArrowEndsBehindItsTip) {
  Scene scene =
      scene_with({.trails = {{rate_of_e3(), false}}, .arrows = {{.of = rate_of_e3(), .at = body_axis(2)}}});
  scene.duration_s = 2.0;
  const DrawList list = list_of(scene, 1.5);
  ASSERT_EQ(list.tubes.size(), 1U);
  const double behind = (list.tubes[0].points.back() - list.arrows[0].tip).norm();
  EXPECT_NEAR(behind, list.tubes[0].radius, 0.5 * list.tubes[0].radius);
  EXPECT_TRUE(list.balls.empty());
  EXPECT_EQ(list.tubes[0].color, list.arrows[0].color) << "one vector, one colour";
}

TEST(Marks, AnAngleIsTheArcBetweenTwoDirections) {
  const Scene scene =
      scene_with({.angles = {{space_axis(2), body_axis(2), "\\theta"}, {space_axis(0), body_axis(0), ""}}});
  const DrawList list = list_of(scene, 0.8);
  const Quat q_SB = state_of(scene, 0.8).q_SB;
  ASSERT_EQ(list.meshes.size(), 2U);
  ASSERT_EQ(list.tubes.size(), 6U) << "an arc and two legs each";
  const std::vector<Vec3>& arc = list.tubes[0].points;
  const double radius = arc.front().norm();
  const Vec3 e3_S = q_SB * Vec3::UnitZ();
  EXPECT_LT((arc.front() - radius * Vec3::UnitZ()).norm(), kRounding);
  EXPECT_LT((arc.back() - radius * e3_S).norm(), kRounding);
  const Vec3 normal = Vec3::UnitZ().cross(e3_S);
  double length = 0.0;
  for (std::size_t i = 1; i < arc.size(); ++i) {
    length += (arc[i] - arc[i - 1]).norm();
    EXPECT_NEAR(arc[i].norm(), radius, kRounding);
    EXPECT_NEAR(arc[i].dot(normal), 0.0, kRounding);
  }
  // Chords of an arc of φ in n pieces are short by φ²/24n².
  const double angle_rad = std::acos(e3_S.z());
  EXPECT_NEAR(length, radius * angle_rad, radius * angle_rad * 10.0 / (24 * 64 * 64));
  ASSERT_EQ(list.labels.size(), 1U) << "the second has no name";
  EXPECT_EQ(list.labels[0].text, "$\\theta$");
  EXPECT_GT(list.tubes[3].points.front().norm(), radius) << "the second lies outside the first";
}

TEST(Marks, ARightAngleIsASquare) {
  const Scene scene = scene_with({.angles = {{body_axis(0), body_axis(1), "a"}}});
  const DrawList list = list_of(scene, 0.8);
  ASSERT_EQ(list.tubes.size(), 3U);
  const std::vector<Vec3>& rim = list.tubes[0].points;
  const Vec3 u = rim.front(), v = rim.back();
  EXPECT_NEAR(u.norm(), v.norm(), kRounding);
  EXPECT_NEAR(u.dot(v), 0.0, kRounding);
  double length = 0.0;
  bool has_corner = false;
  for (std::size_t i = 1; i < rim.size(); ++i) {
    length += (rim[i] - rim[i - 1]).norm();
    has_corner = has_corner || (rim[i] - u - v).norm() < kRounding;
  }
  EXPECT_TRUE(has_corner);
  EXPECT_NEAR(length, 2 * u.norm(), 64 * kRounding);
}

TEST(Marks, ANoteWithARoleIsANameInItsColour) {
  const Scene scene = scene_with({.notes = {{"nose", body_axis(2)}, {"tail", body_axis(1), "axis-2"}}});
  const DrawList list = list_of(scene, 0.8);
  ASSERT_EQ(list.labels.size(), 2U);
  EXPECT_TRUE(list.labels[0].leader);
  EXPECT_FALSE(list.labels[1].leader);
  EXPECT_EQ(list.labels[1].color, role_from("axis-2")->ink);
  EXPECT_GT(list.labels[1].size, list.labels[0].size);
}

TEST(Marks, AnAngleIsOutsideTheBody) {
  const Scene scene = scene_with({.angles = {{space_axis(2), body_axis(0), ""}}}, {O::shape});
  for (const Tube& tube : list_of(scene, 0.8).tubes)
    if (tube.points.size() > 60) {
      EXPECT_GT(tube.points.front().norm(), 0.95);
    }
}

TEST(Marks, ParallelVectorsHaveNoAngle) {
  const auto opposite =
      mark_vector("o", [](const RigidBodyState& s) { return Vec3(s.q_SB * Vec3(0, 0, -3)); });
  const auto longer = mark_vector("l", [](const RigidBodyState& s) { return Vec3(s.q_SB * Vec3(0, 0, 5)); });
  const DrawList list =
      list_of(scene_with({.angles = {{body_axis(2), opposite, "a"}, {body_axis(2), longer, "b"}}}), 0.2);
  EXPECT_TRUE(list.tubes.empty() && list.meshes.empty() && list.labels.empty());
}

TEST(Marks, APlaneIsADiscThroughTheTip) {
  const Scene scene =
      scene_with({.planes = {{.normal = body_axis(2), .through = omega_vector()}, {.normal = space_axis(1)}}},
                 {O::omega});
  const SceneModel model = make_model(scene);
  double radius = 0.0;
  for (const double t_s : {0.0, 0.7, 3.1}) {
    const DrawList list = make_figure(model, t_s, kAspect).panes[0].list;
    ASSERT_EQ(list.meshes.size(), 2U);
    const Vec3 n = model.motion->at(t_s).q_SB * Vec3::UnitZ(), tip = list.arrows[0].tip;
    const Vec3 center = tip.dot(n) * n;
    for (const Vec3& p : list.tubes[0].points) {
      EXPECT_NEAR((p - tip).dot(n), 0.0, kRounding);
      if (radius == 0.0) radius = (p - center).norm();
      EXPECT_NEAR((p - center).norm(), radius, kRounding) << "the same at all times";
    }
    EXPECT_LT((tip - center).norm(), radius) << "the tip lies on the disc";
    for (const Vec3& p : list.tubes[1].points) EXPECT_NEAR(p.y(), 0.0, kRounding) << "about the centre";
    EXPECT_LT(list.meshes[0].color.a, 0.5F) << "what lies behind is seen";
  }
}

TEST(Marks, NotesStandAtTips) {
  const DrawList list = list_of(scene_with({.notes = {{"nose, $\\theta$", body_axis(1)}}}), 0.6);
  ASSERT_EQ(list.labels.size(), 1U);
  EXPECT_EQ(list.labels[0].text, "nose, $\\theta$");
  EXPECT_TRUE(list.labels[0].leader);
  EXPECT_NEAR(list.labels[0].anchor.norm(), 1.0, kRounding);
}

TEST(Marks, AreToldApartByColourAndThenByDashes) {
  Marks marks;
  for (int i = 0; i < 6; ++i)
    marks.arrows.push_back({mark_vector("v" + std::to_string(i), [i](const RigidBodyState&) {
      return Vec3(std::cos(i), std::sin(i), 0.2);
    })});
  const DrawList list = list_of(scene_with(std::move(marks)), 0.0);
  ASSERT_EQ(list.arrows.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(list.arrows[i].color == list.arrows[k].color &&
                   list.arrows[i].dash == list.arrows[k].dash);
}

TEST(Marks, AllOfThemLieInThePicture) {
  Scene scene = scene_with({.arrows = {{.of = rate_of_e3(), .at = body_axis(2), .length = 3.0}}});
  scene.duration_s = 6.4;
  for (const double aspect : {kAspect, 0.75}) {
    const SceneModel model = make_model(scene);
    for (int n = 0; n <= 64; ++n) {
      const Pane pane = make_figure(model, 0.1 * n, aspect).panes[0];
      for (const Arrow& arrow : pane.list.arrows) {
        const auto at = project(pane.camera, arrow.tip, aspect, 1.0);
        ASSERT_TRUE(at);
        EXPECT_TRUE(at->x() > 0 && at->x() < aspect && at->y() > 0 && at->y() < 1) << n;
      }
    }
  }
}

TEST(Marks, LeaveAHandOnOmegaWhereItIs) {
  Scene scene = scene_with({.arrows = {{.of = rate_of_e3(), .like = omega_vector()}}}, {O::omega});
  const SceneModel model = make_model(scene);
  TrialOmega trial(model, 0, kAspect);
  const Vec3 other(1.2, -0.4, 0.9);
  const auto tried = trial.at(other);
  scene.camera = held_by_hand(scene);  // a frame and a scale that stay as they were
  scene.w0_B = other;
  const auto made = drawn_omega(make_model(scene), 0.0, 0, kAspect);
  ASSERT_TRUE(tried && made);
  EXPECT_EQ(tried->tip_V, made->tip_V);
  EXPECT_EQ(tried->camera.eye, made->camera.eye);
}

TEST(Marks, AreNotDrawnOnABodyThatIsTurnedByHand) {
  const Scene scene = scene_with({.arrows = {{body_axis(2)}}}, {O::turn_orders});
  for (const Pane& pane : make_figure(make_model(scene), 0.1, kAspect).panes)
    EXPECT_TRUE(std::none_of(pane.list.labels.begin(), pane.list.labels.end(),
                             [](const Label& label) { return label.text == "$e_3$"; }));
}

}  // namespace
}  // namespace polhode
