// SPDX-License-Identifier: MIT
// The model of a scene: all that a picture of it, at any time, is made from, and no more than that.
#pragma once

#include "physics/body/problem.h"
#include "physics/effort.h"
#include "physics/geometry/poinsot.h"
#include "physics/motion.h"
#include "render/scene/description/requirements.h"
#include "render/scene/description/scene.h"
#include "render/scene/model/drawn_marks.h"
#include "render/scene/model/method_table.h"
#include "render/scene/model/scene_needs.h"
#include "render/scene/model/scene_problem.h"

#include <memory>
#include <string>
#include <vector>

namespace polhode {

/// Where ticks stand on polhode and herpolhode: at ω's tip at these times, and at those one or more periods
/// before or after.
struct RollingTicks {
  std::vector<double> times_s;  ///< kRollingTicks in one period, from that of the still on; none: no period
  double period_s = 0.0;
};
inline constexpr int kRollingTicks = 24;

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
  double longest_term = 0.0;  ///< of I·ω̇ + ω×(I·ω) = N, drawn at full length, N m
  VectorCourses courses;      ///< of the marks, over span_s
  double span_s = 0.0;        ///< what curves over time cover and one loop of a film shows
  double reach_s = 0.0;       ///< |t| up to which this motion, and each beside it, may be asked for
  double rate = 1.0;          ///< simulated seconds per shown second
  Curve polhode_B;
  std::vector<PolhodeOfFamily> family_B;
  std::vector<Curve> separatrices_B;
  Curve herpolhode_S;
  RollingTicks ticks;
  Shape solid;
  MethodTable methods;              ///< at the time of the still, with the scene's step or 64 to a turn
  std::vector<MethodTable> orders;  ///< kOrderSteps of them, each with half the step of the one before
  std::vector<SceneModel> beside;   ///< of the scenes beside it; none if it was made for numbers
  /// Of the scene as it began with the ω that its camera was fitted for, whose frame is kept. Null: its own
  /// is, or the beginning alone knows it.
  std::unique_ptr<const SceneModel> framed;
};

/// The model and those beside it, in the order in which they stand.
std::vector<const SceneModel*> shown_models(const SceneModel& model);

/// Chords of curves stay within this part of the energy ellipsoid's largest semi-axis: 0.1 px in a 1080p
/// picture.
inline constexpr double kChordTolerance = 2e-4;

/// Whether what is needed of the motion, and of those beside it, can be computed at t.
bool is_computable(const SceneModel& model, double t_s);

/// The motion by the method that the scene names, or by the default one, and the parts asked for. Its cost is
/// told to `effort`, and later what the motion costs: it must outlive the model.
/// @throws std::domain_error if the body, the state or the chosen method cannot serve; and what `effort`
/// throws
SceneModel make_model(const Scene& scene, ModelFor use = ModelFor::figure, const Effort& effort = {},
                      double chord_tolerance = kChordTolerance);

}  // namespace polhode
