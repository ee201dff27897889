// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_number_parts.h"

#include "base/words/formula_words.h"
#include "lessons/notation/tex_atoms.h"
#include "lessons/notation/tex_equation.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Items = std::span<const TexItem>;

std::size_t numbers_below(const MathNode& node) {
  if (index_of_live(node)) return 1;
  std::size_t count = 0;
  for (const MathNode& child : node.children) count += numbers_below(child);
  return count;
}

}  // namespace

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

bool is_break(const TexItem& item) {
  return item.kind == ItemKind::comma || item.kind == ItemKind::gap || item.kind == ItemKind::line;
}

bool is_dots(Items items) {
  return items.size() == 1 && (is_symbol(items[0], U'…') || is_symbol(items[0], U'⋯')) && is_plain(items[0]);
}

bool joins_sentences(const TexItem& item) {
  const std::string& text = item.node->text;
  const std::size_t begin = text.find_first_not_of(" ,");
  if (begin == text.npos) return true;
  const std::string_view joining =
      words::read_in_english(std::string_view(text).substr(begin, text.find_last_not_of(" ,") + 1 - begin));
  constexpr std::array<std::string_view, 12> kJoining{
      "and", "so", "hence", "thus", "therefore", "with", "also", "where", "while", "that is", "i.e.", "but"};
  return std::find(kJoining.begin(), kJoining.end(), joining) != kJoining.end();
}

bool has_words(const MathNode& node) {
  return node.kind == Kind::text || std::any_of(node.children.begin(), node.children.end(), has_words);
}

bool is_upright(const TexItem& item) {
  return item.node->kind == Kind::symbol && item.node->alphabet == Alphabet::upright;
}

std::vector<TexItems> cells_of(Items side) {
  std::vector<TexItems> cells;
  if (side.empty()) return cells;
  const TexItem& first = side.front();
  if (first.kind == ItemKind::group && first.open != U'|' && first.open != U'⏟') {
    cells.emplace_back();
    for (const TexItem& item : first.inside) {
      if (item.kind == ItemKind::comma)
        cells.emplace_back();
      else if (item.kind != ItemKind::gap)
        cells.back().push_back(item);
    }
  } else if (first.kind == ItemKind::operand && first.node->kind == Kind::grid) {
    for (const MathNode& cell : first.node->children)
      cells.push_back(items_of(cell, kMaxEquationNesting - 1));
  }
  return cells;
}

void collect(const TexItem& item, std::vector<std::size_t>& numbers) {
  const auto below = [&](const auto& self, const MathNode& node) -> void {
    if (const auto index = index_of_live(node)) numbers.push_back(*index);
    for (const MathNode& child : node.children) self(self, child);
  };
  if (item.node != nullptr && item.kind == ItemKind::operand) below(below, *item.node);
  for (const TexItem& inner : item.inside) collect(inner, numbers);
}

}  // namespace polhode
