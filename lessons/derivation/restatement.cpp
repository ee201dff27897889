// SPDX-License-Identifier: MIT
#include "lessons/derivation/restatement.h"

#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/derivation/canonical_form.h"
#include "lessons/notation/tex_equation.h"

#include <algorithm>

namespace polhode {
namespace {

int axis_of_unit_vector(const ExpressionNode& node) {
  const int axis = static_cast<int>(node.quantity) - static_cast<int>(Quantity::e1);
  return node.operation == Operation::quantity && axis >= 0 && axis < 3 ? axis : -1;
}

/// With I·ω for L, comp(a, n) for dot(a, en), w1 for comp(omega, 1), N1 for comp(N, 1) and I1*w1 for
/// comp(L, 1): so that who writes one for the other writes the same.
class Plain {
 public:
  explicit Plain(const Expression& expression) : from_(expression) {}

  Expression write() {
    again(static_cast<int>(from_.nodes.size()) - 1);
    return {from_.text, std::move(nodes_), from_.constants};
  }

 private:
  const ExpressionNode& at(int index) const { return from_.nodes[static_cast<std::size_t>(index)]; }

  int add(ExpressionNode node, int a = -1, int b = -1) {
    node.a = a;
    node.b = b;
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }

  int add(const ExpressionNode& like, Operation operation, ExpressionType type, int a = -1, int b = -1) {
    ExpressionNode node = like;
    node.operation = operation;
    node.type = type;
    return add(node, a, b);
  }

  int component(const ExpressionNode& like, int of, int axis) {
    const ExpressionNode vector = nodes_[static_cast<std::size_t>(of)];
    const auto on_axis = [&](Quantity first) {
      ExpressionNode node = like;
      node.quantity = static_cast<Quantity>(static_cast<int>(first) + axis);
      return add(node, Operation::quantity, ExpressionType::scalar);
    };
    if (vector.operation == Operation::quantity && vector.quantity == Quantity::omega)
      return on_axis(Quantity::w1);
    if (vector.operation == Operation::quantity && vector.quantity == Quantity::N)
      return on_axis(Quantity::N1);
    if (vector.operation == Operation::inertia) {
      const int moment = on_axis(Quantity::I1), inside = component(like, vector.a, axis);
      return add(like, Operation::multiply, ExpressionType::scalar, moment, inside);
    }
    ExpressionNode node = like;
    node.integer = axis;
    return add(node, Operation::comp, ExpressionType::scalar, of);
  }

  int again(int index) {
    const ExpressionNode& n = at(index);
    if (n.operation == Operation::quantity && n.quantity == Quantity::L) {
      ExpressionNode omega = n;
      omega.quantity = Quantity::omega;
      return add(n, Operation::inertia, ExpressionType::vector, add(omega));
    }
    if (n.operation == Operation::comp) return component(n, again(n.a), n.integer);
    if (n.operation == Operation::dot)
      for (const auto& [vector, axis] : {std::pair(n.a, n.b), std::pair(n.b, n.a)})
        if (axis_of_unit_vector(at(axis)) >= 0)
          return component(n, again(vector), axis_of_unit_vector(at(axis)));
    const int a = n.a >= 0 ? again(n.a) : -1, b = n.b >= 0 ? again(n.b) : -1;
    return add(n, a, b);
  }

  const Expression& from_;
  std::vector<ExpressionNode> nodes_;
};

Expression plain(const Expression& expression) { return Plain(expression).write(); }

/// Whether they are one but for the order of terms and for brackets.
bool are_written_alike(const Expression& a, const Expression& b) {
  return fit(a.type(), b.type()) && expanded_form({plain(a), plain(b)}).empty();
}

/// The vector itself, or one of its components: a question may ask for one.
std::vector<Expression> parts_of(const Expression& asked) {
  std::vector<Expression> parts{asked};
  if (asked.type() != ExpressionType::vector) return parts;
  for (int axis = 0; axis < 3; ++axis) {
    Expression part = asked;
    ExpressionNode node = part.nodes.back();
    node.operation = Operation::comp;
    node.a = static_cast<int>(part.nodes.size()) - 1;
    node.b = -1;
    node.integer = axis;
    node.type = ExpressionType::scalar;
    part.nodes.push_back(node);
    parts.push_back(std::move(part));
  }
  return parts;
}

LawsAssumed laws_assumed_in(const Question& question) {
  if (question.modulo == "free") return LawsAssumed::free;
  return question.modulo == "motion" ? LawsAssumed::motion : LawsAssumed::identity;
}

std::string printed_letter(const std::string& letter) {
  if (letter == kRateOfMore) return "the rate of a product or sum";
  if (letter == "omega") return "ω";
  if (letter == "omega'") return "ω̇";
  return letter.ends_with('\'') ? 'd' + letter.substr(0, letter.size() - 1) + "/dt" : letter;
}

/// Products of vectors that are to be worked out: what they are called.
std::set<std::string> products_in(const Expression& expression) {
  const Expression written = plain(expression);
  std::set<std::string> products;
  if (written.uses(Operation::cross)) products.insert("the cross product");
  if (written.uses(Operation::dot) || written.uses(Operation::norm2)) products.insert("the dot product");
  return products;
}

/// What is in the formula and in what was typed, and is not in the lesson's answer.
std::optional<std::string> left_over(const std::set<std::string>& formula, const std::set<std::string>& typed,
                                     const std::set<std::string>& wanted) {
  const auto found = std::find_if(formula.begin(), formula.end(), [&](const std::string& one) {
    return typed.contains(one) && !wanted.contains(one);
  });
  return found == formula.end() ? std::nullopt : std::optional(*found);
}

void add_letters(const Expression& expression, int index, std::set<std::string>& letters) {
  if (index < 0) return;
  const ExpressionNode& n = expression.nodes[static_cast<std::size_t>(index)];
  const auto letter_of = [&](const ExpressionNode& node) {
    const std::set<std::string> found = letters_in(Expression{"", {node}, {}});
    return found.empty() ? "" : *found.begin();
  };
  if (n.operation == Operation::quantity) {
    const std::string letter = letter_of(n);
    if (is_rate(n))
      letters.insert("omega'");
    else if (letter != "e")
      letters.insert(letter);
    return;
  }
  if (n.operation == Operation::constant && expression.constants)
    letters.insert((*expression.constants)[static_cast<std::size_t>(n.integer)]);
  if (n.operation == Operation::ddt || n.operation == Operation::star) {
    const ExpressionNode& of = expression.nodes[static_cast<std::size_t>(n.a)];
    if (of.operation == Operation::quantity && !is_rate(of)) {
      letters.insert(letter_of(of) + '\'');
      return;
    }
    letters.insert(kRateOfMore);
  }
  if (n.operation == Operation::inertia || n.operation == Operation::apply || n.operation == Operation::trace)
    letters.insert("I");
  add_letters(expression, n.a, letters);
  add_letters(expression, n.b, letters);
}

std::optional<NoAnswer> restated(const Expression& answer, const Question& question, const Prover& prover) {
  const Expression& right = *question.expression;
  const auto is_what_is_asked = [&](const Expression& asked) {
    return fit(asked.type(), right.type()) && is_provable({asked, right}) &&
           prover.settle({asked, right}, laws_assumed_in(question), question.given) == Verdict::holds;
  };
  for (const Expression& formula : question.asked)
    for (const Expression& asked : parts_of(formula)) {
      if (are_written_alike(asked, right)) continue;
      const bool is_same = are_written_alike(answer, asked);
      const auto letter = left_over(letters_in(asked), letters_in(answer), letters_in(right));
      const auto product = left_over(products_in(asked), products_in(answer), products_in(right));
      if ((!is_same && !letter && !product) || !is_what_is_asked(asked)) continue;
      if (is_same) return NoAnswer{"this is what is asked, written again: work it out"};
      if (letter) return NoAnswer{"this is true, and it can be written without " + printed_letter(*letter)};
      return NoAnswer{"this is true, and " + *product + " in it is to be worked out"};
    }
  return std::nullopt;
}

}  // namespace

std::set<std::string> letters_used(const Expression& expression) {
  std::set<std::string> letters;
  add_letters(expression, static_cast<int>(expression.nodes.size()) - 1, letters);
  return letters;
}

std::string printed_letters(const std::vector<std::string>& letters) {
  std::string text;
  for (std::size_t i = 0; i < letters.size(); ++i)
    text += (i == 0 ? "" : i + 1 == letters.size() ? " and " : ", ") + printed_letter(letters[i]);
  return text;
}

std::optional<NoAnswer> why_no_answer(const Expression& answer, const Question& question,
                                      const Prover& prover) {
  if (auto found = restated(answer, question, prover)) return found;
  // Where none acts N is 0, and would be an answer wherever that is one.
  if (laws_assumed_in(question) == LawsAssumed::free && letters_used(answer).contains("N") &&
      !letters_used(*question.expression).contains("N"))
    return NoAnswer{"no torque acts here: say what is left without N", "letters"};
  if (question.letters.empty()) return std::nullopt;
  for (const std::string& letter : letters_used(answer))
    if (std::find(question.letters.begin(), question.letters.end(), letter) == question.letters.end())
      return NoAnswer{"this is true, but it is to be written with " + printed_letters(question.letters) +
                          " alone: " + printed_letter(letter) + " stands in it",
                      "letters"};
  return std::nullopt;
}

}  // namespace polhode
