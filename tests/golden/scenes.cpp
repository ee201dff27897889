// SPDX-License-Identifier: MIT
#include "tests/golden/scenes.h"

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

Scene captioned(Scene scene, const char* caption) {
  scene.caption = caption;
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
       captioned(base(kGeneric, 1.1,
                      {O::energy_ellipsoid, O::omega, O::L, O::polhode, O::polhode_family, O::separatrix,
                       O::herpolhode, O::plane, O::axes_body, O::labels, O::values}),
                 "The ellipsoid rolls on the invariable plane"),
       "studio",
       O::polhode_family,
       {}},
      {"slender-rod",
       with_body(base({0.1, 0.0, 200.0}, 0.013, {O::shape, O::omega, O::L, O::labels}), "slender-rod"),
       "studio",
       O::omega,
       {{Mutation::later, "a frame is 0.16 ms, in which the rod turns by 1e-5 rad"}}},
      {"sphere",
       with_body(base({0.4, 0.2, 1.0}, 1.5, {O::shape, O::omega, O::L, O::axes_body, O::labels}), "sphere"),
       "studio",
       O::axes_body,
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
  };
}

}  // namespace polhode::golden
