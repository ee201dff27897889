// SPDX-License-Identifier: MIT
#include "tests/oracle/term.h"

#include "lessons/claims/expressions/expression_names.h"

#include <algorithm>
#include <stdexcept>

namespace polhode::oracle {
namespace {

Term term_at(const Expression& expression, int index) {
  const ExpressionNode& node = expression.nodes[static_cast<std::size_t>(index)];
  Term term;
  term.operation = node.operation;
  term.integer = node.integer;
  if (node.operation == Operation::number || node.operation == Operation::quantity)
    term.word = expression.text.substr(node.begin, node.end - node.begin);
  for (const int operand : {node.a, node.b})
    if (operand >= 0) term.operands.push_back(term_at(expression, operand));
  return term;
}

std::string_view function_name(Operation operation) {
  const auto found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                  [operation](const auto& f) { return f.operation == operation; });
  return found->name;
}

std::string joined(const Term& term, const char* between) {
  return "(" + text_of(term.operands[0]) + between + text_of(term.operands[1]) + ")";
}

}  // namespace

std::optional<Expression> expression_from(std::string_view text) {
  const SourceText source(text);
  Report report(source, "text");
  return read_expression(text, {1, 1}, report);
}

std::optional<Equality> equality_from(std::string_view left, std::string_view right) {
  auto l = expression_from(left), r = expression_from(right);
  if (!l || !r || !fit(l->type(), r->type())) return std::nullopt;
  return Equality{std::move(*l), std::move(*r)};
}

Term term_of(const Expression& expression) {
  return term_at(expression, static_cast<int>(expression.nodes.size()) - 1);
}

Term term_from(std::string_view text) {
  const auto expression = expression_from(text);
  if (!expression) throw std::invalid_argument("no expression: " + std::string(text));
  return term_of(*expression);
}

std::string text_of(const Term& term) {
  switch (term.operation) {
    case Operation::number:
    case Operation::quantity:
      return term.word;
    case Operation::negate:
      return "(-" + text_of(term.operands[0]) + ")";
    case Operation::add:
      return joined(term, " + ");
    case Operation::subtract:
      return joined(term, " - ");
    case Operation::multiply:
      return joined(term, "*");
    case Operation::divide:
      return joined(term, "/");
    case Operation::power:
      return "(" + text_of(term.operands[0]) + ")^(" + std::to_string(term.integer) + ")";
    case Operation::trace:
      return "trace(J)";
    case Operation::apply:
      return "apply(J, " + text_of(term.operands[0]) + ")";
    case Operation::comp:
      return "comp(" + text_of(term.operands[0]) + ", " + std::to_string(term.integer + 1) + ")";
    default: {
      std::string text = std::string(function_name(term.operation)) + "(";
      for (const Term& operand : term.operands) text += (text.back() == '(' ? "" : ", ") + text_of(operand);
      return text + ")";
    }
  }
}

bool is_vector(const Term& term) {
  switch (term.operation) {
    case Operation::quantity:
      return find_quantity(term.word)->type == ExpressionType::vector;
    case Operation::negate:
    case Operation::divide:
    case Operation::ddt:
      return is_vector(term.operands[0]);
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
      return is_vector(term.operands[0]) || is_vector(term.operands[1]);
    case Operation::cross:
    case Operation::inertia:
    case Operation::apply:
    case Operation::star:
      return true;
    default:
      return false;
  }
}

std::size_t size_of(const Term& term) {
  std::size_t size = 0;
  for_each_spot(term, [&size](const Term&) { ++size; });
  return size;
}

}  // namespace polhode::oracle
