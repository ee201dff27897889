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

/// `is_computed`: it may hold what no proof has (TexTerms::has_pi).
Result<Expression, UnreadableEquation> side_of(const Math& math, const EquationNotation& notation,
                                               bool is_computed) {
  if (!math.root) return Failure<UnreadableEquation>{{{}, "there is no formula here", ""}};
  if (!math.live.empty()) return Failure<UnreadableEquation>{{{}, "a computed number stands in it", ""}};
  try {
    check_is_seen(*math.root);
    TexTerms terms(math, notation);
    terms.has_pi = is_computed;
    terms.any_inertia = has_tensor_component(*math.root);
    const TexItems items = items_of(*math.root, kMaxEquationNesting);
    const TexValue value = terms.side(items);
    if (value.is_tensor())
      return Failure<UnreadableEquation>{{value.span, "this is a tensor, no number and no vector", "", true}};
    return expression_of(value, notation.vocabulary);
  } catch (const TexKindFault& fault) {
    return Failure<UnreadableEquation>{{fault.place, fault.what(), fault.hint, true}};
  } catch (const TexFault& fault) {
    return Failure<UnreadableEquation>{{fault.place, fault.what(), fault.hint}};
  }
}

std::optional<Expression> if_read(Result<Expression, UnreadableEquation> read) {
  return read ? std::optional(std::move(*read)) : std::nullopt;
}

}  // namespace

Result<Expression, UnreadableEquation> read_one_side(const Math& math, const EquationNotation& notation) {
  return side_of(math, notation, true);
}

std::optional<Expression> read_side(const Math& math, const EquationNotation& notation) {
  return if_read(side_of(math, notation, true));
}

std::optional<Expression> read_side_of_claim(const Math& math, const EquationNotation& notation) {
  return if_read(side_of(math, notation, false));
}

std::optional<TypedNumber> read_typed(const Math& math) {
  if (!math.root || !math.live.empty()) return std::nullopt;
  try {
    return typed_number(items_of(*math.root, kMaxEquationNesting));
  } catch (const TexFault&) {
    return std::nullopt;
  }
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
