// SPDX-License-Identifier: MIT
#include "lessons/claims/scene_quantities.h"

#include "lessons/claims/live_claims.h"

#include <memory>
#include <sstream>
#include <utility>

namespace polhode {
namespace {

/// Its parts, by number: words of the lesson are written out in them.
std::string meaning_of(const Expression& expression) {
  std::ostringstream text;
  text.precision(17);
  for (const ExpressionNode& node : expression.nodes) {
    text << static_cast<int>(node.operation) << ' ' << node.a << ' ' << node.b << ' ';
    if (node.operation == Operation::quantity) text << static_cast<int>(node.quantity);
    if (node.operation == Operation::number || node.operation == Operation::constant)
      text << node.number.value;
    text << ' ' << node.integer << ';';
  }
  return std::move(text).str();
}

}  // namespace

SceneQuantity scene_quantity(Expression expression, std::string tex, std::string unit, std::string role) {
  SceneQuantity quantity{.text = expression.text,
                         .tex = std::move(tex),
                         .meaning = meaning_of(expression),
                         .is_vector = expression.type() == ExpressionType::vector,
                         .unit = std::move(unit),
                         .role = std::move(role),
                         .value = {}};
  const auto shared = std::make_shared<const Expression>(std::move(expression));
  quantity.value = [shared, of_rates = has_rates(*shared)](
                       const SceneModel& model, double t_s,
                       const RigidBodyState& state) -> std::optional<Vec3> {
    if (of_rates && slips(model.scene)) return std::nullopt;
    const auto live = of_rates ? live_state(model, t_s) : still_state(model, t_s, state);
    const auto now = live ? live_quantity(*shared, *live, View::space) : std::nullopt;
    if (!now) return std::nullopt;
    return Vec3(now->components[0], now->components[1], now->components[2]);
  };
  return quantity;
}

}  // namespace polhode
