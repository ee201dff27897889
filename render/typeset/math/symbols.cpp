// SPDX-License-Identifier: MIT
#include "render/typeset/math/symbols.h"

#include <algorithm>

namespace polhode {
namespace {

const MathNode& root_of(const MathSymbol& symbol) { return without_groups(*symbol.math.root); }

bool begins_with(std::span<const MathNode> atoms, std::size_t i, const std::vector<MathNode>& sought) {
  return sought.size() <= atoms.size() - i &&
         std::equal(sought.begin(), sought.end(), atoms.begin() + static_cast<std::ptrdiff_t>(i), same_math);
}

}  // namespace

MathSymbols::MathSymbols(const std::vector<MathSymbol>* symbols) {
  if (symbols == nullptr) return;
  for (const MathSymbol& symbol : *symbols) {
    const bool empty = !symbol.math.root ||
                       (root_of(symbol).kind == MathNode::Kind::row && root_of(symbol).children.empty());
    if (!empty) symbols_.push_back(&symbol);
  }
}

MathSymbols::Found MathSymbols::at(std::span<const MathNode> atoms, std::size_t i) const {
  Found longest;
  for (const MathSymbol* symbol : symbols_) {
    const MathNode& root = root_of(*symbol);
    const bool is_row = root.kind == MathNode::Kind::row;
    const std::size_t count = is_row ? root.children.size() : 1;
    if (count <= longest.count) continue;
    if (is_row ? begins_with(atoms, i, root.children) : same_math(root, atoms[i])) longest = {symbol, count};
  }
  return longest;
}

const MathSymbol* MathSymbols::of(const MathNode& atom) const {
  for (const MathSymbol* symbol : symbols_)
    if (root_of(*symbol).kind != MathNode::Kind::row && same_math(root_of(*symbol), atom)) return symbol;
  return nullptr;
}

const MathSymbol* MathSymbols::below_power(const MathNode& atom) const {
  constexpr auto kScripts = MathNode::Kind::scripts;
  if (atom.kind != kScripts || atom.children[1].absent() || atom.children[2].absent()) return nullptr;
  for (const MathSymbol* symbol : symbols_) {
    const MathNode& root = root_of(*symbol);
    if (root.kind == kScripts && root.children[2].absent() && same_math(root.children[0], atom.children[0]) &&
        same_math(root.children[1], atom.children[1]))
      return symbol;
  }
  return nullptr;
}

const MathSymbol* MathSymbols::below_dots(const MathNode& atom) const {
  constexpr auto kScripts = MathNode::Kind::scripts;
  constexpr char32_t kDot = 0x307, kTwoDots = 0x308;
  if (atom.kind != kScripts || atom.children[1].absent()) return nullptr;
  const MathNode& accent = without_groups(atom.children[0]);
  if (accent.kind != MathNode::Kind::accent || (accent.character != kDot && accent.character != kTwoDots))
    return nullptr;
  for (const MathSymbol* symbol : symbols_) {
    const MathNode& root = root_of(*symbol);
    if (root.kind == kScripts && root.children[2].absent() &&
        same_math(root.children[0], accent.children[0]) && same_math(root.children[1], atom.children[1]))
      return symbol;
  }
  return nullptr;
}

}  // namespace polhode
