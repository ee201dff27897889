// SPDX-License-Identifier: MIT
// Whether two equations are the same line written in another order. Internal to lessons/derivation/.
#pragma once

#include "lessons/claims/expressions/expression.h"

#include <map>
#include <string>

namespace polhode {

/// Terms of left − right and their numerical factors: products and sums in the order of their texts, brackets
/// as they stand, the first factor 1. What is 0 has no terms. A bracket that is multiplied out is another
/// line.
using CanonicalForm = std::map<std::string, double>;
CanonicalForm canonical_form(const Equality& equality);
/// With its brackets multiplied out, and sums taken out of products, rates and components: the same of all
/// ways to write an equation without putting one quantity in for another. Of more than kMostTerms terms, as
/// it stands.
CanonicalForm expanded_form(const Equality& equality);
inline constexpr std::size_t kMostTerms = 400;

/// Quantities and operations that an equation speaks of, but for sums and products of numbers. A rate of ω is
/// the same in both frames, dω₁/dt is ω̇₁, and a·a is |a|²; the rate of a product or a sum is one
/// more.
struct Words {
  std::string letters;  ///< one character for each, in their order
  bool contains(const Words& others) const;
};
Words words_of(const Equality& equality);

}  // namespace polhode
