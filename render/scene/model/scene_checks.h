// SPDX-License-Identifier: MIT
// How much a scene may ask for: times, turns, distances and sizes beyond which there is nothing to be drawn.
#pragma once

#include "physics/method.h"
#include "render/scene/description/requirements.h"
#include "render/scene/description/scene.h"

namespace polhode {

/// The longest |t| that a still of the scene asks its motion for.
double reach_of_still_s(const Scene& scene, const Requirements& needs);

/// Without computing a curve or a state. @throws std::domain_error: what is asked for, how much there can be,
/// and what to change
void check_limits(const Scene& scene, const MethodChoice& choice, const Motion& motion,
                  const Requirements& needs);

}  // namespace polhode
