// SPDX-License-Identifier: MIT
#include "lessons/claims/expression_tex.h"

#include "lessons/claims/expression_names.h"

namespace polhode {
namespace {

/// How tightly a piece of TeX holds together.
enum class Level { sum, negated, product, atom };

struct Piece {
  std::string tex;
  Level level = Level::atom;
  bool begins_with_digit = false;
};

/// "\vec L" without its arrow, as components are written; empty of what has no letter.
std::string_view letter_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::omega:
      return "\\omega";
    case Quantity::L:
      return "L";
    case Quantity::N:
      return "N";
    case Quantity::p:
      return "p";
    case Quantity::v:
      return "v";
    case Quantity::F:
      return "F";
    case Quantity::A:
      return "A";
    default:
      return "";
  }
}

std::string tex_of(Quantity quantity) {
  if (const auto letter = letter_of(quantity); !letter.empty()) return "\\vec " + std::string(letter);
  for (const QuantityFacts& facts : kQuantities) {
    if (facts.quantity != quantity) continue;
    const std::string name(facts.name), last(1, name.back());
    if (name.size() == 1) return name;
    if (facts.type == ExpressionType::vector) return "\\hat e_" + last;
    if (name.front() == 'd') return "\\dot\\omega_" + last;
    if (name.front() == 'w') return "\\omega_" + last;
    return name.substr(0, 1) + "_{" + name.substr(1) + '}';
  }
  return "";
}

class Printer {
 public:
  explicit Printer(const Expression& expression) : expression_(expression) {}

  Piece whole() const { return piece(static_cast<int>(expression_.nodes.size()) - 1); }

 private:
  const ExpressionNode& node(int index) const { return expression_.nodes[static_cast<std::size_t>(index)]; }

  std::string at_least(Level level, int index) const {
    Piece made = piece(index);
    return made.level < level ? '(' + made.tex + ')' : std::move(made.tex);
  }

  /// An operand of a product of vectors: another such product stands in brackets.
  std::string operand(int index) const {
    const Operation operation = node(index).operation;
    const bool is_product = operation == Operation::dot || operation == Operation::cross ||
                            operation == Operation::inertia || operation == Operation::apply;
    std::string tex = at_least(Level::product, index);
    return is_product && tex.front() != '(' ? '(' + tex + ')' : tex;
  }

  Piece number(const ExpressionNode& n) const {
    // Where brackets stand around it, they are among its bytes.
    std::string text = expression_.text.substr(n.begin, n.end - n.begin);
    std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == ' ' || c == '\t'; });
    const std::size_t e = text.find_first_of("eE");
    if (e == std::string::npos) return {text, Level::atom, true};
    std::string exponent = text.substr(e + 1);
    if (exponent.front() == '+') exponent.erase(0, 1);
    return {text.substr(0, e) + "\\cdot 10^{" + exponent + '}', Level::product, true};
  }

  Piece product(const ExpressionNode& n) const {
    const std::string left = at_least(Level::product, n.a);
    const Piece right = piece(n.b);
    const std::string tex = right.level < Level::product ? '(' + right.tex + ')' : right.tex;
    // What stands beside each other is a product; numbers, and products with a sign of their own, need one.
    const bool is_plain = node(n.b).operation != Operation::dot && node(n.a).operation != Operation::dot;
    if (right.begins_with_digit)
      return {left + "\\cdot " + tex, Level::product, piece(n.a).begins_with_digit};
    return {is_plain ? left + "\\," + tex : bracketed(n.a) + "\\," + bracketed(n.b), Level::product,
            piece(n.a).begins_with_digit};
  }

  std::string bracketed(int index) const {
    const Operation operation = node(index).operation;
    std::string tex = at_least(Level::product, index);
    return operation == Operation::dot ? '(' + tex + ')' : tex;
  }

  Piece rate(const char* d, const ExpressionNode& n) const {
    const Operation of = node(n.a).operation;
    const bool is_letter = of == Operation::quantity || of == Operation::norm || of == Operation::norm2;
    const std::string tex = is_letter ? piece(n.a).tex : '(' + piece(n.a).tex + ')';
    return {std::string(d) + tex + "/dt", Level::product};
  }

  Piece component(const ExpressionNode& n) const {
    const std::string index = std::to_string(n.integer + 1);
    if (const ExpressionNode& of = node(n.a); of.operation == Operation::quantity)
      if (const auto letter = letter_of(of.quantity); !letter.empty())
        return {std::string(letter) + '_' + index, Level::atom};
    return {'(' + piece(n.a).tex + ")_" + index, Level::atom};
  }

  Piece piece(int index) const {
    const ExpressionNode& n = node(index);
    switch (n.operation) {
      case Operation::number:
        return number(n);
      case Operation::quantity:
        return {tex_of(n.quantity), Level::atom};
      case Operation::negate:
        return {'-' + at_least(Level::product, n.a), Level::negated};
      case Operation::add:
        return {at_least(Level::sum, n.a) + " + " + at_least(Level::product, n.b), Level::sum};
      case Operation::subtract:
        return {at_least(Level::sum, n.a) + " - " + at_least(Level::product, n.b), Level::sum};
      case Operation::multiply:
        return product(n);
      case Operation::divide:
        return {"\\frac{" + piece(n.a).tex + "}{" + piece(n.b).tex + '}', Level::product};
      case Operation::power: {
        const Operation base = node(n.a).operation;
        const bool is_letter = base == Operation::quantity || base == Operation::comp;
        return {(is_letter ? piece(n.a).tex : '(' + piece(n.a).tex + ')') + "^{" + std::to_string(n.integer) +
                    '}',
                Level::atom};
      }
      case Operation::dot: {
        const bool is_form = node(n.b).operation == Operation::inertia;
        return {operand(n.a) + "\\cdot " + (is_form ? piece(n.b).tex : operand(n.b)), Level::product};
      }
      case Operation::cross:
        return {operand(n.a) + "\\times " + operand(n.b), Level::product};
      case Operation::norm2:
        return {'|' + piece(n.a).tex + "|^2", Level::atom};
      case Operation::norm:
        return {'|' + piece(n.a).tex + '|', Level::atom};
      case Operation::inertia:
        return {"\\mathbf I\\cdot " + operand(n.a), Level::product};
      case Operation::apply:
        return {"\\mathbf J\\cdot " + operand(n.a), Level::product};
      case Operation::comp:
        return component(n);
      case Operation::trace:
        return {"\\text{tr}\\,\\mathbf J", Level::product};
      case Operation::star:
        return rate("d^*", n);
      case Operation::ddt:
        return rate("d", n);
    }
    return {};
  }

  const Expression& expression_;
};

std::string tex_of(const Equality& equality) {
  return tex_of(equality.left) + " = " + tex_of(equality.right);
}

}  // namespace

std::string tex_of(const Expression& expression) { return Printer(expression).whole().tex; }

std::string tex_of(const ClaimLine& line) {
  const std::string tex = tex_of(line.equality);
  return line.conclusion ? tex + "\\;\\not\\Rightarrow\\;" + tex_of(*line.conclusion) : tex;
}

}  // namespace polhode
