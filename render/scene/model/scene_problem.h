// SPDX-License-Identifier: MIT
// What a scene asks to be followed in time, and for how long: what it leaves unsaid is filled in.
#pragma once

#include "physics/body/problem.h"
#include "render/scene/description/scene.h"

namespace polhode {

/// Body, state at t = 0 and torque of a scene.
Problem problem_of(const Scene& scene);

/// Whether two scenes show one motion: all that numbers and claims are evaluated on is the same, however it
/// is drawn, and for how long. Scenes are not compared as they are written: one that names its method or
/// attitude shows the motion of one that has the same by default.
bool same_motion(const Scene& a, const Scene& b);
/// Whether two scenes make one picture, apart from its caption: the body, its motion, the instant, and all
/// that is drawn and plotted.
bool same_picture(Scene a, Scene b);

/// Where nothing is said, the plane decides. Without a torque that only turns the whole picture: the motion
/// in the body is the same, and the plane, to which L is normal, has to lie below. A torque that knows of
/// space does tell up from down; there an author states the attitude, and the default is kept all the same,
/// so that one rule (FORMAT.md) holds of every scene.
AttitudeSpec attitude_spec(const Scene& scene);

/// One polhode period; where there is none, a turn of ω, and under torque some of them.
double natural_span_s(const Scene& scene);
/// What curves over time cover and one loop of a film shows: `duration`, or the natural span.
double span_s(const Scene& scene);
/// What the herpolhode covers from t = 0: `duration`, or three polhode periods.
double herpolhode_span_s(const Scene& scene);

/// Simulated seconds per shown second: `rate`, or the natural span in 8 s.
double shown_rate(const Scene& scene);

/// The scene with all said that it leaves to what follows from the rest: attitude, method and tolerance,
/// duration, rate, the t of the still and the plots of a page. It has the same motion.
Scene completed(Scene scene);

/// The step of the methods side by side: the scene's own, or 64 to a turn.
double table_step_s(const Scene& scene);

}  // namespace polhode
