// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/formula_signs.h"

#include "lessons/notation/tex_items.h"

#include <algorithm>
#include <string_view>

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

}  // namespace polhode
