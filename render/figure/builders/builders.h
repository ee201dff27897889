// SPDX-License-Identifier: MIT
// One function for each kind of thing that an overlay adds to a pane's draw list. All are pure; a builder
// that has nothing to add adds nothing. Internal to render/figure/.
#pragma once

#include "render/figure/figure.h"
#include "render/scene/model/model.h"
#include "render/scene/model/turn_orders.h"

#include <array>
#include <optional>
#include <vector>

namespace polhode::builders {

inline constexpr double kTriadLength = 1.28;                  ///< of the axes of both frames, scene units
inline constexpr double kSymbolSize = 1.2, kTextSize = 0.95;  ///< of names, of the size of labels

// Radii of curves at the standard thickness, scene units.
inline constexpr double kPolhodeRadius = 0.0135;
inline constexpr double kHerpolhodeRadius = 0.0085;
inline constexpr double kTrailRadius = 0.011;
inline constexpr double kOldestOfTrail = 0.4;  ///< of its colour: loops of long ago are to be seen
inline constexpr double kArrowRadius = 0.021;
inline constexpr double kTorqueLength = 0.62;  ///< of the arrow of N, scene units
inline constexpr double kArrowDash = 0.045;    ///< of torques, and of others that are told apart by it

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
  double L_length;     ///< of the arrow of L where |L| is L_reference, scene units
  double L_reference;  ///< the model's, or that of the ω that the picture is fitted to
  double thickness;    ///< of lines, relative to the standard; thinner where there is more to see
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

using Builder = void(const Snapshot& m, const Camera& camera, DrawList& list);

Builder add_surfaces;  ///< ellipsoids, momentum sphere, invariable plane
Builder add_solid;
Builder add_poses;    ///< of a body that flies, at earlier times
Builder add_curves;   ///< polhodes, separatrices, herpolhode
Builder add_rolling;  ///< the contact on the herpolhode, and ticks that show that nothing slips
Builder add_trails, add_cones;
Builder add_axes;         ///< triads
Builder add_vectors;      ///< ω, L, N
Builder add_translation;  ///< p, v, F and the path; puck
Builder add_turn;         ///< the axis and the sense of the present turn
Builder add_transport;    ///< A and its triangle
Builder add_terms;        ///< of I·ω̇ + ω×(I·ω) = N
Builder add_pivot;        ///< stand, axle and weight
Builder add_spin;         ///< the sense of ω₃
Builder add_ghost;        ///< the exact body, ω and L beside the computed ones
Builder add_room;         ///< at rest in S; on the floor that a pane has already
Builder add_labels;
Builder add_marks;  ///< of the lesson's own, with their names
/// In the order in which a pane is drawn.
inline constexpr std::array kBuilders = {
    add_surfaces, add_solid,   add_poses,       add_curves, add_rolling,   add_trails, add_cones,
    add_axes,     add_vectors, add_translation, add_turn,   add_transport, add_terms,  add_pivot,
    add_spin,     add_ghost,   add_room,        add_labels, add_marks};

/// Once in a figure, in the corner of its first pane.
void add_values(const Snapshot& m, DrawList& list);
void add_ghost_of_solid(const Snapshot& m, const Quat& q_SB, DrawList& list);

/// From when on a trail shows the past. A free motion in closed form has no beginning; a driven one, and one
/// that a method computes step by step, starts at t = 0.
double trail_start_s(const Snapshot& m);
/// From when till when the herpolhode is drawn.
std::pair<double, double> herpolhode_times_s(const Snapshot& m);
/// The arrow's tip ends the trail, whose blunt end would stick out: its axis ends one radius behind.
void end_behind_tip(Tube& trail);

/// Scene units per metre: of the body that is drawn, and of the path of its centre.
double scene_units_per_m(const Snapshot& m);

/// Where the centre of mass is drawn at t from S's origin.
Vec3 center_of_mass_V(const Snapshot& m, double t_s);

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
/// Of an arrow of the lesson's own, by its place among them; nothing: it is too short to be drawn.
std::optional<Vec3> tip_of_arrow_V(const Snapshot& m, std::size_t arrow);

/// Place of L²/2T between the moments: 0 at I_min, ½ at I_mid, 1 at I_max.
double scale_place(const PrincipalMoments& I, double L2_over_2T);

/// Height of the invariable plane below the centre in an L-down space view, scene units (negative).
double plane_z(const Snapshot& m);
/// What lifts a tube of ω's path in space from the middle of that plane onto it; 0 where none is drawn.
Vec3 onto_plane(const Snapshot& m, const Tube& tube);

}  // namespace polhode::builders
