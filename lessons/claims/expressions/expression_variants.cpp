// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression_variants.h"

#include <algorithm>

namespace polhode {
namespace {

bool is_sum(const ExpressionNode& node) {
  return node.operation == Operation::add || node.operation == Operation::subtract;
}

int root_of(const Expression& expression) { return static_cast<int>(expression.nodes.size()) - 1; }

ExpressionNode& node_at(Expression& expression, int index) {
  return expression.nodes[static_cast<std::size_t>(index)];
}

int push_number(Expression& expression, int number) {
  ExpressionNode node;
  node.number = {number, 0, static_cast<double>(number)};
  expression.nodes.push_back(node);
  return root_of(expression);
}

constexpr std::array<Quantity, 5> kOnAxes = {Quantity::I1, Quantity::w1, Quantity::dw1, Quantity::N1,
                                             Quantity::e1};

Quantity renamed(Quantity quantity, const AxisPermutation& axes) {
  const int value = static_cast<int>(quantity);
  for (const Quantity first : kOnAxes) {
    const int axis = value - static_cast<int>(first);
    if (axis >= 0 && axis < 3)
      return static_cast<Quantity>(static_cast<int>(first) + axes[static_cast<std::size_t>(axis)]);
  }
  const int component = value - static_cast<int>(Quantity::Jxx);
  if (component < 0) return quantity;
  constexpr std::array<std::array<int, 2>, 6> kPlaces{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  const auto& place = kPlaces[static_cast<std::size_t>(component)];
  std::array<int, 2> to{axes[static_cast<std::size_t>(place[0])], axes[static_cast<std::size_t>(place[1])]};
  std::sort(to.begin(), to.end());
  const auto found = std::find(kPlaces.begin(), kPlaces.end(), to) - kPlaces.begin();
  return static_cast<Quantity>(static_cast<int>(Quantity::Jxx) + static_cast<int>(found));
}

}  // namespace

bool is_rate(const ExpressionNode& node) {
  if (node.operation == Operation::ddt || node.operation == Operation::star) return true;
  return node.operation == Operation::quantity &&
         (node.quantity == Quantity::dw1 || node.quantity == Quantity::dw2 || node.quantity == Quantity::dw3);
}

std::vector<int> summands_of(const Expression& expression) {
  const auto at = [&](int index) -> const ExpressionNode& {
    return expression.nodes[static_cast<std::size_t>(index)];
  };
  std::vector<int> summands;
  for (const ExpressionNode& node : expression.nodes) {
    if (!is_sum(node) || summands.size() + 2 > kMostSummands) continue;
    if (!is_sum(at(node.a))) summands.push_back(node.a);
    summands.push_back(node.b);
  }
  std::sort(summands.begin(), summands.end(), [&](int a, int b) { return at(a).begin < at(b).begin; });
  return summands;
}

Expression negated(Expression expression) {
  ExpressionNode node = expression.nodes.back();
  node.operation = Operation::negate;
  node.a = root_of(expression);
  node.b = -1;
  expression.nodes.push_back(node);
  return expression;
}

Expression times(Expression expression, int numerator, int denominator) {
  const int whole = root_of(expression);
  ExpressionNode node = expression.nodes.back();
  const int top = push_number(expression, numerator), bottom = push_number(expression, denominator);
  node.operation = Operation::multiply;
  node.a = top;
  node.b = whole;
  expression.nodes.push_back(node);
  node.operation = Operation::divide;
  node.a = root_of(expression);
  node.b = bottom;
  expression.nodes.push_back(node);
  return expression;
}

Expression with_summand_negated(Expression expression, int summand) {
  // Operands stand before what is over them: the negation goes in right behind the summand, and takes its
  // place.
  ExpressionNode negation = node_at(expression, summand);
  negation.operation = Operation::negate;
  negation.a = summand;
  negation.b = -1;
  for (ExpressionNode& node : expression.nodes)
    for (int* operand : {&node.a, &node.b}) *operand += *operand >= summand ? 1 : 0;
  expression.nodes.insert(expression.nodes.begin() + summand + 1, negation);
  return expression;
}

Expression without_summand(Expression expression, int summand) {
  ExpressionNode& node = node_at(expression, summand);
  const ExpressionType type = node.type;
  node = ExpressionNode();
  node.type = type;
  return expression;
}

Expression renamed(Expression expression, const AxisPermutation& axes) {
  for (ExpressionNode& node : expression.nodes) {
    if (node.operation == Operation::quantity) node.quantity = renamed(node.quantity, axes);
    if (node.operation == Operation::comp) node.integer = axes[static_cast<std::size_t>(node.integer)];
  }
  return expression;
}

}  // namespace polhode
