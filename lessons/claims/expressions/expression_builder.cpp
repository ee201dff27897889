// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression_builder.h"

#include "lessons/claims/expressions/degree.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

using Type = ExpressionType;

/// Functions that exact arithmetic has not.
bool is_of_numbers(Operation operation) {
  using O = Operation;
  return operation == O::sqrt || operation == O::sin || operation == O::cos || operation == O::acos ||
         operation == O::atan2 || operation == O::exp || operation == O::log;
}

Type sum_type(Type a, Type b) { return a == Type::zero ? b : a; }

ExpressionNode binary(Operation operation, int a, int b, const ExpressionNode& left,
                      const ExpressionNode& right) {
  ExpressionNode node;
  node.operation = operation;
  node.a = a;
  node.b = b;
  node.order = std::max(left.order, right.order);
  node.begin = left.begin;
  node.end = right.end;
  return node;
}

}  // namespace

int ExpressionBuilder::push(ExpressionNode node, std::size_t at) {
  if (nodes_.size() == kMaxExpressionNodes)
    throw ExpressionFault(at,
                          "written out, this has more than " + std::to_string(kMaxExpressionNodes) + " parts",
                          "definitions in definitions grow quickly");
  static const DegreeTable kNothingGiven;
  const auto degree_of = [this](int operand) { return operand < 0 ? Degree() : (*this)[operand].degree; };
  node.degree = kNothingGiven.of(node, degree_of(node.a), degree_of(node.b));
  if (std::max(node.degree.numerator, node.degree.denominator) > kMaxDegree)
    throw ExpressionFault(at, "the degree of this exceeds " + std::to_string(kMaxDegree),
                          "too many factors or divisions are nested here");
  nodes_.push_back(node);
  return static_cast<int>(nodes_.size()) - 1;
}

void ExpressionBuilder::want_vector(int argument, std::string_view function) const {
  const ExpressionNode& node = (*this)[argument];
  if (node.type == Type::scalar)
    throw ExpressionFault(node.begin, in_quotes(function) + " takes vectors, this is a scalar");
}

void ExpressionBuilder::want_scalar(int operand, std::size_t at, const std::string& message,
                                    std::string hint) const {
  if ((*this)[operand].type == Type::vector) throw ExpressionFault(at, message, std::move(hint));
}

/// What is over a single operand and has its type and order.
ExpressionNode ExpressionBuilder::unary(Operation operation, int a, std::size_t begin,
                                        std::size_t end) const {
  ExpressionNode node = (*this)[a];
  node.operation = operation;
  node.a = a;
  node.b = -1;
  node.begin = static_cast<std::uint32_t>(begin);
  node.end = static_cast<std::uint32_t>(end);
  return node;
}

int ExpressionBuilder::number(const DecimalNumber& number, std::size_t begin, std::size_t end) {
  ExpressionNode node;
  node.number = number;
  node.type = number.mantissa == 0 ? Type::zero : Type::scalar;
  node.begin = static_cast<std::uint32_t>(begin);
  node.end = static_cast<std::uint32_t>(end);
  return push(node, begin);
}

int ExpressionBuilder::quantity(const QuantityFacts& facts, std::size_t begin, std::size_t end) {
  ExpressionNode node;
  node.operation = Operation::quantity;
  node.quantity = facts.quantity;
  node.type = facts.type;
  node.order = facts.order;
  node.begin = static_cast<std::uint32_t>(begin);
  node.end = static_cast<std::uint32_t>(end);
  return push(node, begin);
}

int ExpressionBuilder::constant(int index, double value, std::size_t begin, std::size_t end) {
  ExpressionNode node;
  node.operation = Operation::constant;
  node.integer = index;
  node.number.value = value;
  node.begin = static_cast<std::uint32_t>(begin);
  node.end = static_cast<std::uint32_t>(end);
  return push(node, begin);
}

int ExpressionBuilder::pi(std::size_t begin, std::size_t end) {
  ExpressionNode node;
  node.operation = Operation::pi;
  node.begin = static_cast<std::uint32_t>(begin);
  node.end = static_cast<std::uint32_t>(end);
  return push(node, begin);
}

int ExpressionBuilder::insert(const Expression& meaning, std::size_t begin, std::size_t end) {
  const int first = static_cast<int>(nodes_.size());
  for (ExpressionNode node : meaning.nodes) {
    if (node.a >= 0) node.a += first;
    if (node.b >= 0) node.b += first;
    node.begin = static_cast<std::uint32_t>(begin);
    node.end = static_cast<std::uint32_t>(end);
    push(node, begin);
  }
  return static_cast<int>(nodes_.size()) - 1;
}

int ExpressionBuilder::negate(int a, std::size_t at) {
  return push(unary(Operation::negate, a, at, (*this)[a].end), at);
}

int ExpressionBuilder::add(Operation add_or_subtract, int a, int b, std::size_t at) {
  const ExpressionNode &left = (*this)[a], &right = (*this)[b];
  if (!fit(left.type, right.type))
    throw ExpressionFault(at, std::string(name_of(left.type)) + " and " + std::string(name_of(right.type)) +
                                  " cannot be added");
  ExpressionNode node = binary(add_or_subtract, a, b, left, right);
  node.type = sum_type(left.type, right.type);
  return push(node, at);
}

int ExpressionBuilder::multiply(int a, int b, std::size_t at) {
  const ExpressionNode &left = (*this)[a], &right = (*this)[b];
  if (left.type == Type::vector && right.type == Type::vector)
    throw ExpressionFault(at, "which product of two vectors?", "write dot(a, b) or cross(a, b)");
  ExpressionNode node = binary(Operation::multiply, a, b, left, right);
  const bool vector = left.type == Type::vector || right.type == Type::vector;
  const bool zeros = left.type == Type::zero && right.type == Type::zero;
  node.type = vector ? Type::vector : zeros ? Type::zero : Type::scalar;
  if (left.type == Type::vector) std::swap(node.a, node.b);  // a vector comes second, for who evaluates
  return push(node, at);
}

int ExpressionBuilder::divide(int a, int b, std::size_t at) {
  want_scalar(b, at, "nothing can be divided by a vector", "divide by norm2(v), or by a component");
  const ExpressionNode &left = (*this)[a], &right = (*this)[b];
  ExpressionNode node = binary(Operation::divide, a, b, left, right);
  node.type = left.type;
  return push(node, at);
}

int ExpressionBuilder::power(int a, int exponent, std::size_t at, std::size_t end) {
  want_scalar(a, at, "a vector has no powers", "write norm2(v) for v·v");
  ExpressionNode node = unary(Operation::power, a, (*this)[a].begin, end);
  node.integer = exponent;
  node.type = Type::scalar;
  return push(node, at);
}

int ExpressionBuilder::call(const FunctionFacts& function, const std::vector<int>& arguments, std::size_t at,
                            std::size_t end) {
  using O = Operation;
  if (is_of_numbers(function.operation)) return call_of_numbers(function, arguments, at, end);
  const bool is_rate = function.operation == O::star || function.operation == O::ddt;
  if (function.operation != O::ddt)
    for (const int argument : arguments) want_vector(argument, function.name);
  const ExpressionNode& first = (*this)[arguments.front()];
  ExpressionNode node = binary(function.operation, arguments.front(),
                               arguments.size() > 1 ? arguments[1] : -1, first, (*this)[arguments.back()]);
  node.begin = static_cast<std::uint32_t>(at);
  node.end = static_cast<std::uint32_t>(end);
  const bool is_length = function.operation == O::norm2 || function.operation == O::norm;
  node.type = function.operation == O::dot || is_length ? Type::scalar
              : function.operation == O::ddt            ? first.type
                                                        : Type::vector;
  if (!is_rate) return push(node, at);

  if (first.order == kMaxOrder)
    throw ExpressionFault(first.begin, "the rate of change of this is not known",
                          "derivatives are at most second ones, of ω̇, N and F first ones");
  ++node.order;
  return push(node, at);
}

int ExpressionBuilder::call_of_numbers(const FunctionFacts& function, const std::vector<int>& arguments,
                                       std::size_t at, std::size_t end) {
  for (const int argument : arguments)
    want_scalar(argument, (*this)[argument].begin,
                in_quotes(function.name) + " takes numbers, this is a vector",
                "take a component or a length: dot(a, ez), norm(a)");
  const ExpressionNode& first = (*this)[arguments.front()];
  ExpressionNode node = binary(function.operation, arguments.front(),
                               arguments.size() > 1 ? arguments[1] : -1, first, (*this)[arguments.back()]);
  node.begin = static_cast<std::uint32_t>(at);
  node.end = static_cast<std::uint32_t>(end);
  return push(node, at);
}

int ExpressionBuilder::component(int a, int index, std::size_t at, std::size_t end) {
  want_vector(a, "comp");
  ExpressionNode node = unary(Operation::comp, a, at, end);
  node.integer = index;
  node.type = Type::scalar;
  return push(node, at);
}

int ExpressionBuilder::apply_tensor(int a, std::size_t at, std::size_t end) {
  want_vector(a, "apply");
  ExpressionNode node = unary(Operation::apply, a, at, end);
  node.type = Type::vector;
  return push(node, at);
}

int ExpressionBuilder::trace_of_tensor(std::size_t at, std::size_t end) {
  ExpressionNode node;
  node.operation = Operation::trace;
  node.begin = static_cast<std::uint32_t>(at);
  node.end = static_cast<std::uint32_t>(end);
  return push(node, at);
}

}  // namespace polhode
