// SPDX-License-Identifier: MIT
#include "lessons/claims/claim_state.h"

#include "lessons/claims/proof/power_series.h"
#include "lessons/claims/proof/rational_function.h"

#include <algorithm>

namespace polhode {

namespace {

/// Which of three that follow each other; nothing if it is none of them.
std::optional<std::size_t> place_among_three(Quantity quantity, Quantity first) {
  const int place = static_cast<int>(quantity) - static_cast<int>(first);
  return place >= 0 && place < 3 ? std::optional(static_cast<std::size_t>(place)) : std::nullopt;
}

/// All but the rates of N, F, and what follows from these.
template <class N>
ClaimState<N> first_order_state(const StateNumbers<N>& n, LawsAssumed laws) {
  ClaimState<N> state{};
  state.I = n.I;
  state.J = n.J;
  state.m = n.m;
  state.h = n.h;
  state.k = n.k;
  state.constants = n.constants;
  const bool moves_freely = laws == LawsAssumed::identity;
  const std::array<N, 3> torque = laws == LawsAssumed::free ? std::array<N, 3>{} : n.N_B;
  const std::array<N, 3> dw = moves_freely ? n.dw : euler_rate(n.I, n.w, torque);
  const N reciprocal = moves_freely ? N(0) : inverse(n.m);
  for (std::size_t i = 0; i < 3; ++i) {
    state.N_B[i].value = torque[i];
    state.F_S[i].value = n.F_S[i];
    state.w_B[i] = {n.w[i], dw[i]};
    state.v_S[i] = {n.v_S[i], moves_freely ? n.dv_S[i] : reciprocal * n.F_S[i]};
    state.A_S[i] = {n.A_S[i], n.dA_S[i], n.ddA_S[i]};
  }
  state.R = attitude_matrix(turning(n.q, n.w, dw));
  return state;
}

/// The rates of what a setting sets N and F to. False where it is not defined.
template <class N>
bool add_given_rate(ClaimState<N>& state, const Setting& setting) {
  const auto component = place_among_three(setting.quantity, Quantity::N1);
  if (!component && setting.quantity != Quantity::N && setting.quantity != Quantity::F) return true;
  Evaluation<N, 1> evaluate(state);
  ComponentJets<N, 1> value;
  if (!evaluate(setting.value, value)) return false;
  if (component) {
    state.N_B[*component].rate = value[0].rate;
    return true;
  }
  if (setting.quantity == Quantity::N) value = evaluate.to_body(value);
  ComponentJets<N>& vector = setting.quantity == Quantity::N ? state.N_B : state.F_S;
  for (std::size_t i = 0; i < 3; ++i) vector[i].rate = value[i].rate;
  return true;
}

}  // namespace

template <class N>
std::optional<ClaimState<N>> state_of(StateNumbers<N> n, LawsAssumed laws, const Given& given) {
  if (!given.settings.empty()) {
    auto replaced = with_given(std::move(n), given);
    if (!replaced) return std::nullopt;
    n = std::move(*replaced);
  }
  ClaimState<N> state = first_order_state(n, laws);
  for (std::size_t i = 0; i < 3; ++i) {
    if (laws != LawsAssumed::free) state.N_B[i].rate = n.dN_B[i];
    state.F_S[i].rate = n.dF_S[i];
  }
  for (const Setting& setting : given.settings)
    if (!add_given_rate(state, setting)) return std::nullopt;
  if (laws == LawsAssumed::identity) {
    for (std::size_t i = 0; i < 3; ++i) {
      state.w_B[i].second = n.ddw[i];
      state.v_S[i].second = n.ddv_S[i];
    }
    return state;
  }
  using Number = Jet<N, 1>;
  std::array<Number, 3> I, w, torque;
  for (std::size_t i = 0; i < 3; ++i) {
    I[i] = Number(n.I[i], N(0));
    w[i] = Number(state.w_B[i]);
    torque[i] = Number(state.N_B[i]);
  }
  const std::array<Number, 3> dw = euler_rate(I, w, torque);
  const N reciprocal = inverse(n.m);
  for (std::size_t i = 0; i < 3; ++i) {
    state.w_B[i].second = dw[i].rate;
    state.v_S[i].second = reciprocal * state.F_S[i].rate;
  }
  return state;
}

template <class N>
std::optional<StateNumbers<N>> with_given(StateNumbers<N> n, const Given& given) {
  for (const Setting& setting : given.settings) {
    const ClaimState<N> so_far = first_order_state(n, LawsAssumed::identity);
    Evaluation<N, 0> evaluate(so_far);
    ComponentJets<N, 0> value;
    if (!evaluate(setting.value, value)) return std::nullopt;
    if (const auto moment = place_among_three(setting.quantity, Quantity::I1)) {
      if (value[0].value.is_zero()) return std::nullopt;
      n.I[*moment] = value[0].value;
    } else if (const auto spin = place_among_three(setting.quantity, Quantity::w1)) {
      n.w[*spin] = value[0].value;
    } else if (const auto torque = place_among_three(setting.quantity, Quantity::N1)) {
      n.N_B[*torque] = value[0].value;
    } else {
      const bool is_torque = setting.quantity == Quantity::N;
      if (is_torque) value = evaluate.to_body(value);
      std::array<N, 3>& vector = is_torque ? n.N_B : n.F_S;
      for (std::size_t i = 0; i < 3; ++i) vector[i] = value[i].value;
    }
  }
  return n;
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type in a template's arguments has none
#define POLHODE_STATES_OF(N)                                                                  \
  template std::optional<ClaimState<N>> state_of(StateNumbers<N>, LawsAssumed, const Given&); \
  template std::optional<StateNumbers<N>> with_given(StateNumbers<N>, const Given&);
POLHODE_STATES_OF(FieldElement)
POLHODE_STATES_OF(WideFieldElement)
POLHODE_STATES_OF(SizedNumber)
POLHODE_STATES_OF(RationalFunction)
POLHODE_STATES_OF(PowerSeries<FieldElement>)
POLHODE_STATES_OF(PowerSeries<WideFieldElement>)
POLHODE_STATES_OF(PowerSeries<Ratio>)
#undef POLHODE_STATES_OF
// NOLINTEND(bugprone-macro-parentheses)

bool is_possible_body(const std::array<SizedNumber, 3>& I) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double others = I[(i + 1) % 3].value + I[(i + 2) % 3].value;
    if (!(I[i].value > 0) || I[i].value > others * (1 + 1e-12)) return false;
  }
  return true;
}

bool holds_in(const Bound& bound, const ClaimState<SizedNumber>& state, double tolerance, bool strictly) {
  const auto left = value_in(state, bound.sides.left), right = value_in(state, bound.sides.right);
  if (!left || !right) return false;
  const SizedNumber l = (*left)[0].value, r = (*right)[0].value;
  const bool is_upward = bound.relation == Relation::greater || bound.relation == Relation::greater_or_equal;
  const bool is_strict = bound.relation == Relation::greater || bound.relation == Relation::less;
  const double excess = is_upward ? l.value - r.value : r.value - l.value;
  const double rounding = tolerance * std::fmax(l.size, r.size);
  return strictly || is_strict ? excess > rounding : excess >= -rounding;
}

bool holds_in(const Given& given, const ClaimState<SizedNumber>& state, double tolerance) {
  return std::all_of(given.bounds.begin(), given.bounds.end(),
                     [&](const Bound& bound) { return holds_in(bound, state, tolerance, false); }) &&
         std::all_of(given.settings.begin(), given.settings.end(), [&](const Setting& setting) {
           ExpressionNode quantity;
           quantity.operation = Operation::quantity;
           quantity.quantity = setting.quantity;
           const auto is = value_in(state, Expression{"", {quantity}}),
                      shall_be = value_in(state, setting.value);
           return is && shall_be && relative_residual(*is, *shall_be) <= tolerance;
         });
}

namespace {

/// Of several expressions, in their order; by jets of this order.
template <class N, int Order, std::size_t Count>
std::optional<std::array<ComponentJets<N, 0>, Count>> values_by_jets(
    const ClaimState<N>& state, const std::array<const Expression*, Count>& expressions) {
  Evaluation<N, Order> evaluate(state);
  std::array<ComponentJets<N, 0>, Count> values;
  for (std::size_t i = 0; i < Count; ++i) {
    ComponentJets<N, Order> value;
    if (!evaluate(*expressions[i], value)) return std::nullopt;
    values[i] = {Jet<N, 0>(value[0]), Jet<N, 0>(value[1]), Jet<N, 0>(value[2])};
  }
  return values;
}

template <class N, std::size_t Count>
std::optional<std::array<ComponentJets<N, 0>, Count>> values_in(
    const ClaimState<N>& state, const std::array<const Expression*, Count>& expressions) {
  int order = 0;
  for (const Expression* expression : expressions) order = std::max(order, expression->order());
  if (order == 0) return values_by_jets<N, 0>(state, expressions);
  return order == 1 ? values_by_jets<N, 1>(state, expressions) : values_by_jets<N, 2>(state, expressions);
}

}  // namespace

template <class N>
std::optional<ComponentJets<N, 0>> value_in(const ClaimState<N>& state, const Expression& expression) {
  const auto values = values_in(state, std::array{&expression});
  return values ? std::optional(values->front()) : std::nullopt;
}

template <class N>
std::optional<bool> agree(const Equality& equality, const ClaimState<N>& state) {
  const auto sides = values_in(state, std::array{&equality.left, &equality.right});
  if (!sides) return std::nullopt;
  const auto& [left, right] = *sides;
  return left[0].value == right[0].value && left[1].value == right[1].value &&
         left[2].value == right[2].value;
}

#define POLHODE_VALUES_OF(N) \
  template std::optional<ComponentJets<N, 0>> value_in(const ClaimState<N>&, const Expression&);
POLHODE_VALUES_OF(FieldElement)
POLHODE_VALUES_OF(WideFieldElement)
POLHODE_VALUES_OF(SizedNumber)
POLHODE_VALUES_OF(RationalFunction)
POLHODE_VALUES_OF(PowerSeries<FieldElement>)
POLHODE_VALUES_OF(PowerSeries<WideFieldElement>)
POLHODE_VALUES_OF(PowerSeries<Ratio>)
#undef POLHODE_VALUES_OF
template std::optional<bool> agree(const Equality&, const ClaimState<FieldElement>&);
template std::optional<bool> agree(const Equality&, const ClaimState<WideFieldElement>&);

double relative_residual(const ComponentJets<SizedNumber, 0>& left,
                         const ComponentJets<SizedNumber, 0>& right) {
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
  const auto values = values_in(state, std::array{&equality.left, &equality.right});
  if (!values) return std::nullopt;
  const auto& [left, right] = *values;
  const Sides sides{left, right, relative_residual(left, right)};
  return std::isfinite(sides.residual) ? std::optional(sides) : std::nullopt;
}

}  // namespace polhode
