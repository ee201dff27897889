// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/formula_signs.h"

#include "base/numbers.h"
#include "lessons/notation/tex_items.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace polhode {

bool says_no_equality(const MathNode& node) {
  if (node.kind == MathNode::Kind::cancel && node.character == U'n') return true;
  const bool is_relation = node.kind == MathNode::Kind::symbol && node.atom == MathClass::relation;
  if (is_relation && std::u32string_view(U"=<>≤≥⩽⩾≈:⇒⟹⇏").find(node.character) == std::u32string_view::npos)
    return true;
  return std::any_of(node.children.begin(), node.children.end(), says_no_equality);
}

std::set<std::string> operators_in(const MathNode& node) {
  std::set<std::string> found;
  if (node.atom == MathClass::large && node.kind == MathNode::Kind::text && node.text != "tr") {
    static const std::set<std::string, std::less<>> kRead = {"sin", "cos", "arccos", "arctan", "det"};
    if (!kRead.contains(node.text)) found.insert(node.text);
  } else if (node.atom == MathClass::large && node.kind == MathNode::Kind::symbol && node.character != U'∑') {
    found.insert("an integral or another large sign");
  } else if (node.kind == MathNode::Kind::symbol && node.atom == MathClass::binary &&
             std::u32string_view(U"+−⋅×/•∙∘∗").find(node.character) == std::u32string_view::npos) {
    found.insert("a sign of an operation");
  }
  for (const MathNode& child : node.children) found.merge(operators_in(child));
  return found;
}

std::set<Relation> relations_in(const MathNode& node) {
  std::set<Relation> found;
  TexItem item;
  item.character = node.character;
  const bool is_relation = node.kind == MathNode::Kind::symbol && node.atom == MathClass::relation;
  if (const auto relation = is_relation ? relation_of(item) : std::nullopt) found.insert(*relation);
  for (const MathNode& child : node.children) found.merge(relations_in(child));
  return found;
}

std::size_t minuses_in(const MathNode& node) {
  if (node.kind == MathNode::Kind::symbol) return node.character == U'−' ? 1 : 0;
  if (node.kind == MathNode::Kind::scripts) return minuses_in(node.children.front());
  std::size_t count = 0;
  for (const MathNode& child : node.children) count += minuses_in(child);
  return count;
}

/// Of digits and points. What is too large for a double is a factor that no claim has.
double number_of(const std::string& digits) {
  return parse_number(digits).value_or(std::numeric_limits<double>::infinity());
}

void add_factor(double number, std::set<double>& factors) {
  constexpr double kRounding = 1e-9;
  if (number == 0 || number == 1) return;
  const double other_way = 1 / number;
  const bool is_part = number < 1 && std::abs(other_way - std::round(other_way)) < kRounding;
  factors.insert(is_part ? std::round(other_way) : number);
}

std::set<double> factors_in(const MathNode& node) {
  std::set<double> found;
  const std::vector<MathNode>& parts = node.children;
  const auto is_digit = [](const MathNode& one) {
    return one.kind == MathNode::Kind::symbol && one.character >= U'0' && one.character <= U'9' &&
           one.alphabet != Alphabet::bold;
  };
  if (is_digit(node)) add_factor(node.character - U'0', found);
  const bool has_scripts = node.kind == MathNode::Kind::scripts;
  const bool is_row = node.kind == MathNode::Kind::row || node.kind == MathNode::Kind::alphabet ||
                      node.kind == MathNode::Kind::term;
  for (std::size_t i = 0; i < (has_scripts ? 1 : parts.size()); ++i) {
    std::string digits;
    for (; i < parts.size() && is_row; ++i) {
      const bool is_point = parts[i].kind == MathNode::Kind::symbol && parts[i].character == U'.';
      if (!is_digit(parts[i]) && (!is_point || digits.empty())) break;
      digits += static_cast<char>(parts[i].character);
    }
    if (!digits.empty()) add_factor(number_of(digits), found);
    if (i < parts.size()) found.merge(factors_in(parts[i]));
  }
  return found;
}

bool has_empty_script(const MathNode& node) {
  if (node.kind == MathNode::Kind::scripts)
    for (const std::size_t script : {std::size_t{1}, std::size_t{2}})
      if (!node.children[script].absent()) {
        const MathNode& inner = without_groups(node.children[script]);
        if (inner.kind == MathNode::Kind::row && inner.children.empty()) return true;
      }
  return std::any_of(node.children.begin(), node.children.end(), has_empty_script);
}

}  // namespace polhode
