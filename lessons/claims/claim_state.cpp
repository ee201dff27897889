// SPDX-License-Identifier: MIT
#include "lessons/claims/claim_state.h"

#include <algorithm>

namespace polhode {

template <class N>
std::optional<StateNumbers<N>> with_given(StateNumbers<N> n, const Given& given) {
  for (const Setting& setting : given.settings) {
    const ClaimState<N> so_far = state_of(n, Assumption::identity);
    Evaluation<N> evaluate(so_far);
    Triple<N> value;
    if (!evaluate(setting.value, value)) return std::nullopt;
    const auto place = [&setting](Quantity first) {
      return static_cast<std::size_t>(static_cast<int>(setting.quantity) - static_cast<int>(first));
    };
    using Q = Quantity;
    switch (setting.quantity) {
      case Q::I1:
      case Q::I2:
      case Q::I3:
        if (value[0].value.is_zero()) return std::nullopt;
        n.I[place(Q::I1)] = value[0].value;
        break;
      case Q::w1:
      case Q::w2:
      case Q::w3:
        n.w[place(Q::w1)] = value[0].value;
        break;
      case Q::N1:
      case Q::N2:
      case Q::N3:
        n.N_B[place(Q::N1)] = value[0].value;
        break;
      case Q::N: {
        const Triple<N> N_B = evaluate.to_body(value);
        for (std::size_t i = 0; i < 3; ++i) n.N_B[i] = N_B[i].value;
        break;
      }
      case Q::F:
        for (std::size_t i = 0; i < 3; ++i) n.F_S[i] = value[i].value;
        break;
      default:
        return std::nullopt;  // given.h
    }
  }
  return n;
}

template std::optional<StateNumbers<FieldElement>> with_given(StateNumbers<FieldElement>, const Given&);
template std::optional<StateNumbers<WideFieldElement>> with_given(StateNumbers<WideFieldElement>,
                                                                  const Given&);
template std::optional<StateNumbers<SizedNumber>> with_given(StateNumbers<SizedNumber>, const Given&);

bool is_possible_body(const std::array<SizedNumber, 3>& I) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double others = I[(i + 1) % 3].value + I[(i + 2) % 3].value;
    if (!(I[i].value > 0) || I[i].value > others * (1 + 1e-12)) return false;
  }
  return true;
}

bool holds_in(const Given& given, const ClaimState<SizedNumber>& state, double tolerance) {
  Evaluation<SizedNumber> evaluate(state);
  return std::all_of(given.settings.begin(), given.settings.end(), [&](const Setting& setting) {
    ExpressionNode quantity;
    quantity.operation = Operation::quantity;
    quantity.quantity = setting.quantity;
    Triple<SizedNumber> is, shall_be;
    return evaluate({"", {quantity}}, is) && evaluate(setting.value, shall_be) &&
           relative_residual(is, shall_be) <= tolerance;
  });
}

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
