// SPDX-License-Identifier: MIT
// How fast the errors of methods fall with their steps: what a plot of orders draws, and what is said of it.
#pragma once

#include "render/scene/model/method_table.h"

#include <optional>
#include <utility>
#include <vector>

namespace polhode {

/// Of one method of fixed step.
struct MethodOrder {
  Method method = Method::exact;
  /// Work, and the relative error of ω at the end, from the longest step to the shortest; without those so
  /// long that the method has not followed the motion at all.
  std::vector<std::pair<double, double>> points;
  /// log₂ of error(h)/error(h/2), of the shortest steps at which the error is small and far above rounding;
  /// nothing: there are none.
  std::optional<double> order;
};

/// Of tables each with half the step of the one before (SceneModel::orders), in the order of their rows; none
/// of a method without points.
/// @param by_evaluations what is counted as work: evaluations of the equations of motion, else steps
std::vector<MethodOrder> method_orders(const std::vector<MethodTable>& tables, bool by_evaluations);

}  // namespace polhode
