// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_terms.h"

#include "lessons/claims/expression_names.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Type = TexValue::Type;

constexpr char32_t kArrow = 0x20D7, kHat = 0x0302, kDot = 0x0307, kTwoDots = 0x0308;
constexpr std::u32string_view kIndexLetters = U"ijkl";

SourceSpan span_of(std::span<const TexItem> items, SourceSpan otherwise) {
  return items.empty() ? otherwise : joined_span(items.front().span, items.back().span);
}

bool is_symbol(const MathNode* node, char32_t c) {
  return node != nullptr && node->kind == Kind::symbol && node->character == c;
}
bool is_symbol(const TexItem& item, char32_t c) {
  return item.kind == ItemKind::operand && is_symbol(item.node, c);
}
bool is_plain(const TexItem& item) { return item.sub == nullptr && item.sup == nullptr; }

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
/// Letters in italics, digits upright: how quantities are set. In script, blackboard and the like they are
/// others.
bool is_common(const MathNode& node) {
  return node.alphabet == Alphabet::normal || node.alphabet == Alphabet::italic;
}
bool is_digit(const TexItem& item) {
  return item.kind == ItemKind::operand && item.node != nullptr && item.node->kind == Kind::symbol &&
         is_digit(item.node->character) &&
         (is_common(*item.node) || item.node->alphabet == Alphabet::upright);
}

bool is_bold(const MathNode& node) {
  return node.alphabet == Alphabet::bold || node.alphabet == Alphabet::bold_italic;
}
bool is_letter_d(const TexItem& item) {
  return is_symbol(item, U'd') && item.sub == nullptr &&
         (is_common(*item.node) || item.node->alphabet == Alphabet::upright);
}

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

/// The name of a vector's letter in the language of claims.
std::string_view vector_name(char32_t letter) {
  switch (letter) {
    case U'ω':
      return "omega";
    case U'L':
      return "L";
    case U'N':
      return "N";
    case U'p':
      return "p";
    case U'v':
      return "v";
    case U'F':
      return "F";
    case U'A':
      return "A";
    default:
      return "";
  }
}

/// An underbrace below more than one term.
bool is_braced_sum(const TexItem& item) {
  return item.kind == ItemKind::group && item.open == U'⏟' &&
         std::any_of(item.inside.begin(), item.inside.end(),
                     [](const TexItem& i) { return i.kind == ItemKind::sign; });
}

/// What stands between brackets could be what a function is taken of: a number, or a symbol.
bool is_like_argument(const TexItems& inside) {
  const auto fits = [](const TexItem& item) {
    return item.kind == ItemKind::sign || is_digit(item) || is_symbol(item, U'.');
  };
  const bool signed_one = inside.size() == 2 && inside[0].kind == ItemKind::sign;
  if (inside.size() != 1 && !signed_one) return std::all_of(inside.begin(), inside.end(), fits);
  const TexItem& only = inside.back();
  return only.kind == ItemKind::operand && only.node->kind != Kind::fraction && only.node->kind != Kind::grid;
}

bool same_scripts(const MathNode* a, const MathNode* b) {
  return (a == nullptr) == (b == nullptr) && (a == nullptr || same_math(*a, *b));
}

}  // namespace

const MathNode& plain_node(const MathNode& node) {
  const MathNode* inner = &node;
  while ((inner->kind == Kind::row || inner->kind == Kind::alphabet || inner->kind == Kind::color ||
          (inner->kind == Kind::term && !index_of_live(*inner))) &&
         inner->children.size() == 1)
    inner = &inner->children.front();
  return *inner;
}

TexTerms::TexTerms(const Math& math, const EquationNotation& notation) : math_(math), notation_(notation) {
  for (const EquationSymbol& symbol : notation.symbols) {
    if (!symbol.math.root) continue;
    try {
      symbols_.push_back({&symbol, items_of(*symbol.math.root, kMaxEquationNesting)});
    } catch (const TexFault&) {
      continue;  // what cannot be told apart into atoms is found in no formula that can
    }
    if (symbols_.back().items.empty()) symbols_.pop_back();
  }
}

void TexTerms::spend(SourceSpan span) {
  if (++factors_ > kMaxEquationFactors)
    throw TexFault(span, "this formula has more than " + std::to_string(kMaxEquationFactors) + " factors");
}

TexValue TexTerms::side(Items items) { return sum(items, span_of(items, {})); }

TexValue TexTerms::sum(Items items, SourceSpan where) {
  struct Deeper {
    int& depth;
    ~Deeper() { --depth; }
  } deeper{++depth_};
  if (depth_ > 4 * kMaxEquationNesting) throw TexFault(where, "this formula is nested too deep");
  if (items.empty()) throw TexFault(where, "an expression is missing here");
  const SourceSpan whole = span_of(items, where);
  std::optional<TexValue> total;
  std::size_t at = 0;
  while (at < items.size()) {
    bool minus = false;
    const std::size_t sign = at;
    if (items[at].kind == ItemKind::sign) {
      minus = items[at].character == U'−';
      ++at;
    }
    if (at < items.size() && items[at].kind == ItemKind::sign)
      throw TexFault(items[at].span, "two signs stand side by side", "put the second into brackets");
    std::size_t end = at;
    while (end < items.size() && items[end].kind != ItemKind::sign) ++end;
    if (end == at) throw TexFault(items[sign].span, "a term is missing behind this sign");
    if (items[sign].kind == ItemKind::sign && items[sign].struck && !items[at].struck)
      throw TexFault(items[sign].span, "what is left when this sign is struck out?",
                     "strike out whole terms, or factors");
    if (minus && is_braced_sum(items[at]))
      throw TexFault(items[at].span, "does the brace hold this sum together?", "write brackets below it");
    auto term = product(items.subspan(at, end - at));
    at = end;
    if (!term) continue;
    if (total)
      total = added(std::move(*total), *term, minus, whole);
    else
      total = minus ? negated_value(*term, whole) : std::move(*term);
  }
  if (!total) return atom_value("0", Type::zero, whole);  // all of it is struck out
  total->span = whole;
  return std::move(*total);
}

std::optional<TexValue> TexTerms::product(Items items) {
  const auto struck = [](const TexItem& item) { return item.struck; };
  const bool all_struck = std::all_of(items.begin(), items.end(), struck);
  if (without_struck && all_struck) return std::nullopt;
  if (!all_struck) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const bool beside = (i > 0 && items[i - 1].kind == ItemKind::times) ||
                          (i + 1 < items.size() && items[i + 1].kind == ItemKind::times);
      if (items[i].struck && (beside || items[i].kind == ItemKind::times))
        throw TexFault(items[i].span, "what is left when this is struck out?",
                       "strike out whole terms, or factors");
    }
  }
  std::vector<TexValue> runs;
  std::vector<const TexItem*> signs;
  std::size_t at = 0;
  while (true) {
    if (at == items.size() || items[at].kind == ItemKind::times)
      throw TexFault(at == items.size() ? items[at - 1].span : items[at].span, "a factor is missing here");
    runs.push_back(run(items, at));
    if (at == items.size()) break;
    const TexItem& sign = items[at++];
    if (sign.character == U'/') {
      TexValue above = chain(std::move(runs), signs);
      if (at == items.size()) throw TexFault(sign.span, "a factor is missing here");
      const std::size_t begin = at;
      const Factor below = factor(items, at);
      if (at != items.size())
        throw TexFault(joined_span(sign.span, items.back().span), "how far does this fraction go?",
                       "write \\frac{…}{…}, or brackets");
      return divided(above, below.value, joined_span(items[0].span, items[begin].span));
    }
    signs.push_back(&sign);
  }
  return chain(std::move(runs), signs);
}

/// Factors without a sign between them.
TexValue TexTerms::run(Items items, std::size_t& at) {
  std::optional<TexValue> whole;
  bool after_number = false, after_symbol = false, has_vector = false;
  const std::size_t begin = at;
  SourceSpan span = items[at].span;
  while (at < items.size() && items[at].kind != ItemKind::times) {
    if (without_struck && items[at].struck) {
      ++at;
      continue;
    }
    const TexItem& first = items[at];
    if (items.size() > 1 && is_braced_sum(first))
      throw TexFault(first.span, "does the brace hold this sum together?", "write brackets below it");
    const Factor next = factor(items, at);
    if (whole && next.number)
      throw TexFault(next.span, "a number stands behind a factor", "put numbers first, or write \\cdot");
    if (after_number && next.fraction_of_numbers)
      throw TexFault(next.span, "is this added to the number before it, or a factor?",
                     "write \\cdot, or one fraction");
    if (after_symbol && next.lone && first.kind == ItemKind::group)
      throw TexFault(next.span, "is this an argument, or a factor?", "a factor needs no brackets here");
    after_number = next.number;
    after_symbol = next.function_like;
    if (has_vector && next.value.is_tensor())
      throw TexFault(next.span, "a vector and a tensor without a sign between them", "write \\cdot");
    if (next.value.is_vector() && has_vector)
      throw TexKindFault(next.span, "two vectors without a sign between them", "write \\cdot or \\times");
    has_vector = has_vector || next.value.is_vector();
    if (!whole)
      whole = next.value;
    else if (whole->is_tensor() && next.value.is_vector())
      whole = applied(*whole->tensor, next.value, joined_span(whole->span, next.span));
    else
      whole = multiplied(std::move(*whole), next.value, joined_span(span, next.span));
    span = joined_span(span, next.span);
    whole->span = span;
  }
  if (!whole) return atom_value("1", Type::scalar, items[begin].span);  // all factors are struck out
  return std::move(*whole);
}

/// Runs with ⋅ and × between them; see the rules of precedence in tex_equation.h.
TexValue TexTerms::chain(std::vector<TexValue> runs, const std::vector<const TexItem*>& signs) {
  const SourceSpan whole = joined_span(runs.front().span, runs.back().span);
  // Scalars in front.
  std::size_t first = 0;
  std::optional<TexValue> factor;
  while (first < runs.size() && runs[first].is_scalar()) {
    factor = factor ? multiplied(std::move(*factor), runs[first], whole) : runs[first];
    if (first < signs.size() && signs[first]->character == U'×')
      throw TexFault(signs[first]->span, "× stands between vectors",
                     "write \\cdot, or nothing, between numbers");
    ++first;
  }
  if (first == runs.size()) return std::move(*factor);
  const auto is_dot = [&](std::size_t i) { return signs[i]->character == U'⋅'; };
  // Tensors, from the right: each is applied to what follows it.
  std::vector<TexValue> parts;
  std::vector<bool> dots;  // dots[i] stands between parts[i] and parts[i + 1]
  for (std::size_t i = first; i < runs.size();) {
    if (runs[i].is_scalar())
      throw TexFault(runs[i].span, "a number stands behind vectors", "put scalar factors first");
    if (!runs[i].is_tensor()) {
      parts.push_back(runs[i]);
      if (i < signs.size()) dots.push_back(is_dot(i));
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end + 1 < runs.size() && runs[end].is_tensor() && is_dot(end)) ++end;
    if (runs[end].is_scalar())
      throw TexFault(runs[end].span, "a number stands behind a tensor", "put scalar factors first");
    TexValue value = runs[end];
    for (std::size_t k = end; k-- > i;)
      value = value.is_vector() ? applied(*runs[k].tensor, value, joined_span(runs[k].span, value.span))
                                : multiplied(runs[k], value, joined_span(runs[k].span, value.span));
    if (value.is_tensor() && (i > first || end + 1 < runs.size()))
      throw TexFault(value.span, "what is this tensor applied to?",
                     "write brackets around \\mathbf I\\cdot\\vec a");
    if (end > i && end < signs.size() && !is_dot(end))
      throw TexFault(signs[end]->span, "is the tensor applied before or behind this product?",
                     "write brackets around \\mathbf I\\cdot\\vec a");
    parts.push_back(std::move(value));
    if (end < signs.size()) dots.push_back(is_dot(end));
    i = end + 1;
  }
  TexValue result;
  if (parts.size() == 1) {
    result = parts[0];
  } else if (parts.size() == 2) {
    result =
        called(dots[0] ? "dot" : "cross", parts[0], &parts[1], dots[0] ? Type::scalar : Type::vector, whole);
  } else if (parts.size() == 3 && dots[0] != dots[1]) {
    const std::size_t c = dots[0] ? 1 : 0;
    const TexValue cross = called("cross", parts[c], &parts[c + 1], Type::vector, whole);
    result = dots[0] ? called("dot", parts[0], &cross, Type::scalar, whole)
                     : called("dot", cross, &parts[2], Type::scalar, whole);
  } else {
    throw TexFault(whole, "this product of several vectors has more than one reading", "write brackets");
  }
  if (factor) result = multiplied(std::move(*factor), result, whole);
  result.span = whole;
  return result;
}

TexTerms::Factor TexTerms::factor(Items items, std::size_t& at) {
  const TexItem& item = items[at];
  spend(item.span);
  Factor made;
  made.span = item.span;
  if (item.kind == ItemKind::text)
    throw TexFault(item.span, "words in a formula are not read", "write them into the text, or keep a claim");
  if (item.kind == ItemKind::gap)
    throw TexFault(item.span, "a wide space stands inside of a formula", "separate equations by a comma");
  if (item.kind != ItemKind::operand && item.kind != ItemKind::group)
    throw TexFault(item.span, "this sign is not read here");
  if (auto value = declared(items, at)) {
    made.value = std::move(*value);
    made.function_like = made.lone = true;
    made.span = joined_span(item.span, items[at - 1].span);
    return made;
  }
  if (is_digit(item)) return number(items, at);
  if (is_symbol(item, U'.')) throw TexFault(item.span, "a number begins with a digit", "write 0.5");
  if (auto rate = inline_rate(items, at)) {
    made.value = std::move(*rate);
    made.span = joined_span(item.span, items[at - 1].span);
    return made;
  }
  const MathNode* node = item.node;
  if (item.kind == ItemKind::operand && node->kind == Kind::symbol && node->atom == MathClass::large) {
    made.value = big_sum(items, at);
    made.span = joined_span(item.span, items[at - 1].span);
    return made;
  }
  if (item.kind == ItemKind::operand && node->kind == Kind::text) {
    if (node->text == "sin" || node->text == "cos" || node->text == "arccos") {
      made.value = function(items, at);
      made.span = joined_span(item.span, items[at - 1].span);
      return made;
    }
    if (node->text != "tr")
      throw TexFault(item.span, "the language of claims has no function " + node->text,
                     "give the whole a symbol with `means`");
    made.value = trace(items, at);
    made.span = joined_span(item.span, items[at - 1].span);
    return made;
  }
  if (item.kind == ItemKind::operand && node->kind == Kind::fraction) {
    const TexItems above = items_of(node->children[0], kMaxEquationNesting);
    if (!above.empty() && is_letter_d(above.front()) && is_plain(item)) {
      const auto space = from_space(above.front());
      const TexItems below = items_of(node->children[1], kMaxEquationNesting);
      const bool by_time = below.size() == 2 && is_letter_d(below[0]) && is_plain(below[0]) &&
                           is_symbol(below[1], U't') && is_plain(below[1]);
      const bool is_second = is_second_rate(above.front(), below);
      if (is_second || (by_time && space)) {
        const bool seen_from_space = is_second || *space;
        if (above.size() == 1) {
          ++at;
          made.value = rate_of_run(items, at, seen_from_space, item.span);
          if (is_second) made.value = rate(made.value, true, made.value.span);
          made.span = joined_span(item.span, items[at - 1].span);
          return made;
        }
        ++at;
        const Items inside = Items(above).subspan(1);
        std::size_t inner = 0;
        const TexValue of = without_struck && inside.front().struck
                                ? throw TexFault(inside.front().span, "what is left when this is struck out?")
                                : factor(inside, inner).value;
        if (inner != inside.size())
          throw TexFault(span_of(inside, item.span), "the rate of what?",
                         "put a product behind d into brackets");
        made.value = rate(of, seen_from_space, item.span);
        if (is_second) made.value = rate(made.value, true, item.span);
        return made;
      }
      if (by_time)
        throw TexFault(above.front().span, "only d and d^* over dt, and d^2 over dt^2, are read",
                       "write \\frac{d}{dt} before what is differentiated once more");
    }
    const auto only_digits = [](const MathNode& part) {
      const TexItems atoms = items_of(part, kMaxEquationNesting);
      return std::all_of(atoms.begin(), atoms.end(), [](const TexItem& a) { return is_digit(a); });
    };
    made.fraction_of_numbers = only_digits(node->children[0]) && only_digits(node->children[1]);
  }
  bool took_sub = false, took_sup = false;
  TexValue base = item.kind == ItemKind::group ? group(item) : base_of(item, took_sub, took_sup);
  if (item.kind == ItemKind::group && item.sub != nullptr) {
    const MathNode& sub = plain_node(*item.sub);
    TexTensor tensor;
    if (is_symbol(&sub, U'×')) {
      if (item.open != U'[' || !base.is_vector())
        throw TexFault(item.span, "[…]_\\times is the tensor of a cross product, of a vector");
      tensor.kind = TexTensor::Kind::cross;
      tensor.value = base;
      base = tensor_value(std::move(tensor), item.span);
    } else {
      base = component_of(base, axis_in(item), item.span);
    }
    took_sub = true;
  }
  made.lone = item.kind == ItemKind::group && item.open != U'|' && item.open != U'⏟' && item.sub == nullptr &&
              is_like_argument(item.inside);
  made.function_like =
      item.kind == ItemKind::operand && node->kind != Kind::fraction && node->kind != Kind::grid;
  ++at;
  made.value = raised_by(std::move(base), item, took_sub, took_sup);
  made.value.span = item.span;
  return made;
}

bool TexTerms::is_conditioned() const {
  return std::any_of(no_spin_about.begin(), no_spin_about.end(), [](bool none) { return none; });
}

bool TexTerms::is_redefined(const TexItem& item) {
  std::size_t at = 0;
  const auto said = declared(Items(&item, 1), at);
  bool took_sub = false, took_sup = false;
  return said && said->text != base_of(item, took_sub, took_sup).text;
}

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

/// d a/dt in one line; nothing if it is something else.
std::optional<TexValue> TexTerms::inline_rate(Items items, std::size_t& at) {
  if (!is_letter_d(items[at]) || !from_space(items[at]) || at + 4 >= items.size()) return std::nullopt;
  const bool space = *from_space(items[at]);
  if (items[at + 2].kind != ItemKind::times || items[at + 2].character != U'/' ||
      !is_letter_d(items[at + 3]) || !is_plain(items[at + 3]) || !is_symbol(items[at + 4], U't') ||
      !is_plain(items[at + 4]))
    return std::nullopt;
  if (at > 0 || at + 5 < items.size())
    throw TexFault(items[at].span, "how far does this fraction go?", "write \\frac{d…}{dt}");
  const SourceSpan span = joined_span(items[at].span, items[at + 4].span);
  std::size_t inner = 0;
  const TexValue of = factor(items.subspan(at + 1, 1), inner).value;
  at += 5;
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
namespace {
bool is_digit_two(const MathNode& node) { return node.kind == Kind::symbol && node.character == U'2'; }
}  // namespace

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
  if (is_sized ||
      (!is_group && at < items.size() && items[at].kind != ItemKind::times && !begins_function(items[at])))
    throw TexFault(joined_span(word.span, of.span), "how far does the argument of this function go?",
                   "write brackets around it, or put the function last");
  if (of.value.is_vector() || of.value.is_tensor()) throw TexFault(of.span, "functions are taken of numbers");
  const std::string name = word.node->text == "arccos" ? "acos" : word.node->text;
  const SourceSpan span = joined_span(word.span, of.span);
  return raised_by(called(name, of.value, nullptr, Type::scalar, span), word, true, false);
}

TexTerms::Factor TexTerms::number(Items items, std::size_t& at) {
  Factor made;
  const std::size_t begin = at;
  std::string digits;
  bool point = false;
  while (at < items.size()) {
    const TexItem& item = items[at];
    if (is_symbol(item, U'.') && is_plain(item) && !point && at + 1 < items.size() &&
        is_digit(items[at + 1])) {
      point = true;
      digits += '.';
    } else if (is_digit(item)) {
      digits += static_cast<char>(item.node->character);
    } else {
      break;
    }
    ++at;
    if (!is_plain(item)) break;
  }
  // Space between digits: groups of thousands, or two numbers?
  for (std::size_t i = begin + 1; i < at; ++i)
    if (items[i].span.begin > items[i - 1].span.end)
      throw TexFault(items[i].span, "is this another number?", "write the digits without spaces, or \\cdot");
  made.span = joined_span(items[begin].span, items[at - 1].span);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  made.number = true;
  made.value =
      raised_by(atom_value(digits, zero ? Type::zero : Type::scalar, made.span), items[at - 1], false, false);
  made.value.span = made.span;
  return made;
}

/// The longest symbol of the lesson that begins here.
std::optional<TexValue> TexTerms::declared(Items items, std::size_t& at) {
  const Symbol* best = nullptr;
  for (const Symbol& symbol : symbols_) {
    const std::size_t count = symbol.items.size();
    if (count > items.size() - at || (best != nullptr && count < best->items.size())) continue;
    bool same = true;
    for (std::size_t i = 0; same && i < count; ++i) {
      const TexItem &sought = symbol.items[i], &found = items[at + i];
      const bool last = i + 1 == count;
      same = sought.kind == found.kind && sought.kind != ItemKind::group && sought.node != nullptr &&
             found.node != nullptr && same_math(*sought.node, *found.node) &&
             same_scripts(sought.sub, found.sub) &&
             (same_scripts(sought.sup, found.sup) || (last && sought.sup == nullptr && count == 1));
    }
    const bool with_power =
        best != nullptr && count == best->items.size() && best->items.back().sup != nullptr;
    if (same && !with_power) best = &symbol;
  }
  if (best == nullptr) return std::nullopt;
  const TexItem& last = items[at + best->items.size() - 1];
  const SourceSpan span = joined_span(items[at].span, last.span);
  at += best->items.size();
  TexValue value = meaning_of(*best->declared, span);
  bool took_sup = best->items.back().sup != nullptr;
  if (value.is_tensor() && value.tensor->kind == TexTensor::Kind::inertia) {
    bool took_sub = true;
    value = inertia(last, took_sub, took_sup);
  }
  value = raised_by(std::move(value), last, true, took_sup);
  value.span = span;
  return value;
}

TexValue TexTerms::meaning_of(const EquationSymbol& symbol, SourceSpan span) const {
  const std::string& text = symbol.means.empty() ? symbol.name : symbol.means;
  if (text == "I" || text == "J") {
    TexTensor tensor;
    tensor.kind = text == "J" ? TexTensor::Kind::any_inertia : TexTensor::Kind::inertia;
    return tensor_value(std::move(tensor), span);
  }
  if (symbol.means.empty() && find_quantity(text) == nullptr && notation_.vocabulary.find(text) == nullptr)
    throw TexFault(span, "the symbol " + in_quotes(symbol.name) + " has no meaning in the language of claims",
                   "say what it is with `means`");
  const SourceText source(text);
  Report report(source, "");
  const auto expression = read_expression(text, {1, 1}, report, &notation_.vocabulary);
  if (!expression)
    throw TexFault(
        span, "what " + in_quotes(symbol.name) + " means cannot be read: " + report.take().front().message);
  if (expression->nodes.size() == 1 && find_quantity(text) != nullptr) return quantity(text, span);
  if (is_conditioned()) throw TexFault(span, "this symbol is not read under a condition on ω");
  const ExpressionType type = expression->type();
  TexValue value = atom_value(text,
                              type == ExpressionType::vector ? Type::vector
                              : type == ExpressionType::zero ? Type::zero
                                                             : Type::scalar,
                              span);
  if (expression->nodes.size() > 1 && notation_.vocabulary.find(text) == nullptr) {
    value.text = "(" + text + ")";
    if (value.text.size() > kMaxExpressionBytes) throw TexFault(span, "this is too long, written out");
  }
  return value;
}

namespace {

/// Digits, or a relation, in the words of a label.
bool says_value(const MathNode& label) {
  const auto says = [](const MathNode& node) {
    return node.text.find_first_of("0123456789=<>") != std::string::npos ||
           node.text.find("≠") != std::string::npos;
  };
  return says(label) || std::any_of(label.children.begin(), label.children.end(), says);
}

}  // namespace

TexValue TexTerms::group(const TexItem& item) {
  if (item.open == U'|') return length_of(sum(item.inside, item.span), item.span);
  TexValue value = sum(item.inside, item.span);
  if (item.open == U'⏟' && item.label != nullptr) {
    if (item.node->character != U'⏟' && item.node->character != U'⏞')
      throw TexFault(item.span, "this brace is not read");
    const MathNode& label = plain_node(*item.label);
    const bool words = label.kind == Kind::text ||
                       (label.kind == Kind::row && !label.children.empty() &&
                        std::all_of(label.children.begin(), label.children.end(), [](const MathNode& part) {
                          return part.kind == Kind::text || part.kind == Kind::space;
                        }));
    if (words && says_value(label))
      throw TexFault(item.label->span, "words under a brace are not proved, and these say a value",
                     "write it as a formula: \\underbrace{a}_{0}");
    if (!words) {
      const TexItems items = items_of(*item.label, kMaxEquationNesting);
      TexValue said = sum(items, item.label->span);
      if (labels != nullptr) labels->emplace_back(value, std::move(said));
    }
  }
  return value;
}

/// What stands below the scripts; those that belong to a name are taken.
TexValue TexTerms::base_of(const TexItem& item, bool& took_sub, bool& took_sup) {
  const MathNode& node = *item.node;
  switch (node.kind) {
    case Kind::symbol:
      if (node.character == U'I' && is_bold(node)) return inertia(item, took_sub, took_sup);
      if (node.character == U'1' && is_bold(node)) {
        TexTensor one;
        return tensor_value(std::move(one), item.span);
      }
      if (is_bold(node)) return arrow_or_bold(item, node.character, took_sub, took_sup);
      return letter(item, took_sub);
    case Kind::accent: {
      const MathNode& base = plain_node(node.children.front());
      if (base.kind == Kind::symbol && !is_common(base) && !is_bold(base))
        throw TexFault(item.span, "a letter in this alphabet is not read", "give it a symbol with `means`");
      if (node.character == kArrow && base.kind == Kind::symbol)
        return arrow_or_bold(item, base.character, took_sub, took_sup);
      if (node.character == kHat) return hat(item, base, took_sub);
      if (node.character == kDot || node.character == kTwoDots)
        return dotted(item, base, node.character == kTwoDots, took_sub);
      throw TexFault(item.span, "this mark above a letter is not read",
                     "dots: one or two on scalars, one on \\vec\\omega");
    }
    case Kind::fraction:
      return fraction(item);
    case Kind::grid:
      if (node.grid->left == U'|' && node.grid->right == U'|') return determinant(item);
      if (node.grid->left == U'(' || node.grid->left == U'[') return matrix(item);
      throw TexFault(item.span, "this array is not read");
    case Kind::term: {  // \live
      const std::size_t index = index_of_live(node).value_or(math_.live.size());
      if (!may_be_live)
        throw TexFault(item.span, "a live number is not proved: it stands for a symbol, and shows digits",
                       "let it stand alone at the end of the chain, its unit within: = \\live[unit={J}]{T}");
      if (index >= math_.live.size()) throw TexFault(item.span, "this number is not read");
      return meaning_of({"live", {}, math_.live[index].expression}, item.span);
    }
    case Kind::radical: {
      if (node.children.size() > 1 && !node.children[1].absent())
        throw TexFault(item.span, "only square roots are read", "write powers, or square both sides");
      if (is_conditioned()) throw TexFault(item.span, "roots are not read under a condition on ω");
      const TexItems inside = items_of(node.children[0], kMaxEquationNesting);
      const TexValue of = sum(inside, item.span);
      if (!of.is_scalar()) throw TexFault(item.span, "roots are taken of numbers", "a length is |\\vec a|");
      return called("sqrt", of, nullptr, Type::scalar, item.span);
    }
    default:
      throw TexFault(item.span, "this is not read");
  }
}

TexValue TexTerms::letter(const TexItem& item, bool& took_sub) {
  const char32_t c = item.node->character;
  if (!is_common(*item.node))
    throw TexFault(item.span, "a letter in this alphabet is not read", "give it a symbol with `means`");
  if (item.sub == nullptr) {
    if (c == U'T') return quantity("T", item.span);
    if (c == U'm') return quantity("m", item.span);
    const std::string hint = !vector_name(c).empty() ? "a vector has an arrow; its length is |\\vec a|"
                                                     : "give it a symbol with `means`";
    throw TexFault(item.span, "the language of claims does not know this symbol", hint);
  }
  const std::string_view vector = vector_name(c);
  if (c != U'I' && vector.empty())
    throw TexFault(item.span, "the language of claims does not know this symbol",
                   "give it a symbol with `means`");
  const std::vector<int> axes = axes_of(*item.sub);
  took_sub = true;
  if (c == U'I' && axes.size() == 2) {
    constexpr std::array<char, 4> kNames{' ', 'x', 'y', 'z'};
    const auto [low, high] = std::minmax(axes[0], axes[1]);
    return quantity(
        std::string("J") + kNames[static_cast<std::size_t>(low)] + kNames[static_cast<std::size_t>(high)],
        item.span);
  }
  if (axes.size() != 1)
    throw TexFault(item.span, "this index is not read",
                   notation_.xyz_are_body_axes
                       ? "1, 2, 3, x, y, z, or an index of a sum"
                       : "1, 2, 3, or an index of a sum; x, y, z if they are the body's axes");
  if (c == U'I') {
    if (any_inertia)
      throw TexFault(item.span, "principal moments do not stand beside components of any tensor",
                     "write I_{xx}");
    return quantity("I" + std::to_string(axes[0]), item.span);
  }
  if (c == U'ω') return quantity("w" + std::to_string(axes[0]), item.span);
  if (c == U'N') return quantity("N" + std::to_string(axes[0]), item.span);
  return component_of(quantity(vector, item.span), axes[0], item.span);
}

TexValue TexTerms::arrow_or_bold(const TexItem& item, char32_t letter, bool& took_sub, bool& took_sup) {
  const std::string_view name = vector_name(letter);
  if (letter == U'0' && is_plain(item)) return atom_value("0", Type::zero, item.span);
  if (name.empty()) {
    if (letter == U'e' && item.node->kind == Kind::symbol) {
      const int axis = axis_in(item);
      took_sub = true;
      return unit_vector(axis, item.span);
    }
    throw TexFault(item.span, "the language of claims does not know this vector",
                   "give it a symbol with `means`");
  }
  if (item.sub != nullptr)
    throw TexFault(item.span, "a vector with an index is not read", "a component has no arrow: L_1");
  static_cast<void>(took_sub);
  static_cast<void>(took_sup);
  return quantity(name, item.span);
}

TexValue TexTerms::inertia(const TexItem& item, bool& took_sub, bool& took_sup) {
  TexTensor tensor;
  tensor.kind = any_inertia ? TexTensor::Kind::any_inertia : TexTensor::Kind::inertia;
  if (item.sub != nullptr && !took_sub) {
    if (!is_symbol(&plain_node(*item.sub), U'S'))
      throw TexFault(item.span, "this index of a tensor is not read");
    took_sub = has_space_inertia = true;
  } else {
    has_inertia = true;
  }
  if (item.sup != nullptr && !took_sup) {
    const TexItems sup = items_of(*item.sup, kMaxEquationNesting);
    const bool inverse =
        sup.size() == 2 && sup[0].is(ItemKind::sign, U'−') && is_symbol(sup[1], U'1') && is_plain(sup[1]);
    if (!inverse || any_inertia)
      throw TexFault(item.span, "this power of a tensor is not read",
                     "\\mathbf I^{-1} is, on principal axes");
    tensor.kind = TexTensor::Kind::inverse_inertia;
    took_sup = true;
  }
  return tensor_value(std::move(tensor), item.span);
}

TexValue TexTerms::hat(const TexItem& item, const MathNode& base, bool& took_sub) {
  if (base.kind != Kind::symbol) throw TexFault(item.span, "this unit vector is not read");
  if (base.character == U'e' && item.sub != nullptr) {
    took_sub = true;
    return unit_vector(axis_in(item), item.span);
  }
  const std::u32string_view letters = U"ijk";
  const char32_t c = base.character == U'ı' ? U'i' : base.character == U'ȷ' ? U'j' : base.character;
  const std::size_t at = letters.find(c);
  if (item.sub == nullptr && notation_.xyz_are_body_axes && at != letters.npos)
    return unit_vector(static_cast<int>(at) + 1, item.span);
  throw TexFault(item.span, "this unit vector is not read",
                 "\\hat e_1; \\hat i, \\hat j, \\hat k if they are the body's axes");
}

TexValue TexTerms::dotted(const TexItem& item, const MathNode& base, bool twice, bool& took_sub) {
  if (is_conditioned()) throw TexFault(item.span, "rates are not read under a condition on ω");
  TexItem below = item;  // what stands below the dot, with the scripts behind it
  below.node = &base;
  below.sup = nullptr;
  bool took_sup = false;
  if (base.kind == Kind::scripts) {
    if (item.sub != nullptr || !base.children[2].absent())
      throw TexFault(item.span, "this rate is not read", "write \\frac{d…}{dt}");
    below.node = &plain_node(base.children[0]);
    below.sub = &base.children[1];
    bool inner_sub = false;
    const TexValue of = base_of(below, inner_sub, took_sup);
    if (!of.is_scalar() || !inner_sub)
      throw TexFault(item.span, "in which frame is this rate?", "write \\frac{d…}{dt} or \\frac{d^*…}{dt}");
    below.span = item.span;
    return rate_of_scalar(of, twice, item.span);
  }
  if (base.kind == Kind::accent && (base.character == kDot || base.character == kTwoDots))
    throw TexFault(item.span, "dots above dots are not read", "write \\ddot");
  // A symbol of the lesson under a dot.
  const TexItems row{below};
  std::size_t at = 0;
  std::optional<TexValue> of = declared(row, at);
  if (of) {
    took_sub = true;
  } else {
    of = base_of(below, took_sub, took_sup);
  }
  if (of->is_vector()) {
    if (of->text != "omega" || twice)
      throw TexFault(item.span, "in which frame is this rate?", "write \\frac{d…}{dt} or \\frac{d^*…}{dt}");
    return rate(*of, false, item.span);
  }
  if (!of->is_scalar())
    throw TexFault(item.span, "in which frame is this rate?", "write \\frac{d…}{dt} or \\frac{d^*…}{dt}");
  return rate_of_scalar(*of, twice, item.span);
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

/// A quantity of the language, under the conditions.
TexValue TexTerms::quantity(std::string_view name, SourceSpan span) const {
  const QuantityFacts* facts = find_quantity(name);
  if (facts == nullptr) throw TexFault(span, "the language of claims does not know this symbol");
  const Type type = facts->type == ExpressionType::vector ? Type::vector : Type::scalar;
  if (!is_conditioned()) return atom_value(std::string(name), type, span);
  if (name == "omega") {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string n = std::to_string(i + 1);
      if (!no_spin_about[i]) text += (text.empty() ? "" : " + ") + ("w" + n) + "*e" + n;
    }
    TexValue value = atom_value(text.empty() ? "0*e1" : text, Type::vector, span);
    value.level = TexValue::Level::sum;
    return value;
  }
  if (name.size() == 2 && name[0] == 'w') {
    const bool none = no_spin_about[static_cast<std::size_t>(name[1] - '1')];
    return atom_value(none ? "0" : std::string(name), none ? Type::zero : type, span);
  }
  if (name[0] == 'I' || name[0] == 'J' || name[0] == 'A' || name[0] == 'e')
    return atom_value(std::string(name), type, span);
  throw TexFault(span, "under a condition on ω only ω, moments and axes are read");
}

TexValue TexTerms::raised_by(TexValue base, const TexItem& item, bool took_sub, bool took_sup) {
  if (item.sub != nullptr && !took_sub) throw TexFault(item.span, "this index is not read");
  if (item.sup == nullptr || took_sup) return base;
  const TexItems sup = items_of(*item.sup, kMaxEquationNesting);
  std::string digits;
  bool negative = false;
  for (std::size_t i = 0; i < sup.size(); ++i) {
    if (i == 0 && sup[i].is(ItemKind::sign, U'−')) {
      negative = true;
    } else if (is_digit(sup[i]) && is_plain(sup[i])) {
      digits += static_cast<char>(sup[i].node->character);
    } else {
      throw TexFault(item.sup->span, "powers are whole numbers",
                     is_symbol(sup[i], U'′') ? "a primed symbol needs a `means`" : "");
    }
  }
  int exponent = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (digits.empty() || read.ec != std::errc() || exponent > kMaxExponent)
    throw TexFault(item.sup->span, "an exponent is a whole number, at most " + std::to_string(kMaxExponent));
  if (exponent == 0) throw TexFault(item.sup->span, "the power 0 of what may be 0 is not read", "write 1");
  return raised(base, negative ? -exponent : exponent, item.span);
}

std::optional<int> TexTerms::axis_of(const MathNode& character) const {
  if (character.kind != Kind::symbol) return std::nullopt;
  const char32_t c = character.character;
  if (c >= U'1' && c <= U'3') return static_cast<int>(c - U'0');
  if (notation_.xyz_are_body_axes && c >= U'x' && c <= U'z') return static_cast<int>(c - U'x') + 1;
  const auto found = indices.find(c);
  if (found == indices.end()) {
    if (kIndexLetters.find(c) != std::u32string_view::npos)
      throw TexFault(character.span, "this index is free: no sum and no condition says what it stands for",
                     "write \\sum_i, or \\qquad (i = 1, 2, 3) behind the equation");
    return std::nullopt;
  }
  ++used_[c];
  return found->second;
}

/// The axes that an index names, one for each of its characters; none if it is no such index.
std::vector<int> TexTerms::axes_of(const MathNode& sub) const {
  std::vector<int> axes;
  for (const TexItem& item : items_of(sub, kMaxEquationNesting)) {
    const auto axis = item.kind == ItemKind::operand && is_plain(item) ? axis_of(*item.node) : std::nullopt;
    if (!axis) return {};
    axes.push_back(*axis);
  }
  return axes;
}

int TexTerms::axis_in(const TexItem& item) const {
  const std::vector<int> axes = item.sub == nullptr ? std::vector<int>{} : axes_of(*item.sub);
  if (axes.size() != 1) throw TexFault(item.span, "this index is not read", "1, 2, 3, or an index of a sum");
  return axes[0];
}

}  // namespace polhode
