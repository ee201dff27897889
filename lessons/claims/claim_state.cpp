// SPDX-License-Identifier: MIT
#include "lessons/claims/claim_state.h"

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

std::optional<Sides> sides_of(const Equality& equality, const ClaimState<SizedNumber>& state) {
  Evaluation<SizedNumber> evaluate(state);
  Sides sides;
  if (!evaluate(equality.left, sides.left) || !evaluate(equality.right, sides.right)) return std::nullopt;
  sides.residual = relative_residual(sides.left, sides.right);
  return std::isfinite(sides.residual) ? std::optional(sides) : std::nullopt;
}

}  // namespace polhode
