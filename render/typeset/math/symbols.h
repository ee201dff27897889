// SPDX-License-Identifier: MIT
// Where the symbols of a lesson stand in a formula.
#pragma once

#include "render/typeset/math/math.h"
#include "render/typeset/math/tree.h"

#include <span>
#include <vector>

namespace polhode {

/// Symbols to look for; they must outlive it.
class MathSymbols {
 public:
  explicit MathSymbols(const std::vector<MathSymbol>* symbols);

  struct Found {
    const MathSymbol* symbol = nullptr;
    std::size_t count = 0;  ///< atoms it takes
  };
  /// The longest symbol that begins at atoms[i]; count 0: none does.
  Found at(std::span<const MathNode> atoms, std::size_t i) const;
  /// The symbol that a single atom is; null: none.
  const MathSymbol* of(const MathNode& atom) const;
  /// ω₁ in ω₁²: nucleus and subscript are the symbol.
  const MathSymbol* below_power(const MathNode& atom) const;
  /// ω₁ in ω̇₁ or ω̈₁: what is under the dots, with the subscript, is the symbol. The whole is another quantity
  /// of its colour.
  const MathSymbol* below_dots(const MathNode& atom) const;

 private:
  std::vector<const MathSymbol*> symbols_;
};

}  // namespace polhode
