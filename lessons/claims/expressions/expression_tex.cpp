// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression_tex.h"

#include "lessons/claims/expressions/expression_names.h"

#include <cctype>

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
std::string_view letter_of(Quantity quantity) { return facts_of(quantity).arrow_letter; }

}  // namespace

std::string tex_of(Quantity quantity) {
  if (const auto letter = letter_of(quantity); !letter.empty())
    return (letter.front() == '\\' ? "\\vec" : "\\vec ") + std::string(letter);
  for (const QuantityFacts& facts : kQuantities) {
    if (facts.quantity != quantity) continue;
    std::string name(facts.name);
    const std::string last(1, name.back());
    if (name.size() == 1) return name;
    if (facts.type == ExpressionType::vector) return "\\hat e_" + last;  // of the body, or of space
    if (name.front() == 'd') return "\\dot\\omega_" + last;
    if (name.front() == 'w') return "\\omega_" + last;
    return name.size() == 2 ? name.substr(0, 1) + '_' + last : "J_{" + name.substr(1) + '}';
  }
  return "";
}

namespace {

class Printer {
 public:
  Printer(const Expression& expression, const Vocabulary* vocabulary)
      : expression_(expression), vocabulary_(vocabulary) {}

  Piece whole() const { return piece(static_cast<int>(expression_.nodes.size()) - 1); }

 private:
  const ExpressionNode& node(int index) const { return expression_.nodes[static_cast<std::size_t>(index)]; }

  /// The lesson's word that a node was written as; all that stands below it was not written.
  const Vocabulary::Word* word(const ExpressionNode& n) const {
    if (vocabulary_ == nullptr) return nullptr;
    std::string_view text(expression_.text);
    text = text.substr(n.begin, n.end - n.begin);
    const std::size_t begin = text.find_first_not_of("( \t"), end = text.find_last_not_of(") \t");
    return begin == text.npos ? nullptr : vocabulary_->find(text.substr(begin, end - begin + 1));
  }

  /// A letter, or a command, perhaps with an index.
  static bool is_letter(std::string_view tex) {
    if (tex.empty()) return false;
    std::size_t end = 1;
    while (tex.front() == '\\' && end < tex.size() && std::isalpha(static_cast<unsigned char>(tex[end])))
      ++end;
    return end == tex.size() || tex[end] == '_';
  }

  std::string at_least(Level level, int index) const {
    Piece made = piece(index);
    return made.level < level ? '(' + made.tex + ')' : std::move(made.tex);
  }

  /// An operand of a product of vectors: another such product stands in brackets.
  std::string operand(int index) const {
    const Piece made = piece(index);
    return made.level < Level::product || has_sign(index) ? '(' + made.tex + ')' : made.tex;
  }

  /// Whether the sign of a product of vectors, or a tensor's name, shows outside of brackets.
  bool has_sign(int index) const {
    const ExpressionNode& n = node(index);
    switch (n.operation) {
      case Operation::dot:
      case Operation::cross:
      case Operation::inertia:
      case Operation::apply:
      case Operation::trace:
        return word(n) == nullptr;
      case Operation::multiply:
        return has_sign(n.a) || has_sign(n.b);
      default:
        return false;
    }
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
    const std::string left = factor(n.a), right = factor(n.b);
    // What stands side by side is a product; but 2 3 and 2 3/4 would be other numbers.
    const bool are_numbers =
        piece(n.b).begins_with_digit || (node(n.b).operation == Operation::divide && ends_in_number(n.a));
    return {left + (are_numbers ? "\\cdot " : "\\,") + right, Level::product, piece(n.a).begins_with_digit};
  }

  /// A factor of a product without a sign.
  std::string factor(int index) const {
    const Piece made = piece(index);
    const Operation operation = node(index).operation;
    const bool splits =
        word(node(index)) == nullptr && (operation == Operation::dot || operation == Operation::trace);
    return made.level < Level::product || splits ? '(' + made.tex + ')' : made.tex;
  }

  bool ends_in_number(int index) const {
    const ExpressionNode& n = node(index);
    return n.operation == Operation::multiply ? ends_in_number(n.b) : n.operation == Operation::number;
  }

  Piece rate(const char* d, const ExpressionNode& n) const {
    const ExpressionNode& below = node(n.a);
    if (n.operation == Operation::ddt && word(below) == nullptr) {
      if (below.operation == Operation::quantity && facts_of(below.quantity).name.starts_with("dw"))
        return {"\\ddot\\omega_" + std::string(1, facts_of(below.quantity).name.back()), Level::atom};
      if (below.operation == Operation::ddt) return fraction_of_rate("d^2", "dt^2", node(n.a));
    }
    return fraction_of_rate(d, "dt", n);
  }

  Piece fraction_of_rate(const char* d, const char* dt, const ExpressionNode& n) const {
    const Operation of = node(n.a).operation;
    const bool is_atom = of == Operation::quantity || of == Operation::norm || of == Operation::norm2 ||
                         (of == Operation::comp && node(node(n.a).a).operation == Operation::quantity);
    const Vocabulary::Word* said = word(node(n.a));
    const bool stands_alone = said == nullptr ? is_atom : is_letter(said->tex);
    const std::string tex = stands_alone ? piece(n.a).tex : '(' + piece(n.a).tex + ')';
    return {"\\frac{" + std::string(d) + tex + "}{" + dt + '}', Level::product};
  }

  Piece component(const ExpressionNode& n) const {
    const std::string index = std::to_string(n.integer + 1);
    if (const ExpressionNode& of = node(n.a); of.operation == Operation::quantity)
      if (const auto letter = letter_of(of.quantity); !letter.empty())
        return {std::string(letter) + '_' + index, Level::atom};
    return {'(' + piece(n.a).tex + ")_" + index, Level::atom};
  }

  /// A function of numbers: \cos\theta, \cos(2\theta).
  Piece function(const char* name, const ExpressionNode& n) const {
    const Vocabulary::Word* said = word(node(n.a));
    const bool stands_alone =
        said == nullptr ? node(n.a).operation == Operation::quantity : is_letter(said->tex);
    if (stands_alone) return {std::string(name) + ' ' + piece(n.a).tex, Level::product};
    return {std::string(name) + '(' + piece(n.a).tex + ')', Level::product};
  }

  Piece piece(int index) const {
    const ExpressionNode& n = node(index);
    if (const Vocabulary::Word* said = word(n)) {
      const std::string& tex = said->tex;
      if (tex.empty()) return {"\\text{" + said->name + '}', Level::atom};  // upright: no letter looks so
      return {tex, is_letter(tex) ? Level::atom : Level::product};
    }
    switch (n.operation) {
      case Operation::number:
        return number(n);
      case Operation::constant:
        return {expression_.constants ? (*expression_.constants)[static_cast<std::size_t>(n.integer)] : "",
                Level::atom};
      case Operation::pi:
        return {"\\pi", Level::atom};
      case Operation::sqrt:
        return {"\\sqrt{" + piece(n.a).tex + '}', Level::atom};
      case Operation::sin:
        return function("\\sin", n);
      case Operation::cos:
        return function("\\cos", n);
      case Operation::acos:
        return function("\\arccos", n);
      case Operation::exp:
        return function("\\exp", n);
      case Operation::log:
        return function("\\ln", n);
      case Operation::atan2:
        return {"\\text{atan2}(" + piece(n.a).tex + ", " + piece(n.b).tex + ')', Level::product};
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
        const Vocabulary::Word* said = word(node(n.a));
        const bool stands_alone =
            said == nullptr ? base == Operation::quantity || base == Operation::comp : is_letter(said->tex);
        return {(stands_alone ? piece(n.a).tex : '(' + piece(n.a).tex + ')') + "^{" +
                    std::to_string(n.integer) + '}',
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
  const Vocabulary* vocabulary_;
};

std::string tex_of(const Equality& sides, Relation relation, const Vocabulary* vocabulary) {
  return tex_of(sides.left, vocabulary) + ' ' + std::string(tex_of(relation)) + ' ' +
         tex_of(sides.right, vocabulary);
}

}  // namespace

std::string tex_of(const Expression& expression, const Vocabulary* vocabulary) {
  return Printer(expression, vocabulary).whole().tex;
}

std::string tex_of(const ClaimLine& line, ClaimKind kind, const Vocabulary* vocabulary) {
  std::string tex = tex_of(line.equality, line.relation, vocabulary);
  if (!line.conclusion) return tex;
  const char* arrow = kind == ClaimKind::non_sequitur ? "\\;\\not\\Rightarrow\\;" : "\\;\\Rightarrow\\;";
  return tex + arrow + tex_of(*line.conclusion, Relation::equal, vocabulary);
}

std::string tex_of(const Setting& setting, const Vocabulary* vocabulary) {
  return tex_of(setting.quantity) + " = " + tex_of(setting.value, vocabulary);
}

std::string tex_of(const Bound& bound, const Vocabulary* vocabulary) {
  return tex_of(bound.sides, bound.relation, vocabulary);
}

std::vector<std::string> printed_conditions(const Given& given) {
  std::vector<std::string> printed;
  for (const Setting& setting : given.settings) printed.push_back(setting.tex);
  for (const Bound& bound : given.bounds) printed.push_back(bound.tex);
  return printed;
}

std::vector<std::string> printed_small(const Given& given) {
  std::vector<std::string> printed;
  for (const Quantity quantity : given.small.quantities) printed.push_back(tex_of(quantity));
  return printed;
}

}  // namespace polhode
