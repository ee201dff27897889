// SPDX-License-Identifier: MIT
// The plots against time of a page, computed from the motion that its figure shows.
#pragma once

#include "render/drawing/plots/time_plot.h"
#include "render/scene/model/model.h"

namespace polhode {

/// Where relative changes and angles begin: about what rounding a double leaves.
inline constexpr double kDriftFloor = 1e-16;

/// How many plots that makes, without computing any.
std::size_t meter_count(const SceneModel& model);

/// One for each of the scene's meters if the model was made for a page, else none; t_s is marked. They cover
/// the span of the model that t lies in: [0, span], or [span, 2 span], … so that in a film the curves stand
/// still while the mark moves. What overflows double leaves gaps.
///
/// Drift: |T/T₀ − 1|, ||L|/|L₀| − 1| and the angle between L and L₀ in space, rad (atan2 of |L × L₀| and
/// L·L₀, which keeps small angles), from the start at t = 0. Of each of 32 stretches of the time
/// shown the largest is drawn, so that no drift is larger than its curve. A motion in closed form at rest has
/// 0 in all. About 0.3 ms for a free motion.
std::vector<TimePlot> meter_plots(const SceneModel& model, double t_s);

}  // namespace polhode
