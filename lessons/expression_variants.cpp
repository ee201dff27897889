// SPDX-License-Identifier: MIT
#include "lessons/expression_variants.h"

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

/// The sum whose right operand the term is; nothing for the leftmost.
ExpressionNode* sum_over(Expression& expression, int term) {
  const auto found = std::find_if(expression.nodes.begin(), expression.nodes.end(),
                                  [term](const auto& node) { return is_sum(node) && node.b == term; });
  return found == expression.nodes.end() ? nullptr : &*found;
}

void swap_sign(ExpressionNode& sum) {
  sum.operation = sum.operation == Operation::add ? Operation::subtract : Operation::add;
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

std::vector<int> terms_of(const Expression& expression) {
  std::vector<int> terms;
  int node = root_of(expression);
  for (; is_sum(expression.nodes[static_cast<std::size_t>(node)]);
       node = expression.nodes[static_cast<std::size_t>(node)].a)
    terms.push_back(expression.nodes[static_cast<std::size_t>(node)].b);
  terms.push_back(node);
  std::reverse(terms.begin(), terms.end());
  return terms;
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

Expression with_term_negated(Expression expression, int term) {
  if (ExpressionNode* sum = sum_over(expression, term)) {
    swap_sign(*sum);
    return expression;
  }
  // The leftmost has no sign before it: all others are negated, and then the whole.
  for (const int other : terms_of(expression))
    if (other != term) swap_sign(*sum_over(expression, other));
  return negated(std::move(expression));
}

Expression without_term(Expression expression, int term) {
  ExpressionNode& node = node_at(expression, term);
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
