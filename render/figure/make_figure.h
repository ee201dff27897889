// SPDX-License-Identifier: MIT
// A scene at one time as lists to draw.
#pragma once

#include "render/figure/figure.h"
#include "render/scene/model/model.h"

namespace polhode {

/// Pure: depends on its arguments alone. `aspect` = width / height of the picture.
Figure make_figure(const SceneModel& model, double t_s, double aspect);

}  // namespace polhode
