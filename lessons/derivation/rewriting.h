// SPDX-License-Identifier: MIT
// An expression written again with some of its nodes changed. Internal to lessons/derivation/.
#pragma once

#include "lessons/claims/expressions/expression_builder.h"

#include <functional>
#include <optional>

namespace polhode {

class Rewriting {
 public:
  /// What stands in a node's place; nothing: it cannot be.
  using Change = std::function<std::optional<int>(Rewriting&, const ExpressionNode&)>;
  /// As `target`: each node, from the whole down to where the change copies no further.
  static constexpr int kEach = -1;

  Rewriting(const Expression& old, int target, const Change& change)
      : old_(old), target_(target), change_(change) {}

  /// Nothing where the new whole has no meaning.
  std::optional<Expression> write();

  /// A node of the old expression, changed if it is to be.
  std::optional<int> again(int index);
  /// The node with its operands as they are to be.
  std::optional<int> copy(const ExpressionNode& n);
  /// The node over others.
  std::optional<int> over(const ExpressionNode& n, int a, int b);
  std::optional<int> call(Operation operation, int a, int b = -1);
  int number(int value);
  int quantity(Quantity quantity);
  ExpressionBuilder& builder() { return builder_; }
  const ExpressionNode& old(int index) const { return old_.nodes[static_cast<std::size_t>(index)]; }

 private:
  const Expression& old_;
  int target_;
  const Change& change_;
  ExpressionBuilder builder_;
};

}  // namespace polhode
