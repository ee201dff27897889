// SPDX-License-Identifier: MIT
// Expressions as trees that can be cut, joined and written out again: what mutants and rewritings are made
// of.
#pragma once

#include "lessons/claims/expressions/expression.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::oracle {

struct Term {
  Operation operation = Operation::number;
  std::string word;  ///< of a number or quantity, as it is written
  int integer = 0;   ///< exponent, or 0 to 2 of comp
  std::vector<Term> operands;
  bool operator==(const Term&) const = default;
};

/// As lessons/ reads it, or nothing.
std::optional<Expression> expression_from(std::string_view text);
/// Of two such, if they can be equal.
std::optional<Equality> equality_from(std::string_view left, std::string_view right);

Term term_of(const Expression& expression);
/// Precondition: read_expression takes the text.
Term term_from(std::string_view text);
/// With brackets around every sum and product.
std::string text_of(const Term& term);

bool is_vector(const Term& term);
std::size_t size_of(const Term& term);

/// Calls use(spot) for the term itself and everything in it.
template <class AnyTerm, class Use>
void for_each_spot(AnyTerm& term, const Use& use) {
  use(term);
  for (auto& operand : term.operands) for_each_spot(operand, use);
}

}  // namespace polhode::oracle
