// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/asked_formulas.h"

#include <utility>

namespace polhode {

namespace {

/// A formula without a relation is read as the left side of one.
Result<ReadEquation, UnreadableEquation> read_formula(const TextSpan& formula, const LineNotation& how) {
  auto read = read_equation(formula.math, *how.notation);
  if (read) return read;
  auto with_zero = parse_math(formula.text + " = 0", how.macros);
  return with_zero ? read_equation(*with_zero, *how.notation) : std::move(read);
}

}  // namespace

std::vector<Expression> asked_formulas(const RichText& prompt, const LineNotation& how) {
  std::vector<Expression> asked;
  for_each_span(prompt, [&](const TextSpan& span) {
    if (span.kind != TextSpan::Kind::math) return;
    auto read = read_formula(span, how);
    if (!read) return;
    for (EquationSentence& sentence : read->sentences)
      for (EquationLink& link : sentence.links)
        for (Expression* side : {&link.equality.left, &link.equality.right})
          if (side->type() != ExpressionType::zero && is_rational(*side)) asked.push_back(std::move(*side));
  });
  return asked;
}

}  // namespace polhode
