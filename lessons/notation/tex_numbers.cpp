// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_numbers.h"

#include "lessons/claims/dimension.h"
#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_terms.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Items = TexTerms::Items;

std::size_t numbers_below(const MathNode& node) {
  if (index_of_live(node)) return 1;
  std::size_t count = 0;
  for (const MathNode& child : node.children) count += numbers_below(child);
  return count;
}

std::size_t numbers_in(const TexItem& item) {
  if (item.kind == ItemKind::group && item.open != U'⏟') {
    std::size_t count = 0;
    for (const TexItem& inner : item.inside) count += numbers_in(inner);
    for (const MathNode* script : {item.sub, item.sup})
      if (script != nullptr) count += numbers_below(*script);
    return count;
  }
  std::size_t count = 0;
  for (const MathNode* part : {item.node, item.sub, item.sup, item.label})
    if (part != nullptr) count += numbers_below(*part);
  return count;
}

std::size_t numbers_in(Items items) {
  std::size_t count = 0;
  for (const TexItem& item : items) count += numbers_in(item);
  return count;
}

std::optional<std::size_t> number_of(const TexItem& item) {
  if (item.kind != ItemKind::operand || item.node == nullptr) return std::nullopt;
  return index_of_live(*item.node);
}

/// "2" or "-1" of a power that units have; nothing of another.
std::optional<int> power_of(const MathNode* sup) {
  if (sup == nullptr) return 1;
  const TexItems items = items_of(*sup, kMaxEquationNesting);
  const bool minus = items.size() == 2 && items[0].is(ItemKind::sign, U'−');
  if (items.size() != 1 && !minus) return std::nullopt;
  const TexItem& digit = items.back();
  if (!is_digit(digit) || !is_plain(digit)) return std::nullopt;
  const int power = static_cast<int>(digit.node->character - U'0');
  return minus ? -power : power;
}

/// The unit that words and upright letters make, "kg m^2/s"; empty if they make none.
std::string unit_of(Items items) {
  std::string above, below, word;
  bool is_below = false;
  const auto end_word = [&](int power) {
    if (word.empty()) return true;
    std::string& into = (power < 0) != is_below ? below : above;
    const std::string raised = std::abs(power) == 1 ? "" : '^' + std::to_string(std::abs(power));
    const std::size_t slash = word.find('/');
    if (slash != word.npos && (power != 1 || is_below)) return false;
    into += (into.empty() ? "" : " ") + word.substr(0, slash) + raised;
    if (slash != word.npos) below += (below.empty() ? "" : " ") + word.substr(slash + 1);
    word.clear();
    return true;
  };
  std::uint32_t end = 0;
  for (const TexItem& item : items) {
    const bool is_letter = item.kind == ItemKind::operand && item.node != nullptr &&
                           item.node->kind == Kind::symbol && item.node->alphabet == Alphabet::upright;
    if (item.sub != nullptr || item.struck) return "";
    if (item.is(ItemKind::times, U'/') || item.is(ItemKind::times, U'⋅')) {
      if (!end_word(1) || (item.character == U'/' && is_below)) return "";
      is_below = is_below || item.character == U'/';
      continue;
    }
    const auto power = power_of(item.sup);
    if (!power || *power == 0) return "";
    if (item.kind == ItemKind::text) {
      const std::string& text = item.node->text;
      const std::size_t first = text.find_first_not_of(' ');
      if (!end_word(1)) return "";
      if (first == text.npos) continue;
      word = text.substr(first, text.find_last_not_of(' ') - first + 1);
    } else if (is_letter && item.node->character < 0x80) {
      if (item.span.begin > end && !end_word(1)) return "";
      word += static_cast<char>(item.node->character);
    } else if (is_symbol(item, U'°')) {
      if (!end_word(1)) return "";
      word = "°";
    } else {
      return "";
    }
    end = item.span.end;
    if ((item.sup != nullptr || item.kind == ItemKind::text) && !end_word(*power)) return "";
  }
  if (!end_word(1) || (above.empty() && below.empty())) return "";
  const std::string unit = (above.empty() ? "1" : above) + (below.empty() ? "" : '/' + below);
  return scaled_unit(unit) ? unit : "";
}

bool is_break(const TexItem& item) {
  return item.kind == ItemKind::comma || item.kind == ItemKind::gap || item.kind == ItemKind::line;
}

constexpr const char* kAlone =
    "let it stand alone between = and commas, its unit within: \\live[unit={kJ}]{T}; write factors and signs "
    "into its expression, words outside of the formula";

class NumberReader {
 public:
  NumberReader(const Math& math, const EquationNotation& notation, const Math* above)
      : math_(math), notation_(notation), above_(above), terms_(math, notation) {
    terms_.any_inertia = has_tensor_component(*math.root);
    terms_.may_be_live = true;
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
    bool has_unit = false;
    std::optional<Expression> value;
    std::optional<TexValue> whole;  ///< a vector, or a tensor
    std::string why_unread;
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
        if (item.kind == ItemKind::text) check_words(items, i);
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
    const Side &first = chains.front().sides.front(), &last = chains.back().sides.back();
    const bool is_bare = !items.empty() && !is_break(items.back());
    if (last.alone && !last.has_unit && is_bare) result_.last = last.alone;
    if (first.alone) result_.first = first.alone;
    // "= 3.8": what it is said of stands before the formula.
    const Chain& chain = chains.front();
    if (first.items.empty() && chain.sides.size() > 1) result_.first = chain.sides[1].alone;
  }

  /// Whether words go on with what stands before them as a unit behind a number does.
  bool is_in_unit(Items items, std::size_t at) const {
    while (at > 0 && !is_break(items[at - 1]) && items[at - 1].kind != ItemKind::relation) {
      --at;
      if (numbers_in(items[at]) > 0) return true;
    }
    return false;
  }

  void check_words(Items items, std::size_t at) const {
    const bool before = at + 1 < items.size() && numbers_in(items[at + 1]) > 0;
    if (before) throw TexFault(items[at].span, "words stand beside a number that is computed", kAlone);
  }

  void read_chain(Chain& chain, bool may_go_on) {
    std::size_t numbers = 0;
    for (Side& side : chain.sides) numbers += side.numbers = numbers_in(side.items);
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
    for (const Side& side : chain.sides) {
      if (side.numbers == 0 || side.alone || is_list(side)) continue;
      if (is_exponential(side) && chain.relations.empty()) continue;
      if (side.value && is_compared) continue;
      throw TexFault(place_of(side),
                     side.value || side.why_unread.empty()
                         ? "what stands beside this computed number makes it another"
                         : "what stands beside this computed number is not read: " + side.why_unread,
                     kAlone);
    }
    compare(chain);
    compare_components(chain);
  }

  /// The last side of the formula above, if it can be read.
  void take_above(Side& side) const {
    if (!above_->root || !above_->live.empty()) return;
    try {
      const TexItems items = whole_formula(*above_->root, kMaxEquationNesting);
      std::size_t begin = items.size();
      while (begin > 0 && items[begin - 1].kind != ItemKind::relation) --begin;
      TexTerms terms(*above_, notation_);
      terms.any_inertia = has_tensor_component(*above_->root);
      TexValue value = terms.side(Items(items).subspan(begin));
      if (value.is_scalar())
        side.value = expression_of(value, notation_.vocabulary);
      else
        side.whole = std::move(value);
    } catch (const TexFault&) {
      return;
    }
  }

  SourceSpan place_of(const Side& side) const {
    return joined_span(side.items.front().span, side.items.back().span);
  }

  static std::optional<Relation> relation_of(const TexItem& item) {
    switch (item.character) {
      case U'=':
        return Relation::equal;
      case U'<':
        return Relation::less;
      case U'>':
        return Relation::greater;
      case U'≤':
      case U'⩽':
        return Relation::less_or_equal;
      case U'≥':
      case U'⩾':
        return Relation::greater_or_equal;
      case U'≈':
        return Relation::approximate;
      default:
        return std::nullopt;
    }
  }

  void read_side(Side& side) {
    for (const TexItem& item : side.items)
      if (side.numbers > 0 && item.struck)
        throw TexFault(item.span, "a number that is computed is not struck out");
    side.alone = alone(side.items, side.has_unit);
    try {
      std::vector<std::pair<TexValue, TexValue>> labels;
      terms_.labels = &labels;
      const TexValue value = terms_.side(side.alone ? side.items.first(1) : side.items);
      terms_.labels = nullptr;
      if (value.is_scalar() && labels.empty()) side.value = expression_of(value, notation_.vocabulary);
      if (!value.is_scalar() && labels.empty() && side.numbers == 0) side.whole = value;
      if (!labels.empty()) side.why_unread = "a brace has a label";
    } catch (const TexFault& fault) {
      terms_.labels = nullptr;
      side.why_unread = fault.what();
    }
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
    if (grid.left == U'|' || grid.right == U'|' || grid.kind == MathGrid::Kind::cases) return false;
    seen_ -= side.numbers;
    for (const MathNode& cell : first.node->children) {
      const TexItems items = items_of(cell, kMaxEquationNesting - 1);
      read_row(items, false);
    }
    return true;
  }

  void collect(const TexItem& item, std::vector<std::size_t>& numbers) const {
    const auto below = [&](const auto& self, const MathNode& node) -> void {
      if (const auto index = index_of_live(node)) numbers.push_back(*index);
      for (const MathNode& child : node.children) self(self, child);
    };
    if (item.node != nullptr && item.kind == ItemKind::operand) below(below, *item.node);
    for (const TexItem& inner : item.inside) collect(inner, numbers);
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

  /// The scalars between the brackets or in the cells of a side; empty if it is no list of 3, or matrix of 9.
  std::vector<TexValue> components_of(const Side& side) {
    std::vector<TexValue> parts;
    const TexItem& first = side.items.front();
    std::vector<TexItems> cells;
    if (first.kind == ItemKind::group && first.open == U'(') {
      cells.emplace_back();
      for (const TexItem& item : first.inside) {
        if (item.kind == ItemKind::comma)
          cells.emplace_back();
        else if (item.kind != ItemKind::gap)
          cells.back().push_back(item);
      }
    } else if (first.kind == ItemKind::operand && first.node->kind == Kind::grid) {
      const int columns = first.node->grid->columns;
      if (columns != 1 && columns != 3) return {};
      for (const MathNode& cell : first.node->children)
        cells.push_back(items_of(cell, kMaxEquationNesting - 1));
    }
    if (cells.size() != 3 && cells.size() != 9) return {};
    for (const TexItems& cell : cells) {
      bool has_unit = false;
      const bool is_alone = alone(cell, has_unit).has_value();
      parts.push_back(terms_.side(is_alone ? Items(cell).first(1) : Items(cell)));
      if (!parts.back().is_scalar()) return {};
    }
    return parts;
  }

  /// Of what a list of components is said to be, where that is a vector or tensor that can be read.
  void compare_components(const Chain& chain) {
    const auto whole = std::find_if(chain.sides.begin(), chain.sides.end(),
                                    [](const Side& side) { return side.whole.has_value(); });
    if (whole == chain.sides.end()) return;
    for (const Side& side : chain.sides) {
      if (side.numbers == 0 || side.items.empty()) continue;
      try {
        const std::vector<TexValue> parts = components_of(side);
        if (parts.empty() || (parts.size() == 9) != whole->whole->is_tensor()) continue;
        ComponentsStatement statement;
        std::vector<std::size_t> numbers;
        collect(side.items.front(), numbers);
        statement.number = numbers.front();
        for (std::size_t i = 0; i < parts.size(); ++i) {
          const std::size_t row = parts.size() == 9 ? i / 3 : i, column = i % 3;
          for (const char* axes : {"123", "xyz"}) {
            const auto axis = [&](std::size_t k) {
              return atom_value(std::string("e") + axes[k], TexValue::Type::vector, parts[i].span);
            };
            const TexValue vector = parts.size() == 9
                                        ? applied(*whole->whole->tensor, axis(column), parts[i].span)
                                        : *whole->whole;
            const TexValue on_row = axis(row);
            const TexValue component = called("dot", vector, &on_row, TexValue::Type::scalar, parts[i].span);
            (axes[0] == '1' ? statement.on_body : statement.on_space)
                .push_back({expression_of(component, notation_.vocabulary),
                            expression_of(parts[i], notation_.vocabulary)});
          }
        }
        result_.components.push_back(std::move(statement));
      } catch (const TexFault&) {
        continue;  // components that are not read are only shown
      }
    }
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

Result<Expression, UnreadableEquation> read_one_side(const Math& math, const EquationNotation& notation) {
  if (!math.root) return Failure<UnreadableEquation>{{{}, "there is no formula here", ""}};
  if (!math.live.empty()) return Failure<UnreadableEquation>{{{}, "a computed number stands in it", ""}};
  try {
    TexTerms terms(math, notation);
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

std::optional<Expression> read_side(const Math& math, const EquationNotation& notation) {
  auto read = read_one_side(math, notation);
  return read ? std::optional(std::move(*read)) : std::nullopt;
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
