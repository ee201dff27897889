// SPDX-License-Identifier: MIT
// What a scene requires, and the model that gives just that. "Model only what a scene requires" lives here
// alone.
#pragma once

#include "physics/motion.h"
#include "physics/poinsot.h"
#include "render/scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace polhode {

/// What the overlays and views of a scene ask of the physics.
struct Requirements {
  bool omega = false;     ///< ω_B(t)
  bool attitude = false;  ///< q_SB(t)
  bool polhode = false;   ///< curve through ω
  bool polhode_family = false;
  bool separatrix = false;
  bool herpolhode = false;  ///< samples the motion with attitude
  bool trail_L = false;
  bool trail_omega = false;
  bool cones = false;
  bool solid = false;  ///< a shape to draw
  bool operator==(const Requirements&) const = default;
};

Requirements requirements(const Scene& scene);

/// "omega", "attitude", "polhode", ...: for `info`.
std::vector<std::string> names_of(const Requirements& needs);

/// Everything a picture of the scene at any t can be made from. What is not required is empty and was not
/// computed.
struct SceneModel {
  Scene scene;
  Requirements needs;
  std::unique_ptr<const Motion> motion;  ///< never null
  std::string why;                       ///< why this motion was chosen, one sentence
  Quat q0_SB = Quat::Identity();         ///< attitude at t = 0
  double span_s = 0.0;                   ///< what curves over time cover and one loop of a film shows
  double rate = 1.0;                     ///< simulated seconds per shown second
  Curve polhode_B;
  std::vector<PolhodeOfFamily> family_B;
  std::vector<Curve> separatrices_B;
  Curve herpolhode_S;
  Shape solid;
};

/// What the herpolhode covers from t = 0: `duration`, or three polhode periods.
double herpolhode_span_s(const SceneModel& model);

/// Chooses the cheapest motion that gives what is asked and computes the parts asked for.
/// @throws std::domain_error if the body, the state or the chosen method cannot serve.
SceneModel make_model(const Scene& scene);

}  // namespace polhode
