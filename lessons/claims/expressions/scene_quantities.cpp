// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/scene_quantities.h"

#include "lessons/claims/live_claims.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace polhode {
namespace {

/// A hash of its parts, in which words of the lesson are written out. Two that are not the same have the same
/// one with a chance of 2⁻⁶⁴.
std::string fingerprint_of(const Expression& expression) {
  std::string parts;
  const auto add = [&](const auto& number) {
    parts.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  for (const ExpressionNode& node : expression.nodes) {
    for (const int part : {static_cast<int>(node.operation), node.a, node.b, node.integer}) add(part);
    if (node.operation == Operation::quantity) add(static_cast<int>(node.quantity));
    if (node.operation == Operation::number || node.operation == Operation::constant) add(node.number.value);
  }
  return std::to_string(std::hash<std::string>()(parts));
}

}  // namespace

SceneQuantity scene_quantity(Expression expression, std::string tex, std::string unit, std::string role) {
  SceneQuantity quantity{.text = expression.text,
                         .tex = std::move(tex),
                         .fingerprint = fingerprint_of(expression),
                         .is_vector = expression.type() == ExpressionType::vector,
                         .unit = std::move(unit),
                         .role = std::move(role),
                         .value = {}};
  const auto shared = std::make_shared<const Expression>(std::move(expression));
  quantity.value = [shared, of_rates = has_rates(*shared)](
                       const SceneModel& model, double t_s,
                       const RigidBodyState& state) -> std::optional<Vec3> {
    if (of_rates && loses_energy_inside(model.scene)) return std::nullopt;
    const auto live = of_rates ? live_state(model, t_s) : still_state(model, t_s, state);
    const auto now = live ? live_quantity(*shared, *live, View::space) : std::nullopt;
    if (!now) return std::nullopt;
    return Vec3(now->components[0], now->components[1], now->components[2]);
  };
  return quantity;
}

FunctionOfConstant function_of_constant(Expression expression, int variable) {
  FunctionOfConstant function{fingerprint_of(expression), {}};
  const auto shared = std::make_shared<const Expression>(std::move(expression));
  function.values = [shared, variable, of_rates = has_rates(*shared)](const SceneModel& model,
                                                                      const std::vector<double>& x) {
    std::vector<double> values(x.size(), std::numeric_limits<double>::quiet_NaN());
    if (of_rates && loses_energy_inside(model.scene)) return values;
    const auto start = of_rates ? live_state(model, 0) : still_state(model, 0, model.motion->at(0));
    if (!start) return values;
    Expression at_x = *shared;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (ExpressionNode& node : at_x.nodes)
        if (node.operation == Operation::constant && node.integer == variable) node.number.value = x[i];
      const auto value = live_quantity(at_x, *start, View::space);
      if (value) values[i] = value->components[0];
    }
    return values;
  };
  return function;
}

}  // namespace polhode
