// SPDX-License-Identifier: MIT
// What letters mean: quantities of the language of claims, and symbols of the lesson.
#include "lessons/claims/expressions/expression_names.h"
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

constexpr char32_t kArrow = 0x20D7, kHat = 0x0302, kDot = 0x0307, kTwoDots = 0x0308;

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

/// The letter of a vector's symbol, which has an arrow or is bold; 0 of other symbols.
char32_t letter_of_vector(const MathNode& node) {
  if (node.kind == Kind::symbol && is_bold(node)) return node.character;
  if (node.kind != Kind::accent || node.character != kArrow) return 0;
  const MathNode& base = plain_node(node.children.front());
  return base.kind == Kind::symbol ? base.character : 0;
}

bool same_scripts(const MathNode* a, const MathNode* b) {
  return (a == nullptr) == (b == nullptr) && (a == nullptr || same_math(*a, *b));
}

}  // namespace

/// The longest symbol of the lesson that begins here.
std::optional<TexValue> TexTerms::declared(Items items, std::size_t& at) {
  const Symbol* best = nullptr;
  if (at == items.size() || items[at].node == nullptr) return std::nullopt;
  const MathNode& begin = without_groups(*items[at].node);
  for (const Symbol& symbol : symbols_) {
    // Nearly all begin otherwise.
    if (symbol.begin == nullptr || symbol.begin->kind != begin.kind ||
        symbol.begin->character != begin.character)
      continue;
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
      throw TexFault(item.span, "this array is not read",
                     "a determinant is \\begin{vmatrix}, a tensor \\begin{pmatrix}");
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

/// Of a letter whose vector the lesson declares: Ω where it has \vec\Omega. x, y and z are coordinates.
std::optional<TexValue> TexTerms::length_without_arrow(const TexItem& item) const {
  const char32_t c = item.node->character;
  if (!has_pi || (item.sub == nullptr && c >= U'x' && c <= U'z')) return std::nullopt;
  for (const Symbol& symbol : symbols_) {
    const TexItem& only = symbol.items.front();
    const bool is_its_letter = symbol.items.size() == 1 && only.kind == ItemKind::operand &&
                               letter_of_vector(*only.node) == c && only.sup == nullptr &&
                               same_scripts(only.sub, item.sub);
    if (!is_its_letter) continue;
    const TexValue vector = meaning_of(*symbol.declared, item.span);
    if (vector.is_vector()) return length_of(vector, item.span);
  }
  return std::nullopt;
}

bool TexTerms::is_letter_of_declared_vector(char32_t c) const {
  return std::any_of(symbols_.begin(), symbols_.end(), [&](const Symbol& symbol) {
    const TexItem& only = symbol.items.front();
    return symbol.items.size() == 1 && only.kind == ItemKind::operand && letter_of_vector(*only.node) == c;
  });
}

TexValue TexTerms::letter(const TexItem& item, bool& took_sub) {
  const char32_t c = item.node->character;
  if (!is_common(*item.node))
    throw TexFault(item.span, "a letter in this alphabet is not read", "give it a symbol with `means`");
  if (item.sub == nullptr) {
    if (c == U'T') return quantity("T", item.span);
    if (c == U'm') return quantity("m", item.span);
    if (c == U'π' && has_pi) return atom_value(std::string(kPiName), Type::scalar, item.span);
    if (has_pi && (c == U'ω' || c == U'L')) return length_of(quantity(vector_name(c), item.span), item.span);
    if (const auto length = length_without_arrow(item)) return *length;
    const std::string hint = !vector_name(c).empty() || is_letter_of_declared_vector(c)
                                 ? "a vector has an arrow; its length is |\\vec a|"
                                 : "give it a symbol with `means`";
    throw TexFault(item.span, "the language of claims does not know this symbol", hint);
  }
  const std::string_view vector = vector_name(c);
  if (vector.empty())
    if (const auto length = length_without_arrow(item)) {
      took_sub = true;
      return *length;
    }
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
  if (axes.size() != 1) {
    if (const auto length = length_without_arrow(item)) return *length;
    throw TexFault(item.span, "this index is not read",
                   notation_.xyz_are_body_axes
                       ? "1, 2, 3, x, y, z, or an index of a sum"
                       : "1, 2, 3, or an index of a sum; x, y, z if they are the body's axes");
  }
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
    const MathNode& axis = plain_node(*item.sub);
    const bool is_of_space = !notation_.xyz_are_body_axes && axis.kind == Kind::symbol &&
                             axis.character >= U'x' && axis.character <= U'z' && is_common(axis);
    if (is_of_space && is_conditioned())
      throw TexFault(item.span, "under a condition on ω only ω, moments and axes of the body are read");
    if (is_of_space) return quantity(std::string("e") + static_cast<char>(axis.character), item.span);
    return unit_vector(axis_in(item), item.span);
  }
  const std::u32string_view letters = U"ijk";
  const char32_t c = base.character == U'ı' ? U'i' : base.character == U'ȷ' ? U'j' : base.character;
  const std::size_t at = letters.find(c);
  if (item.sub == nullptr && notation_.xyz_are_body_axes && at != letters.npos)
    return unit_vector(static_cast<int>(at) + 1, item.span);
  if (base.character == U'e' && item.sub == nullptr)
    throw TexFault(item.span, "this unit vector is not read",
                   "which one? \\hat e_1, or a symbol with `means`");
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
    if (twice) throw TexFault(item.span, "in which frame is this rate?", "write \\frac{d^2…}{dt^2}");
    // A dot is d/dt, as seen from space; of ω both are one, and the other is of fewer parts.
    return rate(*of, of->text != "omega", item.span);
  }
  if (!of->is_scalar())
    throw TexFault(item.span, "in which frame is this rate?", "write \\frac{d…}{dt} or \\frac{d^*…}{dt}");
  return rate_of_scalar(*of, twice, item.span);
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
