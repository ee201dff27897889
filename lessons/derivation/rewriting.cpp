// SPDX-License-Identifier: MIT
#include "lessons/derivation/rewriting.h"

#include "lessons/claims/expressions/expression_names.h"

#include <algorithm>

namespace polhode {
namespace {

using O = Operation;

const FunctionFacts* function_of(O operation) {
  const auto found =
      std::find_if(kFunctions.begin(), kFunctions.end(),
                   [operation](const FunctionFacts& facts) { return facts.operation == operation; });
  return found == kFunctions.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Expression> Rewriting::write() {
  try {
    if (!again(static_cast<int>(old_.nodes.size()) - 1)) return std::nullopt;
    return Expression{old_.text + " changed", builder_.take(), old_.constants};
  } catch (const ExpressionFault&) {
    return std::nullopt;
  }
}

std::optional<int> Rewriting::again(int index) {
  const ExpressionNode& n = old_.nodes[static_cast<std::size_t>(index)];
  return target_ == kEach || index == target_ ? change_(*this, n) : copy(n);
}

std::optional<int> Rewriting::copy(const ExpressionNode& n) {
  const auto a = n.a >= 0 ? again(n.a) : std::optional(-1);
  const auto b = n.b >= 0 ? again(n.b) : std::optional(-1);
  if (!a || !b) return std::nullopt;
  return over(n, *a, *b);
}

std::optional<int> Rewriting::over(const ExpressionNode& n, int a, int b) {
  switch (n.operation) {
    case O::number:
      return builder_.number(n.number, 0, 0);
    case O::constant:
      return builder_.constant(n.integer, n.number.value, 0, 0);
    case O::pi:
      return builder_.pi(0, 0);
    case O::quantity:
      return builder_.quantity(facts_of(n.quantity), 0, 0);
    case O::negate:
      return builder_.negate(a, 0);
    case O::add:
    case O::subtract:
      return builder_.add(n.operation, a, b, 0);
    case O::multiply:
      return builder_.multiply(a, b, 0);
    case O::divide:
      return builder_.divide(a, b, 0);
    case O::power:
      return builder_.power(a, n.integer, 0, 0);
    case O::comp:
      return builder_.component(a, n.integer, 0, 0);
    case O::apply:
      return builder_.apply_tensor(a, 0, 0);
    case O::trace:
      return builder_.trace_of_tensor(0, 0);
    default:
      return call(n.operation, a, b);
  }
}

std::optional<int> Rewriting::call(Operation operation, int a, int b) {
  const FunctionFacts* facts = function_of(operation);
  if (facts == nullptr) return std::nullopt;
  return builder_.call(*facts, b >= 0 ? std::vector<int>{a, b} : std::vector<int>{a}, 0, 0);
}

int Rewriting::number(int value) { return builder_.number({value, 0, static_cast<double>(value)}, 0, 0); }

int Rewriting::quantity(Quantity quantity) { return builder_.quantity(facts_of(quantity), 0, 0); }

}  // namespace polhode
