// SPDX-License-Identifier: MIT
// Rates, sums, functions, fractions and arrays of numbers: what takes sides of its own.
#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_terms.h"

#include <algorithm>
#include <string>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Type = TexValue::Type;

/// d or d*: whether seen from space; nothing if the superscript is another.
std::optional<bool> from_space(const TexItem& d) {
  if (d.sup == nullptr) return true;
  const MathNode& mark = plain_node(*d.sup);
  if (is_symbol(&mark, U'∗') || is_symbol(&mark, U'⋆')) return false;
  return std::nullopt;
}

/// d^2 over dt^2.
bool is_second_rate(const TexItem& d, const TexItems& below) {
  const auto is_square = [](const TexItem& item) {
    return item.sub == nullptr && item.sup != nullptr && is_symbol(&plain_node(*item.sup), U'2');
  };
  return is_square(d) && below.size() == 2 && is_letter_d(below[0]) && is_plain(below[0]) &&
         is_symbol(below[1], U't') && is_square(below[1]);
}

bool is_digit_two(const MathNode& node) { return node.kind == Kind::symbol && node.character == U'2'; }

}  // namespace

/// What holds at an instant says nothing of rates.
TexValue TexTerms::rate(const TexValue& of, bool space, SourceSpan span) {
  if (is_conditioned()) throw TexFault(span, "rates are not read under a condition on ω");
  has_rate = true;
  if (!space) has_body_rate = true;
  return rate_of(of, space, span);
}

/// d/dt of the factors that follow.
TexValue TexTerms::rate_of_run(Items items, std::size_t& at, bool space, SourceSpan place) {
  if (at == items.size() || items[at].kind == ItemKind::times)
    throw TexFault(place, "the rate of what?", "put it above, or behind");
  const bool bracket = items[at].kind == ItemKind::group && items[at].open != U'|' && items[at].open != U'⏟';
  const std::size_t begin = at;
  const TexValue of = run(items, at);
  if (bracket && at > begin + 1)
    throw TexFault(span_of(items.subspan(begin, at - begin), place), "how far does this derivative go?",
                   "put all of it into brackets");
  if (at < items.size())
    throw TexFault(items[at].span, "does this derivative end before the sign?",
                   "write brackets, or \\frac{d…}{dt}");
  return rate(of, space, joined_span(place, of.span));
}

/// \frac{d…}{dt}, or \frac{d}{dt} before what is differentiated; nothing if it is another fraction.
std::optional<TexValue> TexTerms::rate_by_fraction(Items items, std::size_t& at) {
  const TexItem& item = items[at];
  const TexItems above = items_of(item.node->children[0], kMaxEquationNesting);
  if (above.empty() || !is_letter_d(above.front()) || !is_plain(item)) return std::nullopt;
  const auto space = from_space(above.front());
  const TexItems below = items_of(item.node->children[1], kMaxEquationNesting);
  const bool by_time = below.size() == 2 && is_letter_d(below[0]) && is_plain(below[0]) &&
                       is_symbol(below[1], U't') && is_plain(below[1]);
  const bool is_second = is_second_rate(above.front(), below);
  if (by_time && !is_second && !space)
    throw TexFault(above.front().span, "only d and d^* over dt, and d^2 over dt^2, are read",
                   "write \\frac{d}{dt} before what is differentiated once more");
  if (!by_time && !is_second) return std::nullopt;
  const bool seen_from_space = is_second || *space;
  ++at;
  TexValue value;
  if (above.size() == 1) {
    value = rate_of_run(items, at, seen_from_space, item.span);
    return is_second ? rate(value, true, value.span) : value;
  }
  const Items inside = Items(above).subspan(1);
  std::size_t inner = 0;
  const TexValue of = without_struck && inside.front().struck
                          ? throw TexFault(inside.front().span, "what is left when this is struck out?")
                          : factor(inside, inner).value;
  if (inner != inside.size())
    throw TexFault(span_of(inside, item.span), "the rate of what?", "put a product behind d into brackets");
  value = rate(of, seen_from_space, item.span);
  return is_second ? rate(value, true, item.span) : value;
}

/// d a/dt in one line; nothing if it is something else.
std::optional<TexValue> TexTerms::inline_rate(Items items, std::size_t& at) {
  if (!is_letter_d(items[at]) || !from_space(items[at]) || at + 4 >= items.size()) return std::nullopt;
  const bool space = *from_space(items[at]);
  const std::size_t of_size = items[at + 2].kind == ItemKind::group ? 2 : 1;  // "(t)" behind it
  const std::size_t slash = at + 1 + of_size;
  if (slash + 2 >= items.size() || !items[slash].is(ItemKind::times, U'/') ||
      !is_letter_d(items[slash + 1]) || !is_plain(items[slash + 1]) || !is_symbol(items[slash + 2], U't') ||
      !is_plain(items[slash + 2]))
    return std::nullopt;
  if (at > 0 || slash + 3 < items.size())
    throw TexFault(items[at].span, "how far does this fraction go?", "write \\frac{d…}{dt}");
  const SourceSpan span = joined_span(items[at].span, items[slash + 2].span);
  std::size_t inner = 0;
  const TexValue of = factor(items.subspan(at + 1, of_size), inner).value;
  if (inner != of_size)
    throw TexFault(items[at].span, "how far does this fraction go?", "write \\frac{d…}{dt}");
  at = slash + 3;
  return rate(of, space, span);
}

TexValue TexTerms::big_sum(Items items, std::size_t& at) {
  const TexItem& sign = items[at];
  if (!is_symbol(sign, U'∑')) throw TexFault(sign.span, "this operator is not read");
  if (sign.sub == nullptr)
    throw TexFault(sign.span, "a sum over what?", "write \\sum_i for one over the axes");
  const TexItems below = items_of(*sign.sub, kMaxEquationNesting);
  const auto letter = [](const TexItem& item) {
    return item.kind == ItemKind::operand && item.node->kind == Kind::symbol && is_plain(item) &&
                   kIndexLetters.find(item.node->character) != std::u32string_view::npos
               ? item.node->character
               : U'\0';
  };
  char32_t index = 0;
  const bool alone = below.size() == 1 && sign.sup == nullptr;
  const bool from_one = below.size() == 3 && below[1].is(ItemKind::relation, U'=') &&
                        is_symbol(below[2], U'1') && is_plain(below[2]) && sign.sup != nullptr &&
                        is_symbol(&plain_node(*sign.sup), U'3');
  if (alone || from_one) index = letter(below[0]);
  if (index == 0)
    throw TexFault(sign.span, "only sums over the axes are read",
                   "\\sum_i or \\sum_{i=1}^{3}, with i, j, k or l");
  if (indices.contains(index) || is_redefined(below[0]))
    throw TexFault(sign.span, "this index stands for something already", "take another letter");
  const Items rest = items.subspan(at + 1);
  if (rest.empty()) throw TexFault(sign.span, "the sum of what?");
  const auto is_times = [](const TexItem& item) { return item.kind == ItemKind::times; };
  if (std::any_of(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(at), is_times) &&
      std::any_of(rest.begin(), rest.end(), is_times))
    throw TexFault(sign.span, "how far does this sum go?", "write brackets around it");
  const SourceSpan span = span_of(items.subspan(at), sign.span);
  std::optional<TexValue> total;
  used_[index] = 0;
  for (int axis = 1; axis <= 3; ++axis) {
    indices[index] = axis;
    auto term = product(rest);
    if (!term) continue;
    total = total ? added(std::move(*total), *term, false, span) : std::move(*term);
  }
  indices.erase(index);
  if (used_[index] == 0) throw TexFault(sign.span, "the index of this sum occurs nowhere behind it");
  at = items.size();
  if (!total) return atom_value("0", Type::zero, span);
  total->span = span;
  return std::move(*total);
}

TexValue TexTerms::trace(Items items, std::size_t& at) {
  const TexItem& word = items[at++];
  if (!is_plain(word) || at == items.size() || items[at].kind == ItemKind::times)
    throw TexFault(word.span, "the trace of what?");
  const Factor of = factor(items, at);
  if (at != items.size())
    throw TexFault(items[at].span, "does the trace end before this?", "put the trace last");
  return trace_of(of.value, joined_span(word.span, of.span));
}

/// \cos\theta, \cos^2\theta, \cos(a + b): of one letter, or what stands in brackets.
TexValue TexTerms::function(Items items, std::size_t& at) {
  const TexItem& word = items[at++];
  if (is_conditioned()) throw TexFault(word.span, "functions are not read under a condition on ω");
  if (word.sub != nullptr || at == items.size())
    throw TexFault(word.span, in_quotes(word.node->text) + " of what?");
  if (word.sup != nullptr && !is_digit_two(plain_node(*word.sup)))
    throw TexFault(word.span, "this power of a function is not read: some take it for its inverse",
                   "of functions only the square is read, \\cos^2\\theta; else write brackets");
  const bool is_group = items[at].kind == ItemKind::group && items[at].open == U'(' && is_plain(items[at]);
  const bool is_sized = !is_group && items[at].kind == ItemKind::operand && is_digit(items[at]);
  const Factor of = factor(items, at);
  const auto begins_function = [](const TexItem& item) {
    return item.kind == ItemKind::operand && item.node != nullptr && item.node->kind == Kind::text;
  };
  if (is_sized || (!is_group && at < items.size() && !begins_function(items[at])))
    throw TexFault(joined_span(word.span, of.span), "how far does the argument of this function go?",
                   "write brackets around it, or put the function last");
  if (of.value.is_vector() || of.value.is_tensor()) throw TexFault(of.span, "functions are taken of numbers");
  const std::string name = word.node->text == "arccos" ? "acos" : word.node->text;
  const SourceSpan span = joined_span(word.span, of.span);
  return raised_by(called(name, of.value, nullptr, Type::scalar, span), word, true, false);
}

/// The first rate, or the second; that of a component of ω is a quantity of its own.
TexValue TexTerms::rate_of_scalar(const TexValue& of, bool twice, SourceSpan span) {
  const bool is_spin = of.text.size() == 2 && of.text[0] == 'w';
  const TexValue first = is_spin ? quantity("d" + of.text, span) : rate(of, true, span);
  return twice ? rate(first, true, span) : first;
}

TexValue TexTerms::fraction(const TexItem& item) {
  const MathNode& node = *item.node;
  if (node.binomial || node.amount == 0) throw TexFault(item.span, "a fraction without a bar is not read");
  const auto part = [&](const MathNode& half) {
    const TexItems items = items_of(half, kMaxEquationNesting);
    if (items.empty()) throw TexFault(item.span, "an expression is missing in this fraction");
    if (without_struck && std::all_of(items.begin(), items.end(), [](const TexItem& i) { return i.struck; }))
      return atom_value("1", Type::scalar, item.span);
    return sum(items, item.span);
  };
  const TexValue above = part(node.children[0]);
  return divided(above, part(node.children[1]), item.span);
}

TexValue TexTerms::determinant(const TexItem& item) {
  const MathNode& node = *item.node;
  const auto columns = static_cast<std::size_t>(node.grid->columns);
  if (node.children.size() != columns * columns || columns < 2 || columns > 3)
    throw TexFault(item.span, "determinants have two or three rows and columns");
  std::vector<TexValue> cells;
  for (const MathNode& cell : node.children)
    cells.push_back(sum(items_of(cell, kMaxEquationNesting), joined_span(cell.span, item.span)));
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i].is_tensor() || (cells[i].is_vector() && (columns == 2 || i >= 3)))
      throw TexFault(item.span, "vectors stand in the first row of three alone");
  const auto minor = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return added(multiplied(cells[a], cells[d], item.span), multiplied(cells[b], cells[c], item.span), true,
                 item.span);
  };
  if (columns == 2) return minor(0, 1, 2, 3);
  TexValue total = multiplied(cells[0], minor(4, 5, 7, 8), item.span);
  total = added(std::move(total), multiplied(cells[1], minor(3, 5, 6, 8), item.span), true, item.span);
  return added(std::move(total), multiplied(cells[2], minor(3, 4, 6, 7), item.span), false, item.span);
}

TexValue TexTerms::matrix(const TexItem& item) {
  const MathNode& node = *item.node;
  if (node.grid->columns != 3 || node.children.size() != 9 || !is_plain(item))
    throw TexFault(item.span, "a tensor has three rows and three columns");
  has_matrix = true;
  TexTensor tensor;
  tensor.kind = TexTensor::Kind::matrix;
  for (const MathNode& cell : node.children) {
    tensor.entries.push_back(sum(items_of(cell, kMaxEquationNesting), joined_span(cell.span, item.span)));
    if (!tensor.entries.back().is_scalar()) throw TexFault(item.span, "components of a tensor are scalars");
  }
  return tensor_value(std::move(tensor), item.span);
}

}  // namespace polhode
