// SPDX-License-Identifier: MIT
// Predicates of the atoms of a printed equation. Internal to the reader of equations (tex_equation.h).
#pragma once

#include "lessons/notation/tex_items.h"

#include <span>
#include <string_view>

namespace polhode {

/// What a sum runs over, and a condition.
inline constexpr std::u32string_view kIndexLetters = U"ijkl";

inline SourceSpan span_of(std::span<const TexItem> items, SourceSpan otherwise) {
  return items.empty() ? otherwise : joined_span(items.front().span, items.back().span);
}

inline bool is_symbol(const MathNode* node, char32_t c) {
  return node != nullptr && node->kind == MathNode::Kind::symbol && node->character == c;
}
inline bool is_symbol(const TexItem& item, char32_t c) {
  return item.kind == TexItem::Kind::operand && is_symbol(item.node, c);
}
inline bool is_plain(const TexItem& item) { return item.sub == nullptr && item.sup == nullptr; }

inline bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
/// Letters in italics, digits upright: how quantities are set. In script, blackboard and the like they are
/// others.
inline bool is_common(const MathNode& node) {
  return node.alphabet == Alphabet::normal || node.alphabet == Alphabet::italic;
}
inline bool is_digit(const TexItem& item) {
  return item.kind == TexItem::Kind::operand && item.node != nullptr &&
         item.node->kind == MathNode::Kind::symbol && is_digit(item.node->character) &&
         (is_common(*item.node) || item.node->alphabet == Alphabet::upright);
}

/// The same in any alphabet: of a bold 0 a reader sees a digit first.
inline bool has_digit(const TexItem& item) {
  return item.kind == TexItem::Kind::operand && item.node != nullptr &&
         item.node->kind == MathNode::Kind::symbol && is_digit(item.node->character);
}

inline bool is_bold(const MathNode& node) {
  return node.alphabet == Alphabet::bold || node.alphabet == Alphabet::bold_italic;
}
inline bool is_letter_d(const TexItem& item) {
  return is_symbol(item, U'd') && item.sub == nullptr &&
         (is_common(*item.node) || item.node->alphabet == Alphabet::upright);
}

}  // namespace polhode
