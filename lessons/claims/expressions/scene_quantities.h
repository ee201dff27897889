// SPDX-License-Identifier: MIT
// Expressions as quantities of a scene, which plots, trails and arrows can show.
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "render/scene/description/scene_quantity.h"

#include <functional>
#include <string>
#include <vector>

namespace polhode {

/// What an expression comes to on a motion; text, fingerprint and whether it is a vector are its own.
SceneQuantity scene_quantity(Expression expression, std::string tex, std::string unit, std::string role);

/// What an expression comes to as a function of one of its constants, the `variable`th, with the motion at
/// t = 0: one value for each x, NaN where it is not defined or not finite.
struct FunctionOfConstant {
  std::string fingerprint;
  std::function<std::vector<double>(const SceneModel&, const std::vector<double>& x)> values;
};
FunctionOfConstant function_of_constant(Expression expression, int variable);

}  // namespace polhode
