// SPDX-License-Identifier: MIT
// Expressions as quantities of a scene, which plots, trails and arrows can show.
#pragma once

#include "lessons/claims/expression.h"
#include "render/scene/description/scene_quantity.h"

#include <string>

namespace polhode {

/// What an expression comes to on a motion; text, meaning and whether it is a vector are its own.
SceneQuantity scene_quantity(Expression expression, std::string tex, std::string unit, std::string role);

}  // namespace polhode
