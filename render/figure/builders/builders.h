// SPDX-License-Identifier: MIT
// One function for each kind of thing that an overlay adds to a pane's draw list. All are pure; a builder
// that has nothing to add adds nothing. Internal to render/scene.
#pragma once

#include "render/figure/figure.h"
#include "render/scene/model/model.h"
#include "render/scene/model/turn_orders.h"

#include <optional>
#include <vector>

namespace polhode::builders {

inline constexpr double kTriadLength = 1.28;  ///< of the axes of both frames, scene units

// Radii of curves at the standard thickness, scene units.
inline constexpr double kPolhodeRadius = 0.0135;
inline constexpr double kHerpolhodeRadius = 0.0085;

/// A scene at one time in one view. "V" is the view's frame: S for the space view, B for the body view.
struct Snapshot {
  const SceneModel& model;
  double t_s;
  View view;
  RigidBodyState state;
  Quat q_VB;     ///< body components to view components
  Quat q_VS;     ///< space components to view components
  Vec3 L_B;      ///< kg m²/s
  double two_T;  ///< J
  Vec3 N_B;      ///< N m
  /// Scene units per rad/s: ω-space drawn with its largest semi-axis at 1 for t = 0.
  double omega_scale;
  /// Scene units per kg m²/s where the scene shows L-space (a momentum sphere or ellipsoid); 0 otherwise.
  double L_scale;
  double L_length;   ///< of the arrow of L where |L| is the model's L_reference, scene units
  double thickness;  ///< of lines, relative to the standard; thinner where there is more to see
  /// From S's origin to the centre of mass, which is where all is drawn; zero in the body view.
  Vec3 center_V = Vec3::Zero();
  std::optional<Turn> turn = {};  ///< of the pane of one of the turn orders

  bool shows(Overlay o) const { return model.drawn.contains(o); }
  const PrincipalMoments& I() const { return model.scene.body.moments; }
  Vec3 omega_tip_V() const { return q_VB * (state.w_B * omega_scale); }
  Vec3 L_tip_V() const { return q_VB * L_drawn_B(L_B); }
  /// Where the tip of an angular momentum is drawn, body components: true to scale, so that under torque it
  /// moves the way N points.
  Vec3 L_drawn_B(const Vec3& any_L_B) const;
  /// 1, or more where the scene stresses this overlay.
  double emphasis(Overlay o) const;
};

Snapshot snapshot_at(const SceneModel& model, double t_s, View view);

void add_solid(const Snapshot& m, DrawList& list);
void add_surfaces(const Snapshot& m, DrawList& list);  ///< ellipsoids, momentum sphere, invariable plane
void add_curves(const Snapshot& m, DrawList& list);    ///< polhodes, separatrices, herpolhode
void add_trails(const Snapshot& m, DrawList& list);
void add_cones(const Snapshot& m, DrawList& list);
void add_vectors(const Snapshot& m, DrawList& list);  ///< ω, L, N
void add_axes(const Snapshot& m, DrawList& list);     ///< triads

// Figures of the lecture, with their names where the scene shows labels.
void add_translation(const Snapshot& m, DrawList& list);  ///< p, v, F and the path; puck
void add_turn(const Snapshot& m, DrawList& list);         ///< the axis and the sense of the present turn
void add_transport(const Snapshot& m, const Camera& camera, DrawList& list);  ///< A and its triangle
void add_terms(const Snapshot& m, const Camera& camera, DrawList& list);      ///< of equation (6)
void add_pivot(const Snapshot& m, DrawList& list);                            ///< stand, axle and weight
/// The exact body, ω and L beside the computed ones.
void add_ghost(const Snapshot& m, const Camera& camera, DrawList& list);
void add_ghost_of_solid(const Snapshot& m, const Quat& q_SB, DrawList& list);

void add_labels(const Snapshot& m, const Camera& camera, DrawList& list);
void add_values(const Snapshot& m, DrawList& list);

/// Scene units per metre: of the body that is drawn, and of the path of its centre.
double scene_units_per_m(const Snapshot& m);

/// Where the centre of mass is drawn from S's origin.
Vec3 center_of_mass_V(const Snapshot& m);

/// Tips of its arrows over the scene's span, from S's origin.
std::vector<Vec3> tips_of_center_V(const Snapshot& m);

/// Screen direction of the camera: x to the right, y up.
Vec3 screen_direction(const Camera& camera, double x, double y);

/// Whether nothing of the body is shown beside the puck: it is then in the middle.
bool puck_alone(const Snapshot& m);

/// Places of the centre of mass over the scene's span, or of the puck's where there is one; scene units, view
/// axes.
std::vector<Vec3> path_of_center_V(const Snapshot& m);

/// The angular velocity that the surfaces and the body inside them are drawn for: without torque that of the
/// start, so that a computed motion which does not keep T and |L| leaves them.
const Vec3& w_B_of_surfaces(const Snapshot& m);

/// Where the arrow of N begins and ends.
struct Ends {
  Vec3 tail, tip;
};
Ends torque_ends(const Snapshot& m);

/// Place of L²/2T between the moments: 0 at I_min, ½ at I_mid, 1 at I_max.
double scale_place(const PrincipalMoments& I, double L2_over_2T);

/// Height of the invariable plane below the centre in an L-down space view, scene units (negative).
double plane_z(const Snapshot& m);

}  // namespace polhode::builders
