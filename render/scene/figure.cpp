// SPDX-License-Identifier: MIT
#include "render/scene/figure.h"

#include "physics/euler.h"
#include "render/scene/builders/builders.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace builders {
namespace {

bool shows_momentum_space(const OverlaySet& show) {
  return show.contains(Overlay::momentum_sphere) || show.contains(Overlay::momentum_ellipsoid);
}

/// ω-space is drawn with the energy ellipsoid's longest semi-axis at 1. Around a solid body alone ω is drawn
/// a little longer than the body, so that its tip can be seen.
double omega_scale_of(const Scene& scene) {
  constexpr double kBesideSolid = 1.15;
  const double speed = scene.w0_B.norm();
  if (speed == 0.0) return 1.0;
  if (scene.show.contains(Overlay::shape) && !scene.show.contains(Overlay::energy_ellipsoid))
    return kBesideSolid / speed;
  const double two_T = 2.0 * kinetic_energy(scene.body.moments, scene.w0_B);
  return 1.0 / energy_ellipsoid_semi_axes(scene.body.moments, two_T).maxCoeff();
}

double L_scale_of(const Scene& scene) {
  if (!shows_momentum_space(scene.show) || scene.w0_B.isZero(0.0)) return 0.0;
  const double two_T = 2.0 * kinetic_energy(scene.body.moments, scene.w0_B);
  const double L = angular_momentum_B(scene.body.moments, scene.w0_B).norm();
  return 1.0 / std::max(L, momentum_ellipsoid_semi_axes(scene.body.moments, two_T).maxCoeff());
}

/// A fixed length along the direction of L: past the plane where there is one, so that one sees it stand
/// upright.
double L_length_of(const Scene& scene, double omega_scale, double L_scale) {
  constexpr double kLength = 1.3;
  constexpr double kPastThePlane = 0.42;
  const PrincipalMoments& I = scene.body.moments;
  if (scene.w0_B.isZero(0.0)) return kLength;
  if (L_scale > 0.0) return L_scale * angular_momentum_B(I, scene.w0_B).norm();
  if (!scene.show.contains(Overlay::plane)) return kLength;
  return invariable_plane_distance(I, scene.w0_B) * omega_scale + kPastThePlane;
}

}  // namespace

Vec3 Moment::L_drawn_B(const Vec3& any_L_B) const {
  if (model.L_reference == 0.0) return Vec3::Zero();
  return any_L_B * (L_length / model.L_reference);
}

double Moment::emphasis(Overlay o) const {
  const std::vector<std::string>& stressed = model.scene.highlight;
  return std::find(stressed.begin(), stressed.end(), name_of(o)) == stressed.end() ? 1.0 : 1.5;
}

Moment moment_at(const SceneModel& model, double t_s, View view) {
  const Scene& scene = model.scene;
  RigidBodyState state{Quat::Identity(), scene.w0_B};
  if (model.needs.attitude)
    state = model.motion->at(t_s);
  else if (model.needs.omega)
    state.w_B = model.motion->w_B_at(t_s);

  const bool space = view == View::space;
  const double omega_scale = omega_scale_of(scene);
  const double L_scale = L_scale_of(scene);
  return {.model = model,
          .t_s = t_s,
          .view = view,
          .state = state,
          .q_VB = space ? state.q_SB : Quat::Identity(),
          .q_VS = space ? Quat::Identity() : state.q_SB.conjugate(),
          .L_B = angular_momentum_B(scene.body.moments, state.w_B),
          .two_T = 2.0 * kinetic_energy(scene.body.moments, state.w_B),
          .N_B = torque_B(scene.torque, scene.body.moments, state),
          .omega_scale = omega_scale,
          .L_scale = L_scale,
          .L_length = L_length_of(scene, omega_scale, L_scale),
          .thickness = scene.views.size() > 1 ? 1.15 : 1.0};
}

}  // namespace builders

namespace {

/// How far from the centre there is something to see, with its label.
double reach_of(const builders::Moment& m) {
  constexpr double kLabel = 0.1;
  double reach = 1.0;
  if (m.shows(Overlay::axes_space) || m.shows(Overlay::axes_body)) reach = builders::kTriadLength + kLabel;
  if (m.shows(Overlay::omega) || m.shows(Overlay::trail_omega))
    reach = std::max(reach, m.model.scene.w0_B.norm() * m.omega_scale + kLabel);
  if (m.shows(Overlay::L)) reach = std::max(reach, m.L_length + kLabel);
  if (m.shows(Overlay::N) && !m.model.scene.torque.empty()) reach = std::max(reach, m.L_length + 0.3);
  return reach;
}

/// Enough room for what is shown, and the floor below. Nothing here depends on t, so that the camera stands
/// still.
Camera camera_for(const builders::Moment& m, double aspect) {
  constexpr double kFilled = 1.16;     // radius that fills the height of a picture at the default distance
  constexpr double kNarrowest = 1.15;  // a pane narrower than this needs more distance to hold the figure
  const Scene& scene = m.model.scene;
  const bool floor = m.view == View::space && m.shows(Overlay::plane);
  constexpr double kLift = 0.2;  // arrows and axes point up: the middle of it all lies above the centre
  const bool upward = m.shows(Overlay::L) || m.shows(Overlay::axes_space) || m.shows(Overlay::axes_body);
  const double reach = reach_of(m);
  const Vec3 target(0.0, 0.0, floor ? 0.4 * builders::plane_z(m) : upward ? kLift * reach : 0.0);
  CameraSpec spec = scene.camera;
  spec.distance *= std::max(1.0, kNarrowest / aspect);
  // With a floor L points down, so that only the space axes stand out above.
  const double above = m.shows(Overlay::axes_space) ? reach - target.z() - 0.15 : 1.0;
  return orbit(spec, target, std::max(1.0, (floor ? above : reach) / kFilled));
}

Pane make_pane(const SceneModel& model, double t_s, View view, double aspect) {
  const builders::Moment m = builders::moment_at(model, t_s, view);
  Pane pane;
  pane.camera = camera_for(m, aspect);
  builders::add_surfaces(m, pane.list);
  builders::add_solid(m, pane.list);
  builders::add_curves(m, pane.list);
  builders::add_trails(m, pane.list);
  builders::add_cones(m, pane.list);
  builders::add_axes(m, pane.list);
  builders::add_vectors(m, pane.list);
  if (m.shows(Overlay::labels)) builders::add_labels(m, pane.camera, pane.list);
  return pane;
}

std::string title_of(View view) { return view == View::space ? "space frame $S$" : "body frame $S^*$"; }

}  // namespace

Figure make_figure(const SceneModel& model, double t_s, double aspect) {
  Figure figure;
  figure.caption = model.scene.caption;
  const auto count = static_cast<double>(std::max<std::size_t>(model.scene.views.size(), 1));
  double x = 0.0;
  for (View view : model.scene.views) {
    Pane pane = make_pane(model, t_s, view, aspect / count);
    pane.x = x;
    pane.width = 1.0 / count;
    if (count > 1.0) pane.title = title_of(view);
    x += pane.width;
    figure.panes.push_back(std::move(pane));
  }
  if (!figure.panes.empty() && model.drawn.contains(Overlay::values))
    builders::add_values(builders::moment_at(model, t_s, model.scene.views.front()),
                         figure.panes.front().list);
  return figure;
}

}  // namespace polhode
