// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_statements.h"

#include "lessons/claims/expressions/dimension.h"
#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_terms.h"
#include "lessons/notation/tex_units.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace polhode {
namespace {

using ItemKind = TexItem::Kind;
using Items = TexTerms::Items;

/// What a reader sees of it: without colours, boxes, small spaces and brackets that are not drawn. Indices
/// and powers as they stand.
MathNode as_seen(const MathNode& node) {
  using Kind = MathNode::Kind;
  const auto is_invisible = [](const MathNode& one) {
    return one.kind == Kind::nothing || one.kind == Kind::style ||
           (one.kind == Kind::space && std::abs(one.amount) < kQuad);
  };
  const auto is_relation = [](const MathNode& one) {
    return one.kind == Kind::symbol && one.atom == MathClass::relation;
  };
  if (node.kind == Kind::stacked && is_relation(without_groups(node.children[0])))
    return without_groups(node.children[0]);
  MathNode seen = node;
  if (node.kind == Kind::symbol && node.character == U'≐') seen.character = U'=';
  const bool is_bare = node.kind == Kind::fenced && node.children.size() == 3 &&
                       node.children[0].character == 0 && node.children[2].character == 0;
  if (is_bare) seen.children = {node.children[1]};
  if (is_bare || node.kind == Kind::color || node.kind == Kind::box) seen.kind = Kind::row;
  if (seen.kind == Kind::row || seen.kind == Kind::alphabet || seen.kind == Kind::term)
    std::erase_if(seen.children, is_invisible);
  const std::size_t read = seen.kind == Kind::scripts ? 1 : seen.children.size();
  for (std::size_t i = 0; i < read; ++i) seen.children[i] = as_seen(seen.children[i]);
  return seen;
}

class StatementReader {
 public:
  StatementReader(const Math& math, const EquationNotation& notation)
      : vocabulary_(notation.vocabulary), terms_(math, notation) {
    terms_.has_pi = true;
    terms_.any_inertia = has_tensor_component(*math.root);
    items_ = whole_formula(*math.root, kMaxEquationNesting);
    while (auto inside = inside_of_dress()) items_ = std::move(*inside);
  }

  Statements read() {
    std::optional<Side> left;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= items_.size(); ++i) {
      if (i < items_.size() && !ends_side(items_[i])) continue;
      const Items items = Items(items_).subspan(begin, i - begin);
      auto side = side_of(items);
      if (left && side && begin > 0) link(*left, items_[begin - 1], *side, i == items_.size());
      // "\Rightarrow T = 0" goes on from what stands before the formula, and is stated.
      const bool is_arrow = i < items_.size() && (items_[i].is(ItemKind::relation, U'⇒') ||
                                                  items_[i].is(ItemKind::relation, U'⟹'));
      if (is_arrow && has_relation_before(i)) result_.is_condition = true;
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
    std::optional<double> at_s;
    std::vector<Side> components;  ///< of "(0.5, 3, 0.7)"
    bool is_constant = false;      ///< "\text{const}"
    SourceSpan span;
  };

  /// What stands in braces is stated; a formula in brackets is a condition.
  std::optional<TexItems> inside_of_dress() const {
    if (items_.size() != 1 || items_[0].sub != nullptr || items_[0].sup != nullptr) return std::nullopt;
    const TexItem& all = items_[0];
    const bool is_dressed = all.kind == ItemKind::group && (all.open == U'{' || all.open == U'⏟');
    return is_dressed && has_relation(all.inside) ? std::optional(all.inside) : std::nullopt;
  }

  /// "Since N = 0 ⇒" has one, "\vec\omega ⇒" has not.
  bool has_relation_before(std::size_t end) const {
    return std::any_of(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(end),
                       [](const TexItem& item) {
                         return item.kind == ItemKind::relation && item.character != U'⇒' &&
                                item.character != U'⟹' && item.character != U':';
                       });
  }

  /// Of signs of which nothing is proved as well: what is far larger is larger.
  static std::optional<Relation> relation_stated(const TexItem& sign) {
    switch (sign.character) {
      case U'≠':
      case U'≡':
        return Relation::equal;
      case U'≪':
        return Relation::less;
      case U'≫':
        return Relation::greater;
      case U'≃':
      case U'≅':
        return Relation::approximate;
      default:
        return relation_of(sign);
    }
  }

  static bool ends_side(const TexItem& item) {
    return item.kind == ItemKind::relation || item.kind == ItemKind::comma || item.kind == ItemKind::gap ||
           item.kind == ItemKind::line;
  }

  static bool is_direction(char32_t sign) {
    return std::u32string_view(U"∥∦⟂⊥").find(sign) != std::u32string_view::npos;
  }

  StatedSide stated(const Side& side) const {
    StatedSide stated{std::nullopt, side.typed, side.at_s};
    if (side.value) stated.is = expression_of(*side.value, vocabulary_);
    return stated;
  }

  void link(const Side& left, const TexItem& sign, const Side& right, bool ends_formula) {
    if (left.is_constant) return;
    if (!left.components.empty()) {
      if (left.components.size() == right.components.size())
        for (std::size_t i = 0; i < left.components.size(); ++i)
          link(left.components[i], sign, right.components[i], false);
      return;
    }
    const SourceSpan span = joined_span(left.span, right.span);
    const auto state = [&](const TexValue& a, const TexValue& b) {
      StatedLink link;
      link.left.is = expression_of(a, vocabulary_);
      link.right.is = expression_of(b, vocabulary_);
      link.source = span;
      return link;
    };
    const TexValue zero = atom_value("0", TexValue::Type::zero, span);
    const bool is_equal = sign.character == U'=' || sign.character == U'≡', is_not = sign.character == U'≠';
    try {
      if (right.is_constant) {
        if (!left.value || !is_equal) return;
        result_.links.push_back(state(rate_of(*left.value, true, span), zero));
        result_.links.back().is_of_all_times = true;
      } else if (!right.components.empty()) {
        if (left.value && left.value->is_vector() && is_equal && right.components.size() == 3)
          link_components(left, right);
      } else if (is_direction(sign.character)) {
        if (!left.value || !right.value || !left.value->is_vector() || !right.value->is_vector()) return;
        const bool is_normal = sign.character == U'⟂' || sign.character == U'⊥';
        const TexValue product = called(is_normal ? "dot" : "cross", *left.value, &*right.value,
                                        is_normal ? TexValue::Type::scalar : TexValue::Type::vector, span);
        result_.links.push_back(state(product, zero));
        result_.links.back().is_denied = sign.character == U'∦';
      } else if (const auto relation = relation_stated(sign)) {
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
        link.left.at_s = left.at_s;
        link.right = stated(one);
        link.source = joined_span(left.span, right.span);
        (axes[0] == '1' ? stated_components.on_body : stated_components.on_space).push_back(std::move(link));
      }
    result_.components.push_back(std::move(stated_components));
  }

  /// Between the commas of "(0.5, 3, 0.7)", or in the cells of a column or a row; empty of what is neither.
  static std::vector<TexItems> entries_of(const TexItem& item) {
    if (item.sub != nullptr || item.sup != nullptr) return {};
    std::vector<TexItems> entries;
    if (item.kind == ItemKind::group) {
      if (item.open != U'(' && item.open != U'[') return {};
      entries.emplace_back();
      for (const TexItem& one : item.inside)
        if (one.kind == ItemKind::comma)
          entries.emplace_back();
        else
          entries.back().push_back(one);
    } else if (item.kind == ItemKind::operand && item.node->kind == MathNode::Kind::grid) {
      const MathGrid& grid = *item.node->grid;
      const auto cells = static_cast<int>(item.node->children.size());
      if ((grid.left != U'(' && grid.left != U'[') || (grid.columns != 1 && grid.columns != cells)) return {};
      for (const MathNode& cell : item.node->children)
        entries.push_back(items_of(cell, kMaxEquationNesting - 1));
    }
    return entries;
  }

  /// "(0.5, 3, 0.7)\,\text{rad/s}", each with the unit of all; empty of what is none.
  std::vector<Side> components_of(Items items) {
    const std::vector<TexItems> entries = items.empty() ? std::vector<TexItems>() : entries_of(items.front());
    if (entries.size() < 2) return {};
    std::string unit;
    if (items.size() > 1 && (unit = unit_of(items.subspan(1))).empty()) return {};
    std::vector<Side> components;
    for (const TexItems& entry : entries) {
      const Items one(entry);
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
    }
    return components;
  }

  /// "(t)", "(2)", "(t = 2\,\text{s})" behind a quantity: its value then.
  struct Moment {
    std::optional<double> at_s;  ///< nothing: at any time
  };
  static std::optional<Moment> moment_in(const TexItem& item) {
    if (item.kind != ItemKind::group || item.open != U'(' || item.sub != nullptr || item.sup != nullptr)
      return std::nullopt;
    Items inside(item.inside);
    const bool begins_with_t = !inside.empty() && is_symbol(inside.front(), U't') && is_plain(inside.front());
    if (begins_with_t && inside.size() == 1) return Moment{};
    if (begins_with_t && inside[1].is(ItemKind::relation, U'=')) inside = inside.subspan(2);
    const auto number = typed_number(inside);
    const auto unit = number ? scaled_unit(number->unit) : std::nullopt;
    if (!number || (!number->unit.empty() && (!unit || unit->dimension != kTime))) return std::nullopt;
    return Moment{number->value * (unit ? unit->size : 1)};
  }

  std::optional<Side> side_of(Items items) {
    while (!items.empty() && (is_symbol(items.back(), U'.') || is_symbol(items.back(), U'!')) &&
           is_plain(items.back()))
      items = items.first(items.size() - 1);  // a full stop
    if (items.empty()) return std::nullopt;
    Side side;
    side.span = span_of(items, {});
    if (const auto moment = items.size() > 1 ? moment_in(items.back()) : std::nullopt)
      if (auto value = value_before(items.first(items.size() - 1))) {
        side.value = std::move(value);
        side.at_s = moment->at_s;
        return side;
      }
    if (items.size() == 1 && is_symbol(items.front(), U't') && is_plain(items.front())) return side;
    if (auto then = side_of_a_moment(items)) return then;
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
      if (auto value = value_at_start(items)) {
        side.value = std::move(value);
        side.at_s = 0.0;
        return side;
      }
      note_what_is_not_read(items);
      return std::nullopt;
    }
  }

  /// "2\,T(0)", "|\vec L(0)|": a side whose every quantity is of one time, which stands behind each.
  std::optional<Side> side_of_a_moment(Items items) {
    Side side;
    side.span = span_of(items, {});
    TexItems bare;
    if (!take_moments(items, bare, side.at_s) || !side.at_s) return std::nullopt;
    bare.clear();  // what stands before the first time is of it, too
    if (!take_moments(items, bare, side.at_s)) return std::nullopt;
    try {
      side.value = terms_.side(bare);
      return side.value->is_tensor() ? std::nullopt : std::optional(std::move(side));
    } catch (const TexFault&) {
      return std::nullopt;
    }
  }

  /// Whether what changes is of one time; `bare` is what stands there without that.
  bool take_moments(Items items, TexItems& bare, std::optional<double>& at_s) {
    const auto is_moment = [](const TexItem& item) { return moment_in(item).has_value(); };
    for (std::size_t i = 0; i < items.size(); ++i) {
      TexItem item = items[i];
      const bool is_of_time = i + 1 < items.size() && is_moment(items[i + 1]);
      if (item.kind == ItemKind::group && !item.inside.empty()) {
        item.inside.clear();
        if (!take_moments(items[i].inside, item.inside, at_s)) return false;
      } else if (item.kind == ItemKind::operand && (is_of_time || at_s) &&
                 value_before(items.subspan(i, 1))) {
        const auto moment = is_of_time ? moment_in(items[++i]) : std::nullopt;
        if (!moment || !moment->at_s || *moment->at_s != at_s.value_or(*moment->at_s)) return false;
        at_s = moment->at_s;
      }
      bare.push_back(std::move(item));
    }
    return true;
  }

  /// "T_0", where the lesson has no such symbol: T as the motion begins.
  std::optional<TexValue> value_at_start(Items items) {
    if (items.size() != 1 || items.front().kind != ItemKind::operand || items.front().sub == nullptr)
      return std::nullopt;
    const MathNode& index = without_groups(*items.front().sub);
    if (index.kind != MathNode::Kind::symbol || index.character != U'0') return std::nullopt;
    TexItem bare = items.front();
    bare.sub = nullptr;
    return value_before(Items(&bare, 1));
  }

  /// A quantity by itself, such as T or \vec\omega: of I_1(2) nobody knows that it is no product.
  std::optional<TexValue> value_before(Items items) {
    if (items.size() != 1 || items.front().kind != ItemKind::operand || items.front().sup != nullptr)
      return std::nullopt;
    try {
      TexValue value = terms_.side(items);
      const Expression is = expression_of(value, vocabulary_);
      const bool is_of_motion = value.is_vector() || value.is_scalar();
      return is_of_motion && changes(is) ? std::optional(std::move(value)) : std::nullopt;
    } catch (const TexFault&) {
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
  Math seen = math;
  seen.root = std::make_shared<const MathNode>(as_seen(*math.root));
  try {
    return StatementReader(seen, notation).read();
  } catch (const TexFault&) {
    return {};
  }
}

std::vector<TypedStatement> typed_statements(const Math& math, const EquationNotation& notation) {
  std::vector<TypedStatement> typed;
  for (StatedLink& link : stated_in(math, notation).links) {
    const bool is_of_scalar = link.left.is_time() || link.left.is->type() != ExpressionType::vector;
    const bool is_typed = link.right.typed && !link.left.typed && !link.is_of_a_time();
    if (is_typed && is_of_scalar && !link.is_denied)
      typed.push_back({std::move(link.left.is), link.relation, *link.right.typed});
  }
  return typed;
}

}  // namespace polhode
