// SPDX-License-Identifier: MIT
#include "lessons/notation/typed/expression_typing.h"

#include "base/ascii.h"
#include "base/numbers.h"
#include "lessons/claims/expressions/expression_names.h"

namespace polhode {
namespace {

enum class Level { sum, sign, product, atom };

struct Typed {
  std::string text;
  Level level = Level::atom;
};

class Printer {
 public:
  explicit Printer(const Expression& expression) : expression_(expression) {}

  Typed print(int index) const {
    using O = Operation;
    const ExpressionNode& n = expression_.nodes[static_cast<std::size_t>(index)];
    switch (n.operation) {
      case O::number:
        return {digits(n.number.value, 6), Level::atom};
      case O::constant:
        return {expression_.constants ? (*expression_.constants)[static_cast<std::size_t>(n.integer)] : "?",
                Level::atom};
      case O::quantity:
        return quantity(n.quantity);
      case O::negate:
        return {"-" + within(n.a, Level::sign), Level::sum};
      case O::add:
      case O::subtract:
        return {within(n.a, Level::sum) + (n.operation == O::add ? " + " : " - ") + within(n.b, Level::sign),
                Level::sum};
      case O::multiply: {
        const std::string right = within(n.b, Level::atom);
        return {within(n.a, Level::product) + (is_digit(right.front()) ? "*" : " ") + right, Level::product};
      }
      case O::divide:
        return {within(n.a, Level::atom) + '/' + within(n.b, Level::atom), Level::sign};
      case O::power:
        return {within(n.a, Level::atom) + '^' + std::to_string(n.integer), Level::atom};
      case O::dot:
        return {within(n.a, Level::product) + " . " + within(n.b, Level::product), Level::sign};
      case O::cross:
        return {within(n.a, Level::product) + " x " + within(n.b, Level::product), Level::sign};
      case O::norm2:
      case O::norm:
        return {'|' + print(n.a).text + '|' + (n.operation == O::norm2 ? "^2" : ""), Level::atom};
      case O::inertia:
        return {"I " + within(n.a, Level::atom), Level::product};
      case O::comp:
        return {"comp(" + print(n.a).text + ", " + std::to_string(n.integer + 1) + ')', Level::atom};
      case O::star:
      case O::ddt: {
        const std::string d = n.operation == O::star ? "d*" : "d";
        const Typed of = print(n.a);
        const bool is_name = is_letter(of.text.front()) && of.text.find_first_of(" (/'") == std::string::npos;
        return {d + (is_name ? of.text : '(' + of.text + ')') + "/dt", Level::atom};
      }
      default:
        return {expression_.text.substr(n.begin, n.end - n.begin), Level::atom};
    }
  }

 private:
  std::string within(int index, Level least) const {
    const Typed typed = print(index);
    return typed.level < least ? '(' + typed.text + ')' : typed.text;
  }

  static Typed quantity(Quantity quantity) {
    const std::string name(facts_of(quantity).name);
    if (name.size() == 3 && name.starts_with("dw")) return {name.substr(1) + '\'', Level::atom};
    return {name, Level::atom};
  }

  const Expression& expression_;
};

}  // namespace

std::string typing_of(const Expression& expression, int node) { return Printer(expression).print(node).text; }

}  // namespace polhode
