// SPDX-License-Identifier: MIT
// What a scene requires, and the model that gives just that. "Model only what a scene requires" lives here
// alone.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/geometry/poinsot.h"
#include "physics/motion.h"
#include "render/scene/description/requirements.h"
#include "render/scene/description/scene.h"
#include "render/scene/model/method_table.h"

#include <memory>
#include <string>
#include <vector>

namespace polhode {

/// The overlays of a scene that there is something to see of. A polhode, herpolhode, cones and an invariable
/// plane belong to torque-free motion; the plane and the herpolhode to the space view, the plane also to L
/// pointing down (only there is it level); N to a torque; a body at rest without torque has its shape and its
/// axes alone.
OverlaySet drawn_overlays(const Scene& scene);

/// The plots of a page about the scene: those it names, or else ω and drift without a torque, and ω, energy
/// and momentum under one.
std::vector<Meter> shown_meters(const Scene& scene);

/// What a scene is modelled for. A figure alone does without what only the plots of a page need.
enum class Product { figure, page };

Requirements requirements(const Scene& scene, Product product = Product::figure);

/// Body, state at t = 0 and torque of a scene: what there is to be followed in time.
Problem problem_of(const Scene& scene);

/// Whether a scene can be shown on a page at its own times, without computing any curve: what must be
/// computed step by step is followed as far as a still reaches.
/// @throws std::domain_error as make_model does, and what `effort` throws
void check_scene(const Scene& scene, const Effort& effort = {});

/// Everything a picture of the scene at any t can be made from. What is not required is empty and was not
/// computed.
struct SceneModel {
  Scene scene;
  OverlaySet drawn;
  Requirements needs;
  std::unique_ptr<const Motion> motion;  ///< never null
  std::string why;                       ///< why this motion was chosen, one sentence
  std::unique_ptr<const Motion> exact;   ///< of the ghost; null: none is asked for
  Quat q0_SB = Quat::Identity();         ///< attitude at t = 0
  double L_reference = 0.0;   ///< |L| that is drawn at full length, kg m²/s: the larger of start and `at`
  double longest_term = 0.0;  ///< of equation (6), drawn at full length, N m
  double span_s = 0.0;        ///< what curves over time cover and one loop of a film shows
  double reach_s = 0.0;       ///< the longest |t| that the motion is to be asked for
  double rate = 1.0;          ///< simulated seconds per shown second
  Curve polhode_B;
  std::vector<PolhodeOfFamily> family_B;
  std::vector<Curve> separatrices_B;
  Curve herpolhode_S;
  Shape solid;
  MethodTable methods;              ///< at the time of the still, with the scene's step or 64 to a turn
  std::vector<MethodTable> orders;  ///< kOrderSteps of them, each with half the step of the one before
};

/// What the herpolhode covers from t = 0: `duration`, or three polhode periods.
double herpolhode_span_s(const Scene& scene);

/// Chords of curves stay within this part of the energy ellipsoid's largest semi-axis: 0.1 px in a 1080p
/// picture.
inline constexpr double kChordTolerance = 2e-4;

/// Whether what is needed of the motion can be computed at t.
bool is_computable(const SceneModel& model, double t_s);

/// Chooses the cheapest motion that gives what is asked and computes the parts asked for. What that costs is
/// told to `effort`, and later what the motion costs: it must outlive the model.
/// @throws std::domain_error if the body, the state or the chosen method cannot serve; and what `effort`
/// throws
SceneModel make_model(const Scene& scene, Product product = Product::figure, const Effort& effort = {},
                      double chord_tolerance = kChordTolerance);

}  // namespace polhode
