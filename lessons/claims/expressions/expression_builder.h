// SPDX-License-Identifier: MIT
// Builds the nodes of an expression and refuses what has no meaning. Internal to lessons/.
#pragma once

#include "lessons/claims/expressions/expression_names.h"

#include <stdexcept>

namespace polhode {

/// What is wrong at a byte of the expression's text. Thrown and caught within lessons/.
struct ExpressionFault : std::runtime_error {
  ExpressionFault(std::size_t at, const std::string& message, std::string advice = {})
      : std::runtime_error(message), offset(at), hint(std::move(advice)) {}
  std::size_t offset;
  std::string hint;
};

/// Each function adds a node over nodes that are there and returns its index; `at` is the byte of the
/// operator or name, for the message. All throw ExpressionFault.
class ExpressionBuilder {
 public:
  int number(const DecimalNumber& number, std::size_t begin, std::size_t end);
  int quantity(const QuantityFacts& facts, std::size_t begin, std::size_t end);
  /// A number of the lesson that does not change, by its place among these.
  int constant(int index, double value, std::size_t begin, std::size_t end);
  int pi(std::size_t begin, std::size_t end);
  /// What a word of the lesson stands for, written out; all of it is the word's text.
  int insert(const Expression& meaning, std::size_t begin, std::size_t end);
  int negate(int a, std::size_t at);
  int add(Operation add_or_subtract, int a, int b, std::size_t at);
  int multiply(int a, int b, std::size_t at);
  int divide(int a, int b, std::size_t at);
  int power(int a, int exponent, std::size_t at, std::size_t end);
  /// dot, cross, norm2, inertia, star, ddt, sqrt … of what stands there.
  int call(const FunctionFacts& function, const std::vector<int>& arguments, std::size_t at, std::size_t end);
  /// comp(a, index + 1)
  int component(int a, int index, std::size_t at, std::size_t end);
  /// apply(J, a), and trace(J).
  int apply_tensor(int a, std::size_t at, std::size_t end);
  int trace_of_tensor(std::size_t at, std::size_t end);

  /// The text of a node with the brackets around it.
  void widen(int index, std::size_t begin, std::size_t end) {
    nodes_[static_cast<std::size_t>(index)].begin = static_cast<std::uint32_t>(begin);
    nodes_[static_cast<std::size_t>(index)].end = static_cast<std::uint32_t>(end);
  }

  const ExpressionNode& operator[](int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  std::vector<ExpressionNode> take() { return std::move(nodes_); }

 private:
  int push(ExpressionNode node, std::size_t at);
  int call_of_numbers(const FunctionFacts& function, const std::vector<int>& arguments, std::size_t at,
                      std::size_t end);
  ExpressionNode unary(Operation operation, int a, std::size_t begin, std::size_t end) const;
  void want_vector(int argument, std::string_view function) const;
  void want_scalar(int operand, std::size_t at, const std::string& message, std::string hint) const;

  std::vector<ExpressionNode> nodes_;
};

}  // namespace polhode
