// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_terms.h"

#include "lessons/claims/customary_names.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/notation/tex_atoms.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <set>
#include <string>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Type = TexValue::Type;

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

/// "the power of the torque": nouns, articles and "of". What says when, where or how begins with another of
/// the few words that join those.
bool is_noun_phrase(const std::string& words) {
  static const std::set<std::string, std::less<>> kJoining = {
      "about", "above",   "after",   "again",  "all",   "almost", "also",  "and",     "any",   "as",
      "at",    "because", "before",  "below",  "but",   "by",     "due",   "during",  "each",  "even",
      "every", "except",  "for",     "from",   "hence", "here",   "if",    "in",      "into",  "its",
      "just",  "like",    "near",    "nearly", "on",    "once",   "only",  "or",      "over",  "per",
      "same",  "since",   "so",      "some",   "than",  "that",   "then",  "there",   "thus",  "to",
      "too",   "under",   "unless",  "until",  "via",   "when",   "where", "whether", "which", "while",
      "with",  "within",  "without", "both",   "still", "yet",    "such",  "other"};
  std::string word;
  for (const char c : words + ' ') {
    if (c != ' ') {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (kJoining.contains(std::exchange(word, {}))) {
      return false;
    }
  }
  return true;
}

}  // namespace

const MathNode& plain_node(const MathNode& node) {
  const MathNode* inner = &node;
  while ((inner->kind == Kind::row || inner->kind == Kind::alphabet ||
          (inner->kind == Kind::term && !index_of_live(*inner))) &&
         inner->children.size() == 1)
    inner = &inner->children.front();
  return *inner;
}

bool has_tensor_component(const MathNode& node) {
  if (node.kind == Kind::scripts && !node.children[1].absent()) {
    const MathNode& nucleus = plain_node(node.children[0]);
    const bool bold = nucleus.alphabet == Alphabet::bold || nucleus.alphabet == Alphabet::bold_italic;
    if (nucleus.kind == Kind::symbol && nucleus.character == U'I' && !bold &&
        plain_node(node.children[1]).kind == Kind::row && plain_node(node.children[1]).children.size() == 2)
      return true;
  }
  return std::any_of(node.children.begin(), node.children.end(), has_tensor_component);
}

namespace {

/// Empty of what cannot be told apart into atoms: it is found in no formula that can.
std::shared_ptr<const TexItems> items_of_symbol(const Math& math) {
  try {
    return std::make_shared<const TexItems>(math.root ? items_of(*math.root, kMaxEquationNesting)
                                                      : TexItems());
  } catch (const TexFault&) {
    return std::make_shared<const TexItems>();
  }
}

}  // namespace

EquationSymbol equation_symbol(std::string name, Math math, std::string means) {
  auto items = items_of_symbol(math);
  return {std::move(name), std::move(math), std::move(means), std::move(items)};
}

TexTerms::TexTerms(const Math& math, const EquationNotation& notation) : math_(math), notation_(notation) {
  symbols_.reserve(notation.symbols.size());
  for (const EquationSymbol& symbol : notation.symbols) {
    if (!symbol.math.root) continue;
    auto kept = symbol.items ? nullptr : items_of_symbol(symbol.math);
    const Items items(symbol.items ? *symbol.items : *kept);
    if (items.empty()) continue;
    const MathNode* begin = items.front().node != nullptr ? &without_groups(*items.front().node) : nullptr;
    symbols_.push_back({&symbol, std::move(kept), items, begin});
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
    if (at > begin && has_digit(items[at - 1]) && has_digit(first))
      throw TexFault(first.span, "digits side by side look like one number",
                     "write \\cdot between them; zero of vectors is \\vec 0");
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

/// "(t)" behind what changes, which is said of every time anyway; "(t)^2" is a power of it.
void TexTerms::take_time(const TexItem& before, Items items, std::size_t& at, Factor& factor) {
  const TexItem& item = items[at];
  if (item.kind != ItemKind::group || item.open != U'(' || item.inside.empty()) return;
  const Items inside(item.inside);
  const bool begins_with_t = is_symbol(inside.front(), U't') && is_common(*inside.front().node);
  const bool is_number = std::all_of(inside.begin(), inside.end(), [](const TexItem& one) {
    return one.kind == ItemKind::sign || one.kind == ItemKind::text || is_digit(one) || is_symbol(one, U'.');
  });
  if (!begins_with_t && !is_number) return;
  std::size_t end = 0;
  if (factor.value.is_tensor() || declared(inside, end)) return;
  const Expression is = expression_of(factor.value, notation_.vocabulary);
  const bool is_function = factor.function_like || (is.order() > 0 && before.kind != ItemKind::group);
  if (!changes(is) || (!begins_with_t && !is_function)) return;
  if (inside.size() > 1 || !begins_with_t || !is_plain(inside.front()))
    throw TexFault(item.span, "is this an argument, or a factor? What is so at one time alone is not read",
                   "say what holds at every time, or put the value into the text");
  if (item.sup != nullptr && before.sup != nullptr)
    throw TexFault(item.span, "powers stand before and behind (t)", "write (t) behind the power");
  factor.span = joined_span(factor.span, item.span);
  factor.value = raised_by(std::move(factor.value), item, false, false);
  factor.value.span = factor.span;
  factor.lone = false;
  factor.function_like = true;
  ++at;
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
  Factor made = timeless_factor(items, at);
  if (!made.number && at < items.size() && !items[at].struck) take_time(items[at - 1], items, at, made);
  return made;
}

TexTerms::Factor TexTerms::timeless_factor(Items items, std::size_t& at) {
  const TexItem& item = items[at];
  spend(item.span);
  Factor made;
  made.span = item.span;
  if (item.kind == ItemKind::text)
    throw TexFault(item.span, "words in a formula are not read", "write them into the text, or keep a claim");
  if (item.kind == ItemKind::gap && at + 1 < items.size() && items[at + 1].kind == ItemKind::text)
    throw TexFault(items[at + 1].span, "words behind a wide space are not read", "write them into the text");
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
    if (!is_plain(item))
      throw TexFault(item.span, "is the fraction raised, or what stands above or below?",
                     "write brackets around what is raised");
    if (auto rate = rate_by_fraction(items, at)) {
      made.value = std::move(*rate);
      made.span = joined_span(item.span, items[at - 1].span);
      return made;
    }
    const auto only_digits = [](const MathNode& part) {
      const TexItems atoms = items_of(part, kMaxEquationNesting);
      return std::all_of(atoms.begin(), atoms.end(), [](const TexItem& a) { return is_digit(a); });
    };
    made.fraction_of_numbers = only_digits(node->children[0]) && only_digits(node->children[1]);
  }
  if (item.kind == ItemKind::operand && node->kind == Kind::term) return live_number(items, at);
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
    } else if (is_symbol(&sub, U'S')) {
      throw TexFault(item.sub->span, "the frame that a rate is seen from is not read from an index",
                     std::string(kRatesOfFrames));
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

/// A number of \live, as its expression, with its own unit behind it.
TexTerms::Factor TexTerms::live_number(Items items, std::size_t& at) {
  const TexItem& item = items[at];
  const std::size_t index = index_of_live(*item.node).value_or(math_.live.size());
  if (!may_be_live)
    throw TexFault(item.span, "a live number is not proved: it stands for a symbol, and shows digits",
                   "let it stand alone at the end of the chain, its unit within: = \\live[unit={J}]{T}");
  if (index >= math_.live.size()) throw TexFault(item.span, "this number is not read");
  if (!is_plain(item))
    throw TexFault(item.span, "is the sign or the unit of this number raised, too?",
                   "write brackets around it");
  Factor made;
  made.number = true;
  made.span = item.span;
  made.value = meaning_of({"live", {}, math_.live[index].expression}, item.span);
  const std::string unit = unit_tex(math_.live[index].unit);
  ++at;
  if (at < items.size() && items[at].kind == ItemKind::text && is_plain(items[at]) && !unit.empty() &&
      unit.ends_with("\\text{" + items[at].node->text + '}'))
    ++at;
  return made;
}

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
    if (words && states_something(label))
      throw TexFault(item.label->span, "words under a brace are not proved, and these state something",
                     "write it as a formula: \\underbrace{a}_{0}");
    if (words && !is_noun_phrase(words_of(label)))
      throw TexFault(item.label->span, "words at a brace are a name, and these say more",
                     "name what it holds, or write a formula there");
    if (words && !value.is_tensor() &&
        !can_have(dimensions_of_words(words_of(label)),
                  dimension_of(expression_of(value, notation_.vocabulary), {}).dimension))
      throw TexFault(item.label->span, "words under a brace name another quantity than it holds",
                     "say what it holds");
    if (!words) {
      const TexItems items = items_of(*item.label, kMaxEquationNesting);
      TexValue said = sum(items, item.label->span);
      if (labels != nullptr) labels->emplace_back(value, std::move(said));
    }
  }
  return value;
}

TexValue TexTerms::raised_by(TexValue base, const TexItem& item, bool took_sub, bool took_sup) {
  if (item.sub != nullptr && !took_sub) throw TexFault(item.span, "this index is not read");
  if (item.sup == nullptr || took_sup) return base;
  const TexItems sup = items_of(*item.sup, kMaxEquationNesting);
  std::string digits;
  bool negative = false;
  if (sup.size() == 1 && (is_symbol(sup[0], U'T') || is_symbol(sup[0], U'⊤')))
    throw TexFault(item.sup->span, "a transpose is not read",
                   "\\vec a\\cdot\\vec b is the product of a row and a column");
  for (std::size_t i = 0; i < sup.size(); ++i) {
    if (i > 0 && sup[i].span.begin > sup[i - 1].span.end && !digits.empty())
      throw TexFault(item.sup->span, "is this power one number?", "write its digits without spaces");
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

bool TexTerms::is_conditioned() const {
  return std::any_of(no_spin_about.begin(), no_spin_about.end(), [](bool none) { return none; });
}

bool TexTerms::is_redefined(const TexItem& item) {
  std::size_t at = 0;
  const auto said = declared(Items(&item, 1), at);
  bool took_sub = false, took_sup = false;
  return said && said->text != base_of(item, took_sub, took_sup).text;
}

}  // namespace polhode
