// SPDX-License-Identifier: MIT
// A scene at one time as lists to draw.
#pragma once

#include "render/figure/figure.h"
#include "render/scene/model/model.h"

namespace polhode {

/// Pure: depends on its arguments alone. `aspect` = width / height of the picture.
/// @param least_half_height of what each pane shows, scene units: of scenes side by side that have one scale
/// (common_half_height)
Figure make_figure(const SceneModel& model, double t_s, double aspect, double least_half_height = 0);

/// Half of the height, scene units at the middle of the picture, that each of several scenes shows, so that
/// one vector is equally long in all: they are of one body at rest, and their cameras zoom alike. 0: each has
/// its own scale.
double common_half_height(const SceneModel& model, double aspect);

/// Half of the height that the scene shows in a picture of this aspect where nothing is common: its own
/// scale. 0: it shows nothing in space, or the orders of turns, which share a picture in their own way.
double own_half_height(const SceneModel& model, double aspect);

}  // namespace polhode
