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
    std::optional<Side> left;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= items_.size(); ++i) {
      if (i < items_.size() && !ends_side(items_[i])) continue;
      const Items items = Items(items_).subspan(begin, i - begin);
      auto side = side_of(items);
      if (left && side && begin > 0) link(*left, items_[begin - 1], *side, i == items_.size());
      if (i < items_.size() &&
          (items_[i].is(ItemKind::relation, U'⇒') || items_[i].is(ItemKind::relation, U'⟹')))
        result_.is_condition = true;
      const bool goes_on = i < items_.size() && items_[i].kind == ItemKind::relation;
      if (goes_on) result_.words += std::string(" ") + kRelationMark + ' ';
      if (i < items_.size() && items_[i].kind == ItemKind::comma) result_.words += ", ";
      left = goes_on ? std::move(side) : std::nullopt;
      begin = i + 1;
    }
    return std::move(result_);
  }

 private:
  /// What stands between two signs, as far as it can be read.
  struct Side {
    std::optional<TexValue> value;  ///< nothing: it is the time, t, or one of the two below
    std::optional<TypedNumber> typed;
    std::vector<Side> components;  ///< of "(0.5, 3, 0.7)"
    bool is_constant = false;      ///< "\text{const}"
    SourceSpan span;
  };

  static bool ends_side(const TexItem& item) {
    return item.kind == ItemKind::relation || item.kind == ItemKind::comma || item.kind == ItemKind::gap ||
           item.kind == ItemKind::line;
  }

  static bool is_direction(char32_t sign) {
    return std::u32string_view(U"∥∦⟂⊥").find(sign) != std::u32string_view::npos;
  }

  StatedSide stated(const Side& side) const {
    StatedSide stated{std::nullopt, side.typed};
    if (side.value) stated.is = expression_of(*side.value, vocabulary_);
    return stated;
  }

  void link(const Side& left, const TexItem& sign, const Side& right, bool ends_formula) {
    if (left.is_constant || !left.components.empty()) return;
    const SourceSpan span = joined_span(left.span, right.span);
    const auto state = [&](const TexValue& a, const TexValue& b) {
      StatedLink link;
      link.left.is = expression_of(a, vocabulary_);
      link.right.is = expression_of(b, vocabulary_);
      link.source = span;
      return link;
    };
    const TexValue zero = atom_value("0", TexValue::Type::zero, span);
    const bool is_equal = sign.character == U'=', is_not = sign.character == U'≠';
    try {
      if (right.is_constant) {
        if (!left.value || !is_equal) return;
        result_.links.push_back(state(rate_of(*left.value, true, span), zero));
        result_.links.back().is_of_all_times = true;
      } else if (!right.components.empty()) {
        if (left.value && left.value->is_vector() && is_equal) link_components(left, right);
      } else if (is_direction(sign.character)) {
        if (!left.value || !right.value || !left.value->is_vector() || !right.value->is_vector()) return;
        const bool is_normal = sign.character == U'⟂' || sign.character == U'⊥';
        const TexValue product = called(is_normal ? "dot" : "cross", *left.value, &*right.value,
                                        is_normal ? TexValue::Type::scalar : TexValue::Type::vector, span);
        result_.links.push_back(state(product, zero));
        result_.links.back().is_denied = sign.character == U'∦';
      } else if (const auto relation = is_not ? std::optional(Relation::equal) : relation_of(sign)) {
        result_.links.push_back({stated(left), stated(right), *relation, is_not, false, span, ends_formula});
      }
    } catch (const TexFault&) {  // of such kinds nothing is read
    }
  }

  void link_components(const Side& left, const Side& right) {
    StatedComponents stated_components;
    for (const char* axes : {"123", "xyz"})
      for (std::size_t i = 0; i < right.components.size(); ++i) {
        const Side& one = right.components[i];
        if (!one.value) return;
        const TexValue axis = atom_value(std::string("e") + axes[i], TexValue::Type::vector, one.span);
        StatedLink link;
        link.left.is =
            expression_of(called("dot", *left.value, &axis, TexValue::Type::scalar, one.span), vocabulary_);
        link.right = stated(one);
        link.source = joined_span(left.span, right.span);
        (axes[0] == '1' ? stated_components.on_body : stated_components.on_space).push_back(std::move(link));
      }
    result_.components.push_back(std::move(stated_components));
  }

  /// "(0.5, 3, 0.7)\,\text{rad/s}", each with the unit of all; empty of what is none.
  std::vector<Side> components_of(Items items) {
    if (items.empty() || items.front().kind != ItemKind::group || items.front().sub != nullptr ||
        items.front().sup != nullptr)
      return {};
    std::string unit;
    if (items.size() > 1 && (unit = unit_of(items.subspan(1))).empty()) return {};
    std::vector<Side> components;
    const Items inside(items.front().inside);
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= inside.size(); ++i) {
      if (i < inside.size() && inside[i].kind != ItemKind::comma) continue;
      const Items one = inside.subspan(begin, i - begin);
      if (one.empty()) return {};
      Side side;
      side.span = span_of(one, {});
      side.typed = typed_number(one);
      if (!side.typed && !unit.empty()) return {};
      if (side.typed && !unit.empty()) side.typed->unit = unit;
      side.value =
          side.typed ? atom_value(in_si(*side.typed), TexValue::Type::scalar, side.span) : terms_.side(one);
      if (!side.value->is_scalar()) return {};
      components.push_back(std::move(side));
      begin = i + 1;
    }
    return components.size() == 3 ? components : std::vector<Side>();
  }

  std::optional<Side> side_of(Items items) {
    while (!items.empty() && is_symbol(items.back(), U'.') && is_plain(items.back()))
      items = items.first(items.size() - 1);  // a full stop
    if (items.empty()) return std::nullopt;
    Side side;
    side.span = span_of(items, {});
    if (items.size() == 1 && is_symbol(items.front(), U't') && is_plain(items.front())) return side;
    if (says_constant(items)) {
      side.is_constant = true;
      return side;
    }
    try {
      side.components = components_of(items);
      if (!side.components.empty()) return side;
      side.typed = typed_number(items);
      std::vector<std::pair<TexValue, TexValue>> labels;
      terms_.labels = &labels;
      side.value = side.typed ? atom_value(in_si(*side.typed), TexValue::Type::scalar, items.front().span)
                              : terms_.side(items);
      terms_.labels = nullptr;
      if (side.value->is_tensor() || !labels.empty()) return std::nullopt;
      result_.sides.emplace_back(expression_of(*side.value, vocabulary_), side.span);
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
    if (link.right.typed && !link.left.typed && is_of_scalar && !link.is_denied)
      typed.push_back({std::move(link.left.is), link.relation, *link.right.typed});
  }
  return typed;
}

}  // namespace polhode
