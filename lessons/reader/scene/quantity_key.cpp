// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/quantity_key.h"

#include "base/spelling.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/expressions/scene_quantities.h"
#include "lessons/diagnostics/source_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {
namespace {

const ExpressionNode& node_of(const Expression& expression, int index) {
  return expression.nodes[static_cast<std::size_t>(index)];
}

/// The name that a node was written as, or other text.
std::string name_of(const Expression& expression, int index) {
  const ExpressionNode& node = node_of(expression, index);
  std::string name = expression.text.substr(node.begin, node.end - node.begin);
  std::erase_if(name, [](char c) { return c == '(' || c == ')' || c == ' ' || c == '\t'; });
  return name;
}

bool is_axis(const ExpressionNode& node) {
  return node.operation == Operation::quantity && node.quantity >= Quantity::e1 &&
         node.quantity <= Quantity::ez;
}

/// What an expression is a component or the length of: itself, if it is none.
int subject_of(const Expression& expression, int index) {
  const ExpressionNode& node = node_of(expression, index);
  switch (node.operation) {
    case Operation::comp:
    case Operation::norm:
    case Operation::negate:
      return subject_of(expression, node.a);
    case Operation::dot:
      if (is_axis(node_of(expression, node.b))) return subject_of(expression, node.a);
      if (is_axis(node_of(expression, node.a))) return subject_of(expression, node.b);
      return index;
    default:
      return index;
  }
}

const Symbol* symbol_of(const Expression& expression, int index, const SceneWords& words) {
  if (words.symbols == nullptr) return nullptr;
  const auto found = words.symbols->find(name_of(expression, index));
  return found == words.symbols->end() ? nullptr : &found->second;
}

std::string role_of(const Expression& expression, const SceneWords& words) {
  const int whole = static_cast<int>(expression.nodes.size()) - 1, subject = subject_of(expression, whole);
  for (const int index : {whole, subject})
    if (const Symbol* symbol = symbol_of(expression, index, words);
        symbol != nullptr && !symbol->role.empty())
      return symbol->role;
  const ExpressionNode& node = node_of(expression, subject);
  if (node.operation != Operation::quantity) return "";
  switch (node.quantity) {
    case Quantity::omega:
    case Quantity::w1:
    case Quantity::w2:
    case Quantity::w3:
      return "omega";
    case Quantity::L:
      return "L";
    case Quantity::N:
    case Quantity::N1:
    case Quantity::N2:
    case Quantity::N3:
      return "N";
    default:
      return "";
  }
}

/// As the lesson says, if that is a unit of SI; a torque is in N m, an angle in rad.
std::string unit_of(const Expression& expression, const Dimension& dimension, const SceneWords& words) {
  const int whole = static_cast<int>(expression.nodes.size()) - 1;
  const Symbol* symbol = symbol_of(expression, whole, words);
  if (symbol != nullptr && !symbol->unit.empty() && dimension_of_unit(symbol->unit) == dimension)
    return symbol->unit == "1" ? "" : symbol->unit;
  const Operation operation = node_of(expression, whole).operation;
  if (operation == Operation::acos || operation == Operation::atan2) return "rad";
  return role_of(expression, {}) == "N" ? "N m" : usual_unit(dimension);
}

}  // namespace

std::string usual_unit(const Dimension& dimension) {
  constexpr std::array<std::pair<Dimension, const char*>, 6> kUsual{{{{0, 0, 0}, ""},
                                                                     {{0, 0, -1}, "rad/s"},
                                                                     {{0, 0, -2}, "rad/s²"},
                                                                     {{1, 1, -2}, "N"},
                                                                     {{1, 2, -2}, "J"},
                                                                     {{1, 2, -3}, "W"}}};
  for (const auto& [known, name] : kUsual)
    if (known == dimension) return name;
  return to_string(dimension);
}

bool has_value_on_motions(const Expression& expression, SourcePlace place, Report& report) {
  for (const auto& [quantity, name] : {std::pair(Quantity::h, "h"), std::pair(Quantity::k, "k")})
    if (expression.uses(quantity)) {
      report.error(place, in_quotes(name) + " is any number: no motion says which",
                   "give the lesson a constant: [constants] NAME = 1.5");
      return false;
    }
  if (expression.nodes.size() <= kMaxQuantityNodes) return true;
  report.error(place, "a quantity of a scene has at most " + std::to_string(kMaxQuantityNodes) +
                          " parts, with the lesson's words written out this has " +
                          std::to_string(expression.nodes.size()));
  return false;
}

namespace {

std::optional<ReadQuantity> read_anew(const PlacedText& text, const SceneWords& words, TextReader& texts) {
  Report& report = texts.report();
  const SourcePlace place =
      texts.source().place_of(located_string(texts.source(), text.place, text.text).offset_of(0));
  if (!is_plain_line(text.text)) {
    report.error(text.place, "an expression is one line of text without control characters");
    return std::nullopt;
  }
  auto expression = read_expression(text.text, place, report, words.vocabulary);
  if (!expression) return std::nullopt;
  if (!has_value_on_motions(*expression, place, report)) return std::nullopt;
  static const std::map<int, Dimension> kNone;
  const DimensionReading reading =
      dimension_of(*expression, words.dimensions != nullptr ? *words.dimensions : kNone);
  if (reading.fault) {
    report.error(advanced(place, text.text, reading.fault->begin), reading.fault->message);
    return std::nullopt;
  }
  std::string tex = tex_of(*expression, words.vocabulary), role = role_of(*expression, words),
              unit = reading.dimension ? unit_of(*expression, *reading.dimension, words) : "";
  Expression written = *expression;
  return ReadQuantity{
      scene_quantity(std::move(*expression), std::move(tex), std::move(unit), std::move(role)),
      reading.dimension, std::move(written)};
}

}  // namespace

std::optional<ReadQuantity> read_quantity(const PlacedText& text, const SceneWords& words,
                                          TextReader& texts) {
  if (words.read == nullptr) return read_anew(text, words, texts);
  if (const auto before = words.read->find(text.text); before != words.read->end()) return before->second;
  auto quantity = read_anew(text, words, texts);
  if (quantity) words.read->emplace(text.text, *quantity);
  return quantity;
}

}  // namespace polhode
