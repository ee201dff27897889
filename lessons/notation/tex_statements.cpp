// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_statements.h"

#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_terms.h"
#include "lessons/notation/tex_units.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

using ItemKind = TexItem::Kind;
using Items = TexTerms::Items;

class StatementReader {
 public:
  StatementReader(const Math& math, const EquationNotation& notation)
      : vocabulary_(notation.vocabulary), terms_(math, notation) {
    terms_.has_pi = true;
    terms_.any_inertia = has_tensor_component(*math.root);
    items_ = whole_formula(*math.root, kMaxEquationNesting);
  }

  Statements read() {
    std::optional<StatedSide> left;
    SourceSpan left_span;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= items_.size(); ++i) {
      if (i < items_.size() && !ends_side(items_[i])) continue;
      const Items items = Items(items_).subspan(begin, i - begin);
      const auto side = side_of(items);
      const SourceSpan span = span_of(items, {});
      if (left && side)
        if (const auto relation = relation_of(items_[begin - 1]))
          result_.links.push_back(
              {std::move(*left), *side, *relation, joined_span(left_span, span), i == items_.size()});
      if (i < items_.size() &&
          (items_[i].is(ItemKind::relation, U'⇒') || items_[i].is(ItemKind::relation, U'⟹')))
        result_.is_condition = true;
      const bool goes_on = i < items_.size() && items_[i].kind == ItemKind::relation;
      left = goes_on ? side : std::nullopt;
      left_span = span;
      begin = i + 1;
    }
    return std::move(result_);
  }

 private:
  static bool ends_side(const TexItem& item) {
    return item.kind == ItemKind::relation || item.kind == ItemKind::comma || item.kind == ItemKind::gap ||
           item.kind == ItemKind::line;
  }

  std::optional<StatedSide> side_of(Items items) {
    while (!items.empty() && is_symbol(items.back(), U'.') && is_plain(items.back()))
      items = items.first(items.size() - 1);  // a full stop
    if (items.empty()) return std::nullopt;
    if (items.size() == 1 && is_symbol(items.front(), U't') && is_plain(items.front())) return StatedSide{};
    StatedSide side;
    try {
      side.typed = typed_number(items);
      std::vector<std::pair<TexValue, TexValue>> labels;
      terms_.labels = &labels;
      const TexValue value = side.typed
                                 ? atom_value(in_si(*side.typed), TexValue::Type::scalar, items.front().span)
                                 : terms_.side(items);
      terms_.labels = nullptr;
      if (value.is_tensor() || !labels.empty()) return std::nullopt;
      side.is = expression_of(value, vocabulary_);
      result_.sides.emplace_back(*side.is, span_of(items, {}));
      return side;
    } catch (const TexFault&) {
      terms_.labels = nullptr;
      note_what_is_not_read(items);
      return std::nullopt;
    }
  }

  void note_what_is_not_read(Items items) {
    for (const TexItem& item : items) {
      if (item.kind == ItemKind::text) result_.words += ' ' + item.node->text;
      if (item.kind == ItemKind::group && item.open == U'(' && items.size() == 1)
        result_.is_condition = result_.is_condition || has_relation(item.inside);
    }
  }

  static bool has_relation(const TexItems& items) {
    return std::any_of(items.begin(), items.end(),
                       [](const TexItem& item) { return item.kind == ItemKind::relation; });
  }

  const Vocabulary& vocabulary_;
  TexTerms terms_;
  TexItems items_;
  Statements result_;
};

}  // namespace

Statements stated_in(const Math& math, const EquationNotation& notation) {
  if (!math.root || !math.live.empty()) return {};
  try {
    return StatementReader(math, notation).read();
  } catch (const TexFault&) {
    return {};
  }
}

std::vector<TypedStatement> typed_statements(const Math& math, const EquationNotation& notation) {
  std::vector<TypedStatement> typed;
  for (StatedLink& link : stated_in(math, notation).links) {
    const bool is_of_scalar = link.left.is_time() || link.left.is->type() != ExpressionType::vector;
    if (link.right.typed && !link.left.typed && is_of_scalar)
      typed.push_back({std::move(link.left.is), link.relation, *link.right.typed});
  }
  return typed;
}

}  // namespace polhode
