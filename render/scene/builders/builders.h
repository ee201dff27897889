// SPDX-License-Identifier: MIT
// One function for each kind of thing that an overlay adds to a pane's draw list. All are pure; a builder
// that has nothing to add adds nothing. Internal to render/scene.
#pragma once

#include "render/scene/figure.h"

namespace polhode::builders {

inline constexpr double kTriadLength = 1.28;  ///< of the axes of both frames, scene units

/// A scene at one time in one view. "V" is the view's frame: S for the space view, B for the body view.
struct Moment {
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

Moment moment_at(const SceneModel& model, double t_s, View view);

void add_solid(const Moment& m, DrawList& list);
void add_surfaces(const Moment& m, DrawList& list);  ///< ellipsoids, momentum sphere, invariable plane
void add_curves(const Moment& m, DrawList& list);    ///< polhodes, separatrices, herpolhode
void add_trails(const Moment& m, DrawList& list);
void add_cones(const Moment& m, DrawList& list);
void add_vectors(const Moment& m, DrawList& list);  ///< ω, L, N
void add_axes(const Moment& m, DrawList& list);     ///< triads
void add_labels(const Moment& m, const Camera& camera, DrawList& list);
void add_values(const Moment& m, DrawList& list);

/// Place of L²/2T between the moments: 0 at I_min, ½ at I_mid, 1 at I_max.
double scale_place(const PrincipalMoments& I, double L2_over_2T);

/// Height of the invariable plane below the centre in an L-down space view, scene units (negative).
double plane_z(const Moment& m);

}  // namespace polhode::builders
