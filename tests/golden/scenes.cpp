// SPDX-License-Identifier: MIT
#include "tests/golden/scenes.h"

#include "tests/support/mark_vectors.h"

#include <numbers>

namespace polhode::golden {
namespace {

using O = Overlay;

constexpr double degrees(double d) { return d * std::numbers::pi / 180.0; }

Scene base(const Vec3& w0_B, double at_s, OverlaySet show) {
  Scene scene;
  scene.w0_B = w0_B;
  scene.at_s = at_s;
  scene.show = show;
  return scene;
}

Scene with_body(Scene scene, const char* name) {
  scene.body = find_body(name).value();
  return scene;
}

Scene with_camera(Scene scene, double azimuth_deg, double elevation_deg, double distance) {
  scene.camera = {
      .azimuth_rad = degrees(azimuth_deg), .elevation_rad = degrees(elevation_deg), .distance = distance};
  return scene;
}

Scene with_views(Scene scene, std::vector<View> views) {
  scene.views = std::move(views);
  return scene;
}

Scene with_torque(Scene scene, TorqueTerm term) {
  scene.torque = {term};
  return scene;
}

Scene given_attitude(Scene scene, const Quat& q_SB) {
  scene.attitude = q_SB;
  return scene;
}

Scene translating(Scene scene, const Vec3& v0_S, const Vec3& F_S, double duration_s) {
  scene.v0_S = v0_S;
  scene.F_S = F_S;
  scene.duration_s = duration_s;
  return scene;
}

Scene with_arrow(Scene scene, ArrowHeld held) {
  scene.arrow = held;
  return scene;
}

Scene with_ghost(Scene scene, Method method, double step_s) {
  scene.motion = {.method = method, .step_s = step_s, .ghost = true};
  return scene;
}

/// A disc of 1 kg on an axle of 10 cm, in steady precession.
Scene gyroscope_on_its_stand() {
  Scene scene =
      with_torque(base({0.0, 3.84, 51.8407}, 0.7, {O::shape, O::pivot, O::L, O::N, O::trail_L, O::labels}),
                  HeavyTop{0.980665, Vec3(0.0, 0.0, 1.0)});
  scene.body = {"gyroscope", PrincipalMoments(0.0125333, 0.0125333, 0.005), std::nullopt};
  scene.duration_s = 0.7;
  return with_camera(given_attitude(scene, Quat(0.8, 0.6, 0.0, 0.0)), 24, 18, 3.6);
}

/// The gyroscope let go: its axis nutates, with cusps. One mark of each kind.
Scene marked_gyroscope() {
  Scene scene = gyroscope_on_its_stand();
  scene.w0_B = Vec3(0.0, 0.0, 60.0);
  scene.show = {O::shape, O::pivot};
  scene.duration_s = scene.at_s = 0.9;
  scene.marks = {.trails = {{.of = test::body_axis(2), .on_sphere = true}},
                 .arrows = {{.of = test::body_axis(2)}, {.of = test::rate_of_e3(), .at = test::body_axis(2)}},
                 .angles = {{.from = test::space_axis(2), .to = test::body_axis(2), .tex = "\\theta"}},
                 .planes = {{.normal = test::space_axis(2), .through = test::body_axis(2)}},
                 .notes = {{.text = "tip of $\\hat e_3$", .at = test::body_axis(2)}}};
  return scene;
}

const Vec3 kGeneric(0.2, 1.1, 1.6);

}  // namespace

const char* name_of(Mutation mutation) {
  switch (mutation) {
    case Mutation::later:
      return "one frame later";
    case Mutation::camera:
      return "camera turned by half a degree";
    case Mutation::overlay:
      return "one overlay removed";
    case Mutation::color:
      return "one colour changed";
    case Mutation::attitude:
      return "attitude inverted";
  }
  return "";
}

std::vector<Golden> all() {
  const Exception no_attitude{Mutation::attitude,
                              "the body view of a free body shows nothing of the attitude"};
  return {
      {"axes-two-frames",
       base(kGeneric, 0.9, {O::shape, O::axes_body, O::axes_space, O::labels}),
       "paper",
       O::axes_space,
       {}},
      {"book-space-and-body",
       with_views(with_body(base({0.3, 3.0, 0.1}, 1.7, {O::shape, O::omega, O::L, O::labels}), "book"),
                  {View::space, View::body}),
       "studio",
       O::L,
       {}},
      {"color-backdrop",
       base(kGeneric, 2.1, {O::energy_ellipsoid, O::omega, O::L, O::labels}),
       "#20242C",
       O::omega,
       {}},
      {"cones-of-a-disc",
       with_body(base({1.2, 0.0, 2.4}, 0.8, {O::shape, O::cones, O::omega, O::L, O::labels}), "disc"),
       "studio",
       O::cones,
       {}},
      {"driven-t-handle",
       with_torque(with_body(base({0.2, 3.0, 0.3}, 0.7,
                                  {O::shape, O::omega, O::L, O::N, O::trail_L, O::axes_space, O::labels}),
                             "t-handle"),
                   SpaceTorque{Vec3(4e-4, 0.0, 0.0)}),
       "studio",
       O::N,
       {}},
      {"ellipsoid-solid",
       with_body(base({0.5, 1.5, 0.4}, 1.1, {O::shape, O::omega, O::trail_omega, O::labels}), "ellipsoid"),
       "studio",
       O::trail_omega,
       {}},
      {"family-in-the-body",
       with_views(base(kGeneric, 1.3,
                       {O::energy_ellipsoid, O::polhode, O::polhode_family, O::separatrix, O::omega,
                        O::axes_body, O::labels, O::values}),
                  {View::body}),
       "studio",
       O::separatrix,
       {no_attitude}},
      {"from-below",
       with_camera(base(kGeneric, 0.6, {O::energy_ellipsoid, O::omega, O::L, O::herpolhode, O::plane}), 40,
                   -25, 4.6),
       "studio",
       O::herpolhode,
       {}},
      {"ghost-of-the-exact-body",
       with_ghost(with_body(base({0.1, 3.0, 0.1}, 15.0, {O::shape, O::omega, O::L, O::labels}), "t-handle"),
                  Method::rk4, 0.5),
       "studio",
       O::L,
       {}},
      {"given-attitude",
       given_attitude(
           base({2.0, 0.3, 0.2}, 1.9, {O::energy_ellipsoid, O::omega, O::L, O::axes_space, O::labels}),
           Quat(0.8, 0.1, 0.5, -0.3).normalized()),
       "white",
       O::axes_space,
       {}},
      {"gyroscope",
       given_attitude(
           with_torque(with_body(base({0.0, 0.0, 30.0}, 0.9,
                                      {O::shape, O::L, O::N, O::trail_L, O::axes_space, O::labels}),
                                 "disc"),
                       HeavyTop{0.03, Vec3(0.0, 0.0, 1.0)}),
           Quat(Eigen::AngleAxisd(degrees(65), Vec3::UnitX()))),
       "studio",
       O::trail_L,
       {}},
      {"gyroscope-on-its-stand", gyroscope_on_its_stand(), "studio", O::pivot, {}},
      {"marks-of-a-gyroscope", marked_gyroscope(), "studio", O::pivot, {}},
      {"momentum-space",
       with_views(base(kGeneric, 1.0,
                       {O::momentum_sphere, O::momentum_ellipsoid, O::L, O::polhode, O::labels, O::values}),
                  {View::body}),
       "studio",
       O::momentum_ellipsoid,
       {no_attitude}},
      {"needle-on-the-plane",
       with_body(base({3.0, 0.4, 0.5}, 0.4, {O::energy_ellipsoid, O::omega, O::L, O::polhode, O::plane}),
                 "needle"),
       "studio",
       O::energy_ellipsoid,
       {{Mutation::color, "the arrow of ω is shorter than the ball at its tail"}}},
      {"poinsot",
       base(kGeneric, 1.1,
            {O::energy_ellipsoid, O::omega, O::L, O::polhode, O::polhode_family, O::separatrix, O::herpolhode,
             O::plane, O::axes_body, O::labels, O::values}),
       "studio",
       O::polhode_family,
       {}},
      {"puck-beside-a-body",
       translating(
           with_camera(base({0.9, 0.0, 1.6}, 1.8, {O::shape, O::omega, O::L, O::puck, O::p, O::v, O::labels}),
                       50, 20, 3.6),
           Vec3(3.0, 0.3, 0.0), Vec3::Zero(), 3.0),
       "studio",
       O::p,
       {}},
      {"room-in-two-frames",
       with_views(with_body(base({0.3, 3.0, 0.1}, 1.7, {O::shape, O::L, O::room, O::labels}), "book"),
                  {View::space, View::body}),
       "paper",
       O::room,
       {}},
      {"slender-rod",
       with_body(base({0.1, 0.0, 200.0}, 0.013, {O::shape, O::omega, O::L, O::labels}), "slender-rod"),
       "studio",
       O::omega,
       {}},
      {"sphere",
       with_body(base({0.4, 0.2, 1.0}, 1.5, {O::shape, O::omega, O::L, O::axes_body, O::labels}), "sphere"),
       "studio",
       O::axes_body,
       {}},
      {"surfaces-meet",
       with_views(
           base(kGeneric, 0.7, {O::energy_ellipsoid, O::momentum_sphere, O::omega, O::polhode, O::labels}),
           {View::body}),
       "studio",
       O::momentum_sphere,
       {no_attitude}},
      {"terms-of-a-driven-body",
       with_camera(
           with_torque(base({0.9, 0.7, 1.0}, 0.5, {O::terms, O::omega, O::L, O::axes_body, O::labels}),
                       SpaceTorque{Vec3(0.3, -1.4, 0.4)}),
           120, 24, 3.6),
       "studio",
       O::terms,
       {}},
      {"thrown-book",
       translating(with_camera(with_body(base({1.0, 9.0, 2.0}, 0.25,
                                              {O::shape, O::p, O::v, O::F, O::axes_space, O::labels}),
                                         "book"),
                               12, 10, 3.8),
                   Vec3(0.3, 1.5, 2.0), Vec3(0.0, 0.0, -7.845), 0.36),
       "studio",
       O::F,
       {}},
      {"trail-in-the-body",
       with_views(
           base({0.3, 0.2, 2.0}, 1.2, {O::energy_ellipsoid, O::L, O::trail_L, O::axes_space, O::labels}),
           {View::body}),
       "studio",
       O::trail_L,
       {}},
      {"transparent-poinsot",
       base(kGeneric, 2.4, {O::energy_ellipsoid, O::omega, O::polhode, O::plane, O::labels}),
       "transparent",
       O::plane,
       {}},
      {"transport-triangle",
       with_arrow(with_views(with_camera(base({1.25, 0.4, 0.9}, 1.2, {O::transport, O::omega, O::labels}),
                                         246, 28, 3.7),
                             {View::space, View::body}),
                  ArrowHeld::free),
       "studio",
       O::transport,
       {}},
      {"two-orders-of-turning",
       given_attitude(
           with_body(base({0.0, 0.0, 0.2}, 24.0, {O::turn_orders, O::axes_space, O::labels}), "book"),
           Quat(0.96, 0.2, 0.0, 0.2).normalized()),
       "studio",
       O::axes_space,
       {}},
  };
}

}  // namespace polhode::golden
