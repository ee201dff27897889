// SPDX-License-Identifier: MIT
#include "render/figure/pane_fit.h"

#include "render/figure/make_figure.h"
#include "render/figure/orbit_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace polhode {
namespace {

using builders::ball_at;
using builders::Extents;
using O = Overlay;

/// Where points lie in a pane, in parts of its height: x from 0 to the aspect, y from 0 to 1.
struct Seen {
  double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;

  void add(const Camera& camera, const Vec3& point, double aspect) {
    const auto at = project(camera, point, aspect, 1.0);
    ASSERT_TRUE(at);
    x0 = std::min(x0, at->x()), x1 = std::max(x1, at->x());
    y0 = std::min(y0, at->y()), y1 = std::max(y1, at->y());
  }
  void add_ball(const Camera& camera, const Vec3& center, const Mat3& spread, double aspect) {
    constexpr int kPoints = 80;
    for (int i = 0; i < kPoints; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / kPoints, r = std::sqrt(1.0 - z * z), turn = 2.39996323 * i;
      add(camera, center + spread * Vec3(r * std::cos(turn), r * std::sin(turn), z), aspect);
    }
  }
  bool lies_within(double aspect, double margin) const {
    return x0 >= aspect * margin && x1 <= aspect * (1 - margin) && y0 >= margin && y1 <= 1 - margin;
  }
  /// The part of the pane that is used, in the direction in which that is more.
  double filled(double aspect) const { return std::max((x1 - x0) / aspect, y1 - y0); }
};

/// All that has an extent; names are placed within the frame when they are drawn.
void add_all(const Pane& pane, double aspect, Seen& seen) {
  for (const Tube& tube : pane.list.tubes)
    for (const Vec3& p : tube.points) seen.add(pane.camera, p, aspect);
  for (const Arrow& arrow : pane.list.arrows)
    for (const Vec3& p : {arrow.tail, arrow.tip}) seen.add(pane.camera, p, aspect);
  for (const Ball& ball : pane.list.balls) seen.add(pane.camera, ball.center, aspect);
  for (const Mesh& mesh : pane.list.meshes)
    for (const Vec3& p : mesh.positions) seen.add(pane.camera, p, aspect);
  for (const GlassEllipsoid& e : pane.list.ellipsoids)
    seen.add_ball(pane.camera, e.center, e.rotation.toRotationMatrix() * e.semi_axes.asDiagonal(), aspect);
}

struct Case {
  std::string name;
  Scene scene;
};

Scene scene_with(OverlaySet show, std::vector<View> views = {View::space}) {
  Scene scene;
  scene.w0_B = Vec3(0.9, 0.4, 1.0);
  scene.show = show;
  scene.views = std::move(views);
  return scene;
}

std::vector<Case> cases() {
  std::vector<Case> cases = {
      {"Poinsot", scene_with({O::energy_ellipsoid, O::plane, O::omega, O::L, O::polhode, O::herpolhode})},
      {"ellipsoid in the body",
       scene_with({O::energy_ellipsoid, O::omega, O::L, O::polhode_family, O::axes_body, O::labels},
                  {View::body})},
      {"solid", scene_with({O::shape, O::omega, O::L, O::axes_body, O::labels})},
      {"triads", scene_with({O::axes_space, O::axes_body, O::labels})},
      {"momentum space",
       scene_with({O::momentum_ellipsoid, O::momentum_sphere, O::L, O::polhode}, {View::body})},
      {"two views",
       scene_with({O::shape, O::omega, O::L, O::axes_space, O::labels}, {View::space, View::body})},
      {"transport", scene_with({O::transport, O::omega, O::labels})},
      {"terms", scene_with({O::terms, O::L, O::labels}, {View::body})},
      {"trails", scene_with({O::trail_omega, O::trail_L, O::axes_body}, {View::body})},
  };
  Scene rest = scene_with({O::shape, O::axes_body, O::labels});
  rest.w0_B.setZero();
  cases.push_back({"rest", rest});
  Scene thrown = scene_with({O::shape, O::p, O::v, O::F, O::omega, O::labels});
  thrown.body = *find_body("book");
  thrown.v0_S = Vec3(1.2, 0.4, 2.0);
  thrown.F_S = Vec3(0, 0, -9.81 * thrown.body.mass_kg);
  thrown.duration_s = 0.4;
  cases.push_back({"thrown", thrown});
  Scene driven = scene_with({O::energy_ellipsoid, O::omega, O::L, O::N, O::axes_space, O::labels});
  driven.torque = {SpaceTorque{Vec3(0.2, 0.0, 0.1)}};
  driven.duration_s = 6.0;
  cases.push_back({"driven", driven});
  return cases;
}

constexpr double kTimes = 10;

TEST(PaneFit, HoldsAllThatIsDrawnAtEveryTimeOfTheFilm) {
  constexpr double kMargin = 0.01;  // of the frame's own, which is for halves of lines and for names
  for (const auto& [name, scene] : cases())
    for (const double aspect : {16.0 / 9.0, 0.7}) {
      const SceneModel model = make_model(scene);
      for (int n = 0; n <= kTimes; ++n) {
        const Figure figure = make_figure(model, model.span_s * n / kTimes, aspect);
        for (const Pane& pane : figure.panes) {
          const double own = aspect * pane.width / pane.height;
          Seen seen;
          add_all(pane, own, seen);
          ASSERT_TRUE(seen.lies_within(own, kMargin))
              << name << " in " << aspect << ", part " << n << ": " << seen.x0 / own << ' ' << seen.x1 / own
              << ' ' << seen.y0 << ' ' << seen.y1;
        }
      }
    }
}

TEST(PaneFit, IsFilledByTheFilm) {
  constexpr double kLeast = 0.6;
  for (const auto& [name, scene] : cases())
    for (const double aspect : {16.0 / 9.0, 0.7}) {
      const SceneModel model = make_model(scene);
      const std::size_t panes = scene.views.size();
      std::vector<Seen> seen(panes);
      for (int n = 0; n <= kTimes; ++n) {
        const Figure figure = make_figure(model, model.span_s * n / kTimes, aspect);
        for (std::size_t k = 0; k < panes; ++k)
          // In axes of the first camera: that of a body that flies goes along with it.
          add_all(figure.panes[k], aspect / static_cast<double>(panes), seen[k]);
      }
      double filled = 0;
      for (const Seen& one : seen) filled = std::max(filled, one.filled(aspect / static_cast<double>(panes)));
      EXPECT_GT(filled, kLeast) << name << " in " << aspect;
    }
}

TEST(PaneFit, OfABallIsExact) {  // the outline of a ball that is not in the middle of the view is wider
  const CameraSpec spec{.azimuth_rad = 0.7, .elevation_rad = 0.4, .distance = 2.2};
  const Extents extents = {ball_at({0.3, -0.2, 0.5}, 0.6), ball_at({-0.5, 0.4, -0.1}, 0.2)};
  const PaneMargins margins{.side = 0.02, .top = 0.1, .bottom = 0.04};
  for (const double aspect : {2.0, 0.5}) {
    const Camera camera = fitted_camera(pane_fit(extents, spec, aspect, margins), spec);
    double left = 1, right = 0, top = 1, bottom = 0;
    for (const auto& extent : extents)
      for (int k = 0; k < 20000; ++k) {
        const double z = 1.0 - (2.0 * k + 1.0) / 20000, r = std::sqrt(1.0 - z * z), turn = 2.39996323 * k;
        const auto at =
            project(camera, extent.center + extent.spread * Vec3(r * std::cos(turn), r * std::sin(turn), z),
                    1.0 * aspect, 1.0);
        ASSERT_TRUE(at);
        left = std::min(left, at->x() / aspect), right = std::max(right, at->x() / aspect);
        top = std::min(top, at->y()), bottom = std::max(bottom, at->y());
      }
    constexpr double kSpacing = 2e-3;  // of the points on the balls
    EXPECT_GT(left, margins.side - 1e-12);
    EXPECT_LT(right, 1 - margins.side + 1e-12);
    EXPECT_GT(top, margins.top - 1e-12);
    EXPECT_LT(bottom, 1 - margins.bottom + 1e-12);
    const double across = left + 1 - right - 2 * margins.side,
                 upright = top + 1 - bottom - margins.top - margins.bottom;
    EXPECT_LT(std::min(across, upright), kSpacing) << "one direction is full";
    EXPECT_NEAR(left - margins.side, 1 - margins.side - right, kSpacing) << "as much is free on both sides";
    EXPECT_NEAR((0.5 - top) / (0.5 - margins.top), (bottom - 0.5) / (0.5 - margins.bottom), kSpacing / 0.4)
        << "of each half as large a part is filled";
  }
}

/// Size of a unit at the middle of the frame, in parts of the picture's height.
double scale_of(const Camera& camera) {
  return 0.5 / (std::tan(0.5 * camera.fov_y_rad) * (camera.eye - camera.target).norm());
}

TEST(PaneFit, TurningTheCameraKeepsTheScale) {
  Scene scene = scene_with({O::shape, O::omega, O::L, O::axes_space, O::labels});
  const Camera before = make_figure(make_model(scene), 0.0, 1.2).panes[0].camera;
  scene.camera.fitted = CameraFit{scene.camera.azimuth_rad, scene.camera.elevation_rad};
  scene.camera.azimuth_rad += 1.0;
  scene.camera.elevation_rad = -0.6;
  const Camera turned = make_figure(make_model(scene), 0.0, 1.2).panes[0].camera;
  EXPECT_NEAR(scale_of(turned), scale_of(before), 1e-12 * scale_of(before));
  EXPECT_LT((turned.target - before.target).norm(), 1e-12);
  scene.camera.fitted.reset();
  const Camera fitted = make_figure(make_model(scene), 0.0, 1.2).panes[0].camera;
  EXPECT_GT(std::abs(scale_of(fitted) / scale_of(before) - 1), 0.01) << "it can fail";
}

TEST(PaneFit, ZoomIsOfTheFrameAndDistanceIsNot) {
  Scene scene = scene_with({O::energy_ellipsoid, O::omega}, {View::body});
  const double plain = scale_of(make_figure(make_model(scene), 0.0, 1.0).panes[0].camera);
  scene.camera.zoom = 1.5;
  const double zoomed = scale_of(make_figure(make_model(scene), 0.0, 1.0).panes[0].camera);
  EXPECT_NEAR(zoomed / plain, 1.5, 1e-9);
  scene.camera.zoom = 1.0;
  // Far away there is no perspective, and the ellipsoid, with its middle in the middle, looks a little
  // larger.
  scene.camera.distance = 50.0;
  const double far = scale_of(make_figure(make_model(scene), 0.0, 1.0).panes[0].camera);
  EXPECT_GT(far / plain, 1.0);
  EXPECT_LT(far / plain, 1.1);
  scene.camera.distance = 0.1;  // among what is shown: the eye stands outside all the same
  Seen seen;
  add_all(make_figure(make_model(scene), 0.0, 1.0).panes[0], 1.0, seen);
  EXPECT_TRUE(seen.lies_within(1.0, 0.0));
}

TEST(PaneFit, OfTheStillIsFilledByItAtAnyTime) {
  Scene scene = scene_with({O::omega, O::L, O::axes_body, O::labels});
  scene.at_s = 2.0;
  const auto seen_at_still = [&] {
    Seen seen;
    add_all(make_figure(make_model(scene), scene.at_s, 1.0).panes[0], 1.0, seen);
    return seen;
  };
  const double film = seen_at_still().filled(1.0);
  scene.camera.holds_still = true;
  EXPECT_TRUE(seen_at_still().lies_within(1.0, 0.01));
  EXPECT_GT(seen_at_still().filled(1.0), 1.1 * film);
  const SceneModel model = make_model(scene);
  const Camera still = make_figure(model, scene.at_s, 1.0).panes[0].camera,
               later = make_figure(model, scene.at_s + 1.3, 1.0).panes[0].camera;
  EXPECT_EQ(later.eye, still.eye);
  EXPECT_EQ(later.fov_y_rad, still.fov_y_rad);
}

TEST(PaneFit, ViewsBesideOneAnotherHaveOneScale) {
  const Scene scene = scene_with({O::shape, O::axes_space, O::labels}, {View::space, View::body});
  const Figure figure = make_figure(make_model(scene), 0.3, 2.0);
  EXPECT_NEAR(scale_of(figure.panes[0].camera), scale_of(figure.panes[1].camera), 1e-12);
}

}  // namespace
}  // namespace polhode
