// SPDX-License-Identifier: MIT
#include "render/figure/make_figure.h"

#include "base/words/figure_words.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/figure/builders/builders.h"
#include "render/figure/builders/extents.h"
#include "render/figure/omega_tip.h"
#include "render/figure/orbit_camera.h"
#include "render/figure/pane_fit.h"
#include "render/scene/model/translation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace builders {
namespace {

/// |L| = const beside the energy ellipsoid is drawn in ω-space, where it is an ellipsoid too.
bool shows_momentum_space(const OverlaySet& show) {
  return show.contains(Overlay::momentum_ellipsoid) ||
         (show.contains(Overlay::momentum_sphere) && !show.contains(Overlay::energy_ellipsoid));
}

/// That which the picture is fitted to: a hand may have taken another since.
const Vec3& fitted_w0_B(const Scene& scene) {
  const std::optional<CameraFit>& kept = scene.camera.fitted;
  return kept && kept->w0_B ? *kept->w0_B : scene.w0_B;
}

/// ω-space is drawn with the energy ellipsoid's longest semi-axis at 1. Around a solid body alone ω is drawn
/// a little longer than the body, so that its tip can be seen. In a frame that is kept from another ω its
/// scale is kept too.
double omega_scale_of(const Scene& scene) {
  constexpr double kBesideSolid = 1.15;
  const Vec3& w0_B = fitted_w0_B(scene);
  const double speed = norm_of(w0_B);
  if (speed == 0.0) return 1.0;
  if (scene.show.contains(Overlay::shape) && !scene.show.contains(Overlay::energy_ellipsoid))
    return kBesideSolid / speed;
  return 1.0 / energy_ellipsoid_semi_axes(scene.body.moments, w0_B).maxCoeff();
}

double L_scale_of(const Scene& scene) {
  if (!shows_momentum_space(scene.show) || scene.w0_B.isZero(0.0)) return 0.0;
  const double L = norm_of(angular_momentum_B(scene.body.moments, scene.w0_B));
  return 1.0 / std::max(L, momentum_ellipsoid_semi_axes(scene.body.moments, scene.w0_B).maxCoeff());
}

/// A fixed length along the direction of L: past the plane where there is one, so that one sees it stand
/// upright. That of the ω that the picture is fitted to: what a hand makes of L is longer or shorter than it.
double L_length_of(const Scene& scene, double omega_scale, double L_scale) {
  constexpr double kLength = 1.3;
  constexpr double kPastThePlane = 0.42;
  const PrincipalMoments& I = scene.body.moments;
  const Vec3& w0_B = fitted_w0_B(scene);
  if (w0_B.isZero(0.0)) return kLength;
  if (L_scale > 0.0) return L_scale * norm_of(angular_momentum_B(I, w0_B));
  if (!scene.show.contains(Overlay::plane)) return kLength;
  return invariable_plane_distance(I, w0_B) * omega_scale + kPastThePlane;
}

double L_reference_of(const SceneModel& model) {
  const std::optional<CameraFit>& kept = model.scene.camera.fitted;
  return kept && kept->w0_B ? norm_of(angular_momentum_B(model.scene.body.moments, *kept->w0_B))
                            : model.L_reference;
}

}  // namespace

Vec3 Snapshot::L_drawn_B(const Vec3& any_L_B) const {
  if (L_reference == 0.0) return Vec3::Zero();
  return any_L_B * (L_length / L_reference);
}

double Snapshot::emphasis(Overlay o) const {
  const std::vector<std::string>& stressed = model.scene.highlight;
  return std::find(stressed.begin(), stressed.end(), name_of(o)) == stressed.end() ? 1.0 : 1.5;
}

namespace {

Snapshot snapshot_in(const SceneModel& model, double t_s, View view, const RigidBodyState& state) {
  const Scene& scene = model.scene;
  const bool space = view == View::space;
  const double omega_scale = omega_scale_of(scene);
  const double L_scale = L_scale_of(scene);
  Snapshot m{.model = model,
             .t_s = t_s,
             .view = view,
             .state = state,
             .q_VB = space ? state.q_SB : Quat::Identity(),
             .q_VS = space ? Quat::Identity() : state.q_SB.conjugate(),
             .L_B = angular_momentum_B(scene.body.moments, state.w_B),
             .two_T = 2.0 * kinetic_energy(scene.body.moments, state.w_B),
             .N_B = torque_B(scene.torque, state),
             .omega_scale = omega_scale,
             .L_scale = L_scale,
             .L_length = L_length_of(scene, omega_scale, L_scale),
             .L_reference = L_reference_of(model),
             .thickness = scene.views.size() > 1 ? 1.15 : 1.0};
  m.center_V = center_of_mass_V(m, t_s);
  return m;
}

}  // namespace

Snapshot snapshot_at(const SceneModel& model, double t_s, View view) {
  RigidBodyState state{Quat::Identity(), model.scene.w0_B};
  if (model.needs.attitude)
    state = model.motion->at(t_s);
  else if (model.needs.omega)
    state.w_B = model.motion->w_B_at(t_s);
  return snapshot_in(model, t_s, view, state);
}

}  // namespace builders

namespace {

using builders::Snapshot;

bool translates(const Snapshot& m) {
  return m.view == View::space && (m.shows(Overlay::puck) || drifts(m.model.scene));
}

/// All is drawn about the centre of mass. Where that drifts, the camera goes the other way.
Camera seen_from_center(Camera camera, const Vec3& center_V) {
  camera.eye -= center_V;
  camera.target -= center_V;
  return camera;
}

/// Room for a title above panes that have one.
PaneMargins margins_of(const Snapshot& m) {
  constexpr double kTitle = 0.07;
  PaneMargins margins;
  if (m.turn || m.model.scene.views.size() > 1) margins.top = kTitle;
  return margins;
}

/// Of the still as it is drawn.
builders::Extents extents_of_still(const Snapshot& m) {
  const SceneModel& model = m.model;
  const Snapshot still = builders::snapshot_at(model, still_time_s(model.scene), m.view);
  DrawList list;
  const Camera roughly = orbit(model.scene.camera, Vec3::Zero(), 1.0);
  for (builders::Builder* const add : builders::kBuilders) add(still, roughly, list);
  return builders::extents_of_drawn(list, still.center_V);
}

/// Of a free motion that begins with this ω, as far as its frame needs it.
struct Beginning {
  SceneModel model;  ///< no motion, no curves
  RigidBodyState state;
};
/// `fitted` has an ω.
Beginning beginning_of(const Scene& scene, const CameraFit& fitted) {
  const Vec3& w0_B = *fitted.w0_B;
  Beginning made;
  made.model.scene = scene;
  made.model.scene.w0_B = w0_B;
  if (fitted.attitude) made.model.scene.attitude = fitted.attitude;
  made.model.drawn = drawn_overlays(made.model.scene);
  made.model.needs = requirements(made.model.scene);
  made.state = {problem_of(made.model.scene).start.q_SB, w0_B};
  made.model.q0_SB = made.state.q_SB;
  made.model.L_reference = angular_momentum_B(scene.body.moments, w0_B).stableNorm();
  return made;
}

builders::Extents held_extents(const Snapshot& m) {
  const std::optional<CameraFit>& fitted = m.model.scene.camera.fitted;
  const bool is_kept = fitted && fitted->w0_B;  // of a camera that was fitted anew since, nothing is
  if (is_kept && m.model.framed && !m.turn)
    return held_extents(builders::snapshot_at(*m.model.framed, 0.0, m.view));
  if (is_kept && !m.turn && !frame_needs_motion(m.model.scene)) {
    const Beginning then = beginning_of(m.model.scene, *fitted);
    return builders::extents_of(builders::snapshot_in(then.model, 0.0, m.view, then.state));
  }
  return m.model.scene.camera.holds_still && !m.turn ? extents_of_still(m) : builders::extents_of(m);
}

/// Of what a camera shows at its middle.
double half_height_of(const Camera& camera) {
  return (camera.eye - camera.target).norm() * std::tan(0.5 * camera.fov_y_rad);
}

/// All that the scene shows over its film: nothing here depends on t, so that the camera stands still. Views
/// side by side have one scale.
Camera camera_for(const Snapshot& m, double aspect, double least_half_height) {
  const CameraSpec& spec = m.model.scene.camera;
  const PaneMargins margins = margins_of(m);
  const builders::Extents extents = held_extents(m);
  PaneFit fit = pane_fit(extents, spec, aspect, margins);
  for (const View view : m.model.scene.views) {
    if (view == m.view || m.turn || drifts(m.model.scene)) continue;
    const builders::Extents others = held_extents(builders::snapshot_in(m.model, m.t_s, view, m.state));
    const PaneFit other = pane_fit(others, spec, aspect, margins, fit.radius);
    fit = pane_fit(extents, spec, aspect, margins, other.radius);
    fit.half_tan = std::max(fit.half_tan, other.half_tan);
  }
  if (least_half_height > 0.0)
    fit.half_tan *= std::max(1.0, least_half_height / half_height_of(fitted_camera(fit, spec)));
  const Camera camera = fitted_camera(fit, spec);
  return translates(m) ? seen_from_center(camera, m.center_V) : camera;
}

/// Where little is shown, large, lines and arrows are as thick as elsewhere, beside the picture.
Pane make_pane(builders::Snapshot m, double aspect, double least_half_height) {
  constexpr double kUsualHalfHeight = 1.1, kThinnest = 0.4;
  Pane pane;
  pane.camera = camera_for(m, aspect, least_half_height);
  m.thickness *= std::clamp(half_height_of(pane.camera) / kUsualHalfHeight, kThinnest, 1.0);
  for (builders::Builder* const add : builders::kBuilders) add(m, pane.camera, pane.list);
  return pane;
}

std::string title_of(View view, Language language) {
  return std::string((view == View::space ? words::kSpaceFrame : words::kBodyFrame).in(language));
}

/// The body in its first attitude, turned by two quarters in this order over the scene's span.
builders::Snapshot turned_snapshot(const SceneModel& model, double t_s, TurnOrder order) {
  builders::Snapshot m = builders::snapshot_at(model, t_s, View::space);
  const TurnedBody body = turned(order, model.q0_SB, t_s / model.span_s);
  m.state.q_SB = m.q_VB = body.q_SB;
  m.turn = body.present;
  m.thickness = 1.15;
  return m;
}

/// Side by side, or in an upright picture one above the other.
std::vector<Pane> make_panes_of_orders(const SceneModel& model, double t_s, double aspect,
                                       double least_half_height) {
  constexpr double kCount = kTurnOrders.size();
  const bool stacked = aspect < 1.0;
  std::vector<Pane> panes;
  for (TurnOrder order : kTurnOrders) {
    const double place = static_cast<double>(panes.size()) / kCount;
    Pane pane = make_pane(turned_snapshot(model, t_s, order), stacked ? aspect * kCount : aspect / kCount,
                          least_half_height);
    pane.title = title_of(order).in(model.scene.language);
    (stacked ? pane.y : pane.x) = place;
    (stacked ? pane.height : pane.width) = 1.0 / kCount;
    panes.push_back(std::move(pane));
  }
  return panes;
}

std::vector<Pane> make_panes_of_views(const SceneModel& model, double t_s, double aspect,
                                      double least_half_height) {
  std::vector<Pane> panes;
  const std::vector<View>& views = model.scene.views;
  for (View view : views) {
    panes.push_back(make_pane(builders::snapshot_at(model, t_s, view),
                              aspect / static_cast<double>(views.size()), least_half_height));
    panes.back().x = static_cast<double>(panes.size() - 1) / static_cast<double>(views.size());
    panes.back().width = 1.0 / static_cast<double>(views.size());
    if (views.size() > 1) panes.back().title = title_of(view, model.scene.language);
  }
  return panes;
}

}  // namespace

double own_half_height(const SceneModel& model, double aspect) {
  const Scene& scene = model.scene;
  if (model.drawn.contains(Overlay::turn_orders) || shows_nothing(model.drawn, model.needs.marks)) return 0.0;
  double most = 0.0;
  for (const View view : scene.views)
    most = std::max(most, half_height_of(camera_for(builders::snapshot_at(model, still_time_s(scene), view),
                                                    aspect / static_cast<double>(scene.views.size()), 0.0)));
  return most;
}

double common_half_height(const SceneModel& model, double aspect) {
  if (model.beside.empty()) return 0.0;
  const std::vector<const SceneModel*> shown = shown_models(model);
  const Scene& first = model.scene;
  double most = 0.0;
  for (const SceneModel* one : shown) {
    const Scene& scene = one->scene;
    const bool is_alike = scene.body == first.body && scene.camera.zoom == first.camera.zoom &&
                          scene.views == first.views && !drifts(scene);
    const double own = is_alike ? own_half_height(*one, aspect) : 0.0;
    if (own <= 0.0) return 0.0;
    most = std::max(most, own);
  }
  return most;
}

Figure make_figure(const SceneModel& model, double t_s, double aspect, double least_half_height) {
  Figure figure;
  figure.panes = model.drawn.contains(Overlay::turn_orders)
                     ? make_panes_of_orders(model, t_s, aspect, least_half_height)
                     : make_panes_of_views(model, t_s, aspect, least_half_height);
  if (!figure.panes.empty() && model.drawn.contains(Overlay::values))
    builders::add_values(builders::snapshot_at(model, t_s, model.scene.views.front()),
                         figure.panes.front().list);
  return figure;
}

bool draws_by_arrow(const SceneModel& model, Overlay vector) {
  const std::vector<ArrowMark>& arrows = model.scene.marks.arrows;
  return model.needs.marks && std::any_of(arrows.begin(), arrows.end(), [vector](const ArrowMark& arrow) {
           return is_as_overlay(arrow, vector);
         });
}

bool draws_omega(const SceneModel& model) {
  return model.drawn.contains(Overlay::omega) || draws_by_arrow(model, Overlay::omega);
}

std::optional<DrawnOmega> drawn_omega(const SceneModel& model, double t_s, std::size_t pane, double aspect) {
  const std::vector<View>& views = model.scene.views;
  if (!draws_omega(model) || pane >= views.size()) return std::nullopt;
  const builders::Snapshot m = builders::snapshot_at(model, t_s, views[pane]);
  if (m.state.w_B.isZero(0.0)) return std::nullopt;
  return DrawnOmega{m.omega_tip_V(), camera_for(m, aspect / static_cast<double>(views.size()),
                                                common_half_height(model, aspect))};
}

std::vector<DrawnOmega> drawn_otherwise(const SceneModel& model, double t_s, std::size_t pane,
                                        double aspect) {
  std::vector<DrawnOmega> tips;
  const std::vector<View>& views = model.scene.views;
  const std::vector<ArrowMark>& arrows = model.scene.marks.arrows;
  if (!model.needs.marks || pane >= views.size()) return tips;
  const builders::Snapshot m = builders::snapshot_at(model, t_s, views[pane]);
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    if (arrows[i].of.overlay != Overlay::omega || is_as_overlay(arrows[i], Overlay::omega)) continue;
    if (const auto tip_V = builders::tip_of_arrow_V(m, i))
      tips.push_back({*tip_V, camera_for(m, aspect / static_cast<double>(views.size()),
                                         common_half_height(model, aspect))});
  }
  return tips;
}

CameraSpec held_by_hand(const Scene& scene) {
  CameraSpec camera = scene.camera;
  if (!camera.fitted) camera.fitted = CameraFit{camera.azimuth_rad, camera.elevation_rad};
  if (!camera.fitted->w0_B) {
    camera.fitted->w0_B = scene.w0_B;
    camera.fitted->attitude = attitude_spec(scene);
  }
  return camera;
}

TrialOmega::TrialOmega(const SceneModel& model, std::size_t pane, double aspect,
                       const std::optional<AttitudeSpec>& attitude, const std::optional<CameraSpec>& camera)
    : pane_(pane) {
  trial_.scene = model.scene;
  trial_.scene.camera = camera ? *camera : held_by_hand(model.scene);
  if (attitude) trial_.scene.attitude = attitude;
  trial_.drawn = drawn_overlays(trial_.scene);
  trial_.needs = requirements(trial_.scene);
  if (pane >= trial_.scene.views.size()) return;
  const CameraFit fitted = *trial_.scene.camera.fitted;
  const bool is_zoomed_alike = trial_.scene.camera.zoom == model.scene.camera.zoom;
  const double least_half_height = is_zoomed_alike ? common_half_height(model, aspect) : 0.0;
  const auto frame_of = [&](const Snapshot& held) {
    return camera_for(held, aspect / static_cast<double>(trial_.scene.views.size()), least_half_height);
  };
  if (frame_needs_motion(trial_.scene)) {
    trial_.scene.beside.clear();
    Scene begun = trial_.scene;
    begun.w0_B = *fitted.w0_B;
    if (fitted.attitude) begun.attitude = fitted.attitude;
    try {
      const SceneModel held = make_model(begun);
      camera_ = frame_of(builders::snapshot_at(held, 0.0, trial_.scene.views[pane]));
    } catch (const std::domain_error&) {  // no motion begins with the ω that a file says it is kept from
      camera_ = frame_of(builders::snapshot_at(model, 0.0, trial_.scene.views[pane]));
    }
  } else {
    const Beginning held = beginning_of(trial_.scene, fitted);
    camera_ = frame_of(builders::snapshot_in(held.model, 0.0, trial_.scene.views[pane], held.state));
  }
}

std::optional<DrawnOmega> TrialOmega::at(const Vec3& w0_B) {
  trial_.scene.w0_B = w0_B;
  const std::vector<View>& views = trial_.scene.views;
  if (!draws_omega(trial_) || pane_ >= views.size() || w0_B.isZero(0.0)) return std::nullopt;
  RigidBodyState start{Quat::Identity(), w0_B};
  if (trial_.needs.attitude) start.q_SB = problem_of(trial_.scene).start.q_SB;
  const builders::Snapshot m = builders::snapshot_in(trial_, 0.0, views[pane_], start);
  return DrawnOmega{m.omega_tip_V(), camera_};
}

}  // namespace polhode
