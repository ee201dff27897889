// SPDX-License-Identifier: MIT
#include "lessons/claim_state.h"

#include "lessons/expression_variants.h"

namespace polhode {

template <int Bits>
std::optional<bool> agree(const Equality& equality, const ClaimState<MersenneElement<Bits>>& state) {
  Evaluation<MersenneElement<Bits>> evaluate(state);
  Triple<MersenneElement<Bits>> left, right;
  if (!evaluate(equality.left, left) || !evaluate(equality.right, right)) return std::nullopt;
  return left[0].value == right[0].value && left[1].value == right[1].value &&
         left[2].value == right[2].value;
}

template std::optional<bool> agree(const Equality&, const ClaimState<FieldElement>&);
template std::optional<bool> agree(const Equality&, const ClaimState<WideFieldElement>&);

double relative_residual(const Triple<SizedNumber>& left, const Triple<SizedNumber>& right) {
  double difference = 0, size_of_left = 0, size_of_right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    difference = std::hypot(difference, left[i].value.value - right[i].value.value);
    size_of_left = std::hypot(size_of_left, left[i].value.size);
    size_of_right = std::hypot(size_of_right, right[i].value.size);
  }
  if (difference == 0) return 0;
  return difference / std::fmax(size_of_left, size_of_right);
}

namespace {

double length(const Triple<SizedNumber>& x) {
  return std::hypot(x[0].value.value, x[1].value.value, x[2].value.value);
}

double size(const Triple<SizedNumber>& x) {
  return std::hypot(x[0].value.size, x[1].value.size, x[2].value.size);
}

/// Σ of the lengths of what is added up to make the expression evaluated last.
double sum_of_terms(const Expression& expression, const Evaluation<SizedNumber>& evaluation) {
  double sum = 0;
  for (const int term : terms_of(expression)) sum += length(evaluation.value_of(term));
  return sum;
}

}  // namespace

std::optional<Sides> sides_of(const Equality& equality, const ClaimState<SizedNumber>& state) {
  Evaluation<SizedNumber> evaluate(state);
  constexpr double kNoise = 1e-9;  // terms so small beside what they come from are zeros
  Sides sides;
  if (!evaluate(equality.left, sides.left)) return std::nullopt;
  double terms = sum_of_terms(equality.left, evaluate);
  if (!evaluate(equality.right, sides.right)) return std::nullopt;
  terms = std::fmax(terms, sum_of_terms(equality.right, evaluate));
  const double sizes = std::fmax(size(sides.left), size(sides.right));
  sides.terms = terms > kNoise * sizes ? terms : sizes;
  sides.cancellation = sides.terms > 0 ? sizes / sides.terms : 1;
  sides.residual = relative_residual(sides.left, sides.right) * sides.cancellation;
  return std::isfinite(sides.residual) ? std::optional(sides) : std::nullopt;
}

}  // namespace polhode
