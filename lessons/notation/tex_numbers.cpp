// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_numbers.h"

#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_number_parts.h"
#include "lessons/notation/tex_terms.h"
#include "lessons/notation/tex_units.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Items = TexTerms::Items;

constexpr const char* kAlone =
    "let it stand alone between = and commas, its unit within: \\live[unit={kJ}]{T}; write factors and signs "
    "into its expression, words outside of the formula";

class NumberReader {
 public:
  NumberReader(const Math& math, const EquationNotation& notation, const Math* above)
      : math_(math), notation_(notation), above_(above), terms_(math, notation) {
    terms_.any_inertia = has_tensor_component(*math.root);
    terms_.may_be_live = terms_.has_pi = true;
  }

  NumbersInFormula read() {
    const TexItems items = whole_formula(*math_.root, kMaxEquationNesting);
    read_row(items, true);
    if (seen_ != math_.live.size())
      throw TexFault(math_.root->span, "a number that is computed stands where it is not read", kAlone);
    return std::move(result_);
  }

 private:
  struct Side {
    Items items;
    std::size_t numbers = 0;
    std::optional<std::size_t> alone;
    bool has_unit = false, is_list = false;
    std::optional<Expression> value;
    std::optional<TexValue> whole;  ///< a vector, or a tensor
    std::string why_unread, hint;
  };
  struct Chain {
    std::vector<Side> sides;
    std::vector<const TexItem*> relations;  ///< between them
  };

  /// Chains of sides with commas, wide spaces and words between them.
  void read_row(Items items, bool is_whole) {
    std::vector<Chain> chains(1);
    std::size_t begin = 0;
    const auto end_side = [&](std::size_t end) {
      chains.back().sides.emplace_back().items = items.subspan(begin, end - begin);
      begin = end + 1;
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
      const TexItem& item = items[i];
      if (item.kind == ItemKind::relation) {
        end_side(i);
        chains.back().relations.push_back(&item);
      } else if (is_break(item) || (item.kind == ItemKind::text && !is_in_unit(items, i))) {
        if (item.kind == ItemKind::text && !joins_sentences(item))
          throw TexFault(item.span, "words stand in the formula of a number that is computed", kAlone);
        end_side(i);
        chains.emplace_back();
      }
    }
    end_side(items.size());
    std::erase_if(chains, [](const Chain& chain) {
      return chain.relations.empty() && chain.sides.front().items.empty();
    });
    for (Chain& chain : chains) read_chain(chain, is_whole && &chain == &chains.front());
    if (!is_whole || chains.empty()) return;
    // "T = 3.8, 10^3": what is no statement would be read with the number.
    for (const Chain& chain : chains)
      if (chain.relations.empty() && chain.sides.front().numbers == 0 && !is_dots(chain.sides.front().items))
        throw TexFault(place_of(chain.sides.front()),
                       "this stands beside a number that is computed, and states nothing itself", kAlone);
    const Side &first = chains.front().sides.front(), &last = chains.back().sides.back();
    const bool is_bare = !items.empty() && !is_break(items.back());
    if (last.alone && is_bare) {
      result_.last = last.alone;
      result_.last_has_unit = last.has_unit;
    }
    if (first.alone) result_.first = first.alone;
    // "= 3.8": what it is said of stands before the formula.
    const Chain& chain = chains.front();
    if (first.items.empty() && chain.sides.size() > 1) result_.first = chain.sides[1].alone;
  }

  /// Whether words go on with what stands before them as a unit behind a number does.
  bool is_in_unit(Items items, std::size_t at) const {
    if (joins_sentences(items[at]) && items[at].node->text.find_first_not_of(' ') != std::string::npos)
      return false;
    while (at > 0 && !is_break(items[at - 1]) && items[at - 1].kind != ItemKind::relation) {
      --at;
      if (numbers_in(items[at]) > 0 || is_digit(items[at])) return true;
    }
    return false;
  }

  void read_chain(Chain& chain, bool may_go_on) {
    std::size_t numbers = 0;
    for (Side& side : chain.sides) numbers += side.numbers = numbers_in(side.items);
    for (std::size_t i = may_go_on ? 1 : 0; i < chain.sides.size(); ++i)
      if (chain.sides[i].items.empty())
        throw TexFault(chain.relations[i == 0 ? 0 : i - 1]->span, "a side is missing beside this sign",
                       "write both sides in one line, without a comma or a wide space at the sign");
    if (numbers == 0) return;
    seen_ += numbers;
    for (const TexItem* relation : chain.relations)
      if (!relation_of(*relation))
        throw TexFault(relation->span,
                       "beside a number that is computed only = < > \\le \\ge \\approx are read",
                       "say it in words, outside of the formula");
    for (Side& side : chain.sides) read_side(side);
    if (may_go_on && chain.sides.front().items.empty() && above_ != nullptr) take_above(chain.sides.front());
    const auto is_read = [](const Side& side) { return side.value.has_value(); };
    const bool is_compared = std::count_if(chain.sides.begin(), chain.sides.end(), is_read) > 1;
    for (Side& side : chain.sides) {
      if (side.numbers == 0 || side.alone || (side.is_list = is_list(side))) continue;
      if (is_exponential(side) && chain.relations.empty()) continue;
      if (side.value && is_compared) continue;
      throw TexFault(place_of(side),
                     side.value || side.why_unread.empty()
                         ? "what stands beside this computed number makes it another"
                         : "what stands beside this computed number is not read: " + side.why_unread,
                     kAlone);
    }
    for (const Side& side : chain.sides)
      if (side.numbers == 0 && !side.items.empty()) check_other(side, chain);
    compare(chain);
    compare_lists(chain);
  }

  /// Whether a letter of which nothing is known stands in it: the whole then says something of that letter.
  bool has_unknown(Items items, int depth = 0) {
    if (depth > kMaxEquationNesting) return false;
    for (const TexItem& item : items) {
      if (has_unknown(item.inside, depth + 1)) return true;
      if (item.kind != ItemKind::operand) continue;
      if (const auto known = read_item(item)) {
        if (known->uses(Quantity::h) || known->uses(Quantity::k)) return true;  // any numbers
        continue;
      }
      TexItem base = item;
      base.sup = nullptr;
      const char32_t letter = letter_of_name({&base, 1});
      const bool is_own = !is_letter_of_rotation(letter) || (item.sub != nullptr && has_words(*item.sub));
      if (letter != 0 && letter != U't' && is_own && !is_upright(item)) return true;
      if (letter != 0) continue;
      for (const MathNode& child : item.node->children)
        if (has_unknown(items_of(child, kMaxEquationNesting), depth + 1)) return true;
    }
    return false;
  }

  /// Nothing of what is not read; of vectors and tensors the number 0.
  std::optional<Expression> read_item(const TexItem& item) {
    try {
      const TexValue value = terms_.side({&item, 1});
      return value.is_scalar() ? expression_of(value, notation_.vocabulary) : zero_expression();
    } catch (const TexFault&) {
      return std::nullopt;
    }
  }

  /// "3\sqrt{2}\,\text{s}^{-1}": what is made of numbers alone, and a unit. Nothing of other sides.
  std::optional<Expression> number_with_unit(Items items) {
    if (const auto typed = typed_number(items))
      return expression_of(atom_value(in_si(*typed), TexValue::Type::scalar, items.front().span),
                           notation_.vocabulary);
    for (std::size_t k = 1; k < items.size(); ++k) {
      const std::string unit = unit_of(items.subspan(k));
      if (unit.empty()) continue;
      try {
        const TexValue size = atom_value(in_si({1, 1, unit}), TexValue::Type::scalar, items[k].span);
        const TexValue value = multiplied(terms_.side(items.first(k)), size, items[k].span);
        Expression whole = expression_of(value, notation_.vocabulary);
        const bool has_quantity = std::any_of(whole.nodes.begin(), whole.nodes.end(), [](const auto& node) {
          return node.operation == Operation::quantity || node.operation == Operation::constant;
        });
        return has_quantity ? std::nullopt : std::optional(std::move(whole));
      } catch (const TexFault&) {
        continue;
      }
    }
    return std::nullopt;
  }

  /// What stands on the other side of a number is read; or a name of which nothing is known stands in it, and
  /// something is said of that here.
  void check_other(const Side& side, const Chain& chain) {
    const auto is_list = [](const Side& other) { return other.is_list; };
    const bool has_list = std::any_of(chain.sides.begin(), chain.sides.end(), is_list);
    if (side.whole && !has_list)
      throw TexFault(place_of(side), "this is no number, and stands beside one that is computed",
                     "write a component, or the length |\\vec a|");
    if (side.value || side.whole || (has_list && !cells_of(side.items).empty())) return;
    const char32_t letter = letter_of_name(side.items);
    if (letter == 0 && has_unknown(side.items)) return;
    if (letter == 0)
      throw TexFault(
          place_of(side),
          "the other side of a computed number is not read" +
              (side.why_unread.empty() ? std::string() : ": " + side.why_unread),
          side.hint.empty() ? "write what is read, or say it in words outside of the formula" : side.hint);
    const auto is_read = [](const Side& other) { return other.value && !other.items.empty(); };
    const bool is_told = std::count_if(chain.sides.begin(), chain.sides.end(), is_read) > 1 &&
                         std::all_of(chain.relations.begin(), chain.relations.end(),
                                     [](const TexItem* r) { return relation_of(*r) == Relation::equal; });
    if (is_letter_of_rotation(letter) && !is_told)
      throw TexFault(place_of(side),
                     "nothing says what this is, and it looks like a quantity of the motion" +
                         (side.why_unread.empty() ? std::string() : ": " + side.why_unread),
                     "write the quantity itself, or give the lesson a symbol with `means`" +
                         (side.hint.empty() ? std::string() : "; " + side.hint));
    for (const Side& other : chain.sides) {
      std::vector<std::size_t> numbers;
      if (other.alone || other.is_list) collect(other.items.front(), numbers);
      for (const std::size_t number : numbers) result_.names.push_back({number, letter});
    }
  }

  /// The last side of the formula above.
  void take_above(Side& side) const {
    const char* kUnread = "the side that this goes on with, in the formula above, is not read";
    const char* kHint = "write both sides into one formula";
    if (!above_->root) return;
    if (!above_->live.empty()) throw TexFault(math_.root->span, kUnread, kHint);
    TexItems items;
    try {
      items = whole_formula(*above_->root, kMaxEquationNesting);
      std::size_t begin = items.size();
      while (begin > 0 && items[begin - 1].kind != ItemKind::relation) --begin;
      items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(begin));
      TexTerms terms(*above_, notation_);
      terms.has_pi = true;
      terms.any_inertia = has_tensor_component(*above_->root);
      TexValue value = terms.side(items);
      if (value.is_scalar())
        side.value = expression_of(value, notation_.vocabulary);
      else
        side.whole = std::move(value);
    } catch (const TexFault& fault) {
      const char32_t letter = letter_of_name(items);
      if (letter == 0 || is_letter_of_rotation(letter))
        throw TexFault(math_.root->span, std::string(kUnread) + ": " + fault.what(), kHint);
    }
  }

  SourceSpan place_of(const Side& side) const {
    return joined_span(side.items.front().span, side.items.back().span);
  }

  void read_side(Side& side) {
    for (const TexItem& item : side.items)
      if (side.numbers > 0 && item.struck)
        throw TexFault(item.span, "a number that is computed is not struck out");
    side.alone = alone(side.items, side.has_unit);
    if (side.items.empty()) return;
    try {
      std::vector<std::pair<TexValue, TexValue>> labels;
      terms_.labels = &labels;
      TexValue value = terms_.side(side.alone ? side.items.first(1) : side.items);
      if (side.alone && is_percent(*side.alone))
        value = multiplied(value, atom_value("0.01", TexValue::Type::scalar, value.span), value.span);
      terms_.labels = nullptr;
      if (value.is_scalar() && labels.empty()) side.value = expression_of(value, notation_.vocabulary);
      if (!value.is_scalar() && labels.empty() && side.numbers == 0) side.whole = value;
      if (!labels.empty()) side.why_unread = "a brace has a label";
    } catch (const TexFault& fault) {
      terms_.labels = nullptr;
      side.why_unread = fault.what();
      side.hint = fault.hint;
      if (side.numbers == 0) side.value = number_with_unit(side.items);
    }
  }

  /// Of what is typed its author writes what is printed.
  bool is_percent(std::size_t number) const {
    return math_.live[number].typed.empty() && !result_.units.empty() &&
           result_.units.back().number == number && result_.units.back().unit == "%";
  }

  /// A number and its unit.
  std::optional<std::size_t> alone(Items items, bool& has_unit) {
    while (!items.empty() && is_symbol(items.back(), U'.') && is_plain(items.back()))
      items = items.first(items.size() - 1);  // a full stop
    if (items.empty() || !is_plain(items[0])) return std::nullopt;
    const auto number = number_of(items[0]);
    if (!number || *number >= math_.live.size()) return std::nullopt;
    Items behind = items.subspan(1);
    const std::string own = unit_tex(math_.live[*number].unit);
    has_unit = !behind.empty();
    if (!own.empty()) {
      const bool is_own = !behind.empty() && behind[0].kind == ItemKind::text && is_plain(behind[0]) &&
                          own.ends_with("\\text{" + behind[0].node->text + '}');
      return is_own && behind.size() == 1 ? number : std::nullopt;
    }
    if (behind.empty()) return number;
    const bool is_percent = behind.size() == 1 && is_symbol(behind[0], U'%') && is_plain(behind[0]);
    const std::string unit = is_percent ? "%" : unit_of(behind);
    if (unit.empty()) return std::nullopt;
    result_.units.push_back({*number, unit});
    return number;
  }

  /// What stands between brackets or in the cells of a matrix, and a unit behind it.
  bool is_list(const Side& side) {
    const TexItem& first = side.items.front();
    if (first.sub != nullptr || first.sup != nullptr) return false;
    std::vector<std::size_t> numbers;
    if (side.items.size() > 1) {
      const std::string unit = unit_of(side.items.subspan(1));
      if (unit.empty()) return false;
      collect(first, numbers);
      for (const std::size_t number : numbers) result_.units.push_back({number, unit});
    }
    if (first.kind == ItemKind::group && first.open != U'|' && first.open != U'⏟') {
      seen_ -= side.numbers;
      read_row(first.inside, false);
      return true;
    }
    if (first.kind != ItemKind::operand || first.node->kind != Kind::grid) return false;
    const MathGrid& grid = *first.node->grid;
    if ((grid.left != U'(' && grid.left != U'[') || grid.kind == MathGrid::Kind::cases) return false;
    seen_ -= side.numbers;
    for (const MathNode& cell : first.node->children) {
      const TexItems items = items_of(cell, kMaxEquationNesting - 1);
      read_row(items, false);
    }
    return true;
  }

  bool is_exponential(const Side& side) {
    if (side.items.size() != 1 || side.items[0].sup == nullptr || side.items[0].sub != nullptr) return false;
    const TexItem& e = side.items[0];
    if (!is_symbol(e, U'e')) return false;
    const TexItems power = items_of(*e.sup, kMaxEquationNesting);
    bool has_unit = false;
    return alone(power, has_unit) && !has_unit;
  }

  /// Each side that is read with the next one that is; over others only where all signs between are =.
  void compare(Chain& chain) {
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < chain.sides.size(); ++i) {
      Side& right = chain.sides[i];
      if (!right.value) continue;
      const auto last = std::exchange(before, i);
      if (!last) continue;
      Relation relation = *relation_of(*chain.relations[i - 1]);
      bool is_told = true;
      for (std::size_t k = *last; k + 1 < i; ++k)
        is_told = is_told && relation_of(*chain.relations[k]) == Relation::equal;
      if (!is_told) continue;
      Side& left = chain.sides[*last];
      result_.statements.push_back({{*left.value, *right.value}, relation, left.alone, right.alone});
    }
  }

  /// A number, or what is read.
  TexValue value_of_cell(const TexItems& cell, std::optional<std::size_t>& number) {
    bool has_unit = false;
    number = alone(cell, has_unit);
    const auto typed = number ? std::nullopt : typed_number(cell);
    if (typed) return atom_value(in_si(*typed), TexValue::Type::scalar, cell.front().span);
    return terms_.side(number ? Items(cell).first(1) : Items(cell));
  }

  /// Lists of numbers: what they are said to be is a vector or tensor that is read, another list, or a name
  /// of which nothing is known.
  void compare_lists(const Chain& chain) {
    if (chain.relations.empty()) return;
    for (const Side& side : chain.sides) {
      if (!side.is_list) continue;
      for (const TexItem* relation : chain.relations)
        if (is_order(*relation_of(*relation))) throw TexFault(relation->span, "of lists none is the greater");
      for (const Side& other : chain.sides) {
        if (&other == &side || (other.is_list && &other < &side)) continue;
        if (other.whole)
          compare_components(*other.whole, side);
        else if (!other.items.empty() && (other.value || !cells_of(other.items).empty()))
          compare_cells(other, side);
      }
    }
  }

  void compare_cells(const Side& left, const Side& right) {
    const std::vector<TexItems> a = cells_of(left.items), b = cells_of(right.items);
    if (a.size() != b.size())
      throw TexFault(place_of(right), "the two sides of this list have not as many entries",
                     "write a number for each");
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::optional<std::size_t> in_a, in_b;
      const TexValue of_a = value_of_cell(a[i], in_a), of_b = value_of_cell(b[i], in_b);
      if (!in_a && !in_b) continue;
      if (!of_a.is_scalar() || !of_b.is_scalar())
        throw TexFault(place_of(right), "an entry of this list is no number");
      result_.statements.push_back(
          {{expression_of(of_a, notation_.vocabulary), expression_of(of_b, notation_.vocabulary)},
           Relation::equal,
           in_a,
           in_b});
    }
  }

  /// A vector has three components, a tensor nine.
  void compare_components(const TexValue& whole, const Side& side) {
    const std::vector<TexItems> cells = cells_of(side.items);
    const bool is_square = side.items.front().kind == ItemKind::group ||
                           side.items.front().node->grid->columns == (whole.is_tensor() ? 3 : 1) ||
                           (!whole.is_tensor() && side.items.front().node->grid->columns == 3);
    if (cells.size() != (whole.is_tensor() ? 9U : 3U) || !is_square)
      throw TexFault(place_of(side), whole.is_tensor() ? "a tensor has three rows of three components"
                                                       : "a vector has three components");
    ComponentsStatement statement;
    std::vector<std::size_t> numbers;
    collect(side.items.front(), numbers);
    statement.number = numbers.front();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::optional<std::size_t> number;
      const TexValue part = value_of_cell(cells[i], number);
      if (!part.is_scalar()) throw TexFault(place_of(side), "a component is a number");
      const std::size_t row = cells.size() == 9 ? i / 3 : i, column = i % 3;
      for (const char* axes : {"123", "xyz"}) {
        const auto axis = [&](std::size_t k) {
          return atom_value(std::string("e") + axes[k], TexValue::Type::vector, part.span);
        };
        const TexValue vector = whole.is_tensor() ? applied(*whole.tensor, axis(column), part.span) : whole;
        const TexValue on_row = axis(row);
        const TexValue component = called("dot", vector, &on_row, TexValue::Type::scalar, part.span);
        (axes[0] == '1' ? statement.on_body : statement.on_space)
            .push_back(
                {expression_of(component, notation_.vocabulary), expression_of(part, notation_.vocabulary)});
      }
    }
    result_.components.push_back(std::move(statement));
  }

  const Math& math_;
  const EquationNotation& notation_;
  const Math* above_;
  TexTerms terms_;
  NumbersInFormula result_;
  std::size_t seen_ = 0;
};

}  // namespace

Result<NumbersInFormula, UnreadableEquation> read_numbers(const Math& math, const EquationNotation& notation,
                                                          const Math* above) {
  try {
    if (!math.root) return Failure<UnreadableEquation>{{{}, "there is no formula here", ""}};
    return NumberReader(math, notation, above).read();
  } catch (const TexFault& fault) {
    return Failure<UnreadableEquation>{{fault.place, fault.what(), fault.hint}};
  }
}

}  // namespace polhode
