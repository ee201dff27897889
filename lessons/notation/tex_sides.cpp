// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_sides.h"

#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_terms.h"
#include "lessons/notation/tex_units.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Items = TexTerms::Items;

/// T, |L|, 2T; nothing of what is not read, or is no number.
std::optional<Expression> scalar_of(TexTerms& terms, Items items, const EquationNotation& notation) {
  try {
    const TexValue value = terms.side(items);
    return value.is_scalar() ? std::optional(expression_of(value, notation.vocabulary)) : std::nullopt;
  } catch (const TexFault&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<Expression> read_side(const Math& math, const EquationNotation& notation) {
  if (!math.root || !math.live.empty()) return std::nullopt;
  try {
    TexTerms terms(math, notation);
    terms.has_pi = true;
    terms.any_inertia = has_tensor_component(*math.root);
    const TexItems items = items_of(*math.root, kMaxEquationNesting);
    const TexValue value = terms.side(items);
    if (value.is_tensor()) return std::nullopt;
    return expression_of(value, notation.vocabulary);
  } catch (const TexFault&) {
    return std::nullopt;
  }
}

std::optional<TypedNumber> read_typed(const Math& math) {
  if (!math.root || !math.live.empty()) return std::nullopt;
  try {
    return typed_number(items_of(*math.root, kMaxEquationNesting));
  } catch (const TexFault&) {
    return std::nullopt;
  }
}

std::vector<TypedStatement> typed_statements(const Math& math, const EquationNotation& notation) {
  std::vector<TypedStatement> statements;
  if (!math.root || !math.live.empty()) return statements;
  TexItems items;
  try {
    items = whole_formula(*math.root, kMaxEquationNesting);
  } catch (const TexFault&) {
    return statements;
  }
  TexTerms terms(math, notation);
  terms.has_pi = true;
  terms.any_inertia = has_tensor_component(*math.root);
  const auto ends_side = [](const TexItem& item) {
    return item.kind == ItemKind::relation || item.kind == ItemKind::comma || item.kind == ItemKind::gap ||
           item.kind == ItemKind::line;
  };
  std::size_t begin = 0;
  std::optional<Items> left;  // and the relation behind it
  for (std::size_t i = 0; i <= items.size(); ++i) {
    if (i < items.size() && !ends_side(items[i])) continue;
    const Items right = Items(items).subspan(begin, i - begin);
    if (left && !left->empty() && !right.empty()) {
      const auto relation = relation_of(items[begin - 1]);
      const auto number = typed_number(right);
      const bool is_time = left->size() == 1 && is_symbol(left->front(), U't') && is_plain(left->front());
      auto of = number && !typed_number(*left) ? scalar_of(terms, *left, notation) : std::nullopt;
      if (relation && number && (of || is_time)) statements.push_back({std::move(of), *relation, *number});
    }
    left = i < items.size() && items[i].kind == ItemKind::relation ? std::optional(right) : std::nullopt;
    begin = i + 1;
  }
  return statements;
}

std::string words_of_formula(const Math& math) { return math.root ? words_of(*math.root) : ""; }

char32_t letter_of_name(const Math& math) {
  if (!math.root || !math.live.empty()) return 0;
  try {
    return letter_of_name(items_of(*math.root, kMaxEquationNesting));
  } catch (const TexFault&) {
    return 0;
  }
}

std::optional<std::pair<Expression, std::string>> read_in_unit(const Math& math,
                                                               const EquationNotation& notation) {
  if (!math.root || !math.live.empty()) return std::nullopt;
  try {
    const TexItems items = items_of(*math.root, kMaxEquationNesting);
    const auto slash = std::find_if(items.begin(), items.end(),
                                    [](const TexItem& item) { return item.is(ItemKind::times, U'/'); });
    if (slash == items.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(slash - items.begin());
    Items behind = Items(items).subspan(at + 1);
    if (behind.size() == 1 && behind[0].kind == ItemKind::group && behind[0].open == U'(')
      behind = behind[0].inside;
    std::string unit = unit_of(behind);
    if (unit.empty()) return std::nullopt;
    TexTerms terms(math, notation);
    const TexValue value = terms.side(Items(items).first(at));
    if (value.is_tensor()) return std::nullopt;
    return std::pair(expression_of(value, notation.vocabulary), std::move(unit));
  } catch (const TexFault&) {
    return std::nullopt;
  }
}

std::optional<std::string> read_unit_formula(const Math& math) {
  if (!math.root) return std::nullopt;
  try {
    const TexItems items = items_of(*math.root, kMaxEquationNesting);
    std::string unit = unit_of(items);
    return unit.empty() ? std::nullopt : std::optional(std::move(unit));
  } catch (const TexFault&) {
    return std::nullopt;
  }
}

}  // namespace polhode
