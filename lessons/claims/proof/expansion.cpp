// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/expansion.h"

#include "lessons/claims/proof/rational_function.h"

#include <algorithm>
#include <vector>

namespace polhode {
namespace {

/// The same numbers, with those that are small times ε.
template <class N>
StateNumbers<PowerSeries<N>> expanded(StateNumbers<N> numbers, const SmallQuantities& small) {
  std::vector<N> all;
  for_each_number(numbers, [&all](const N& number) { all.push_back(number); });
  StateNumbers<PowerSeries<N>> series;
  std::size_t next = 0;
  for_each_number(series, [&](PowerSeries<N>& number) { number = PowerSeries<N>(all[next++]); });
  const auto shrink = [](PowerSeries<N>& number, const N& value) { number = PowerSeries<N>(value, 1); };
  constexpr std::array kSpin{Quantity::w1, Quantity::w2, Quantity::w3},
      kTorque{Quantity::N1, Quantity::N2, Quantity::N3};
  for (std::size_t i = 0; i < 3; ++i) {
    if (small.has(kSpin[i])) shrink(series.w[i], numbers.w[i]);
    if (small.has(kTorque[i])) shrink(series.N_B[i], numbers.N_B[i]);
  }
  if (small.has(Quantity::h)) shrink(series.h, numbers.h);
  if (small.has(Quantity::k)) shrink(series.k, numbers.k);
  return series;
}

}  // namespace

template <class N>
std::optional<ExpandedSides<N>> expanded_sides(const Equality& sides, const StateNumbers<N>& numbers,
                                               LawsAssumed laws, const Given& given) {
  const auto state = state_of(expanded(numbers, given.small), laws, given);
  if (!state) return std::nullopt;
  const auto left = value_in(*state, sides.left), right = value_in(*state, sides.right);
  if (!left || !right) return std::nullopt;
  ExpandedSides<N> all;
  for (std::size_t i = 0; i < 3; ++i) {
    all.left[i] = (*left)[i].value;
    all.right[i] = (*right)[i].value;
  }
  return all;
}

template <class N>
OrderComparison compare_to_order(const ExpandedSides<N>& sides, int order) {
  OrderComparison comparison;
  for (std::size_t i = 0; i < 3; ++i) {
    const PowerSeries<N>&left = sides.left[i], &right = sides.right[i];
    const PowerSeries<N> difference = left - right;
    if (!difference.is_zero() && difference.first() <= order)
      comparison.differ_at = std::min(comparison.differ_at.value_or(order), difference.first());
    for (const PowerSeries<N>* series : {&left, &right, &difference})
      if (series->end() <= order) comparison.is_known = false;
    for (const PowerSeries<N>* side : {&left, &right})
      if (!side->is_zero() && side->first() <= order) comparison.are_zero = false;
  }
  return comparison;
}

template std::optional<ExpandedSides<FieldElement>> expanded_sides(const Equality&,
                                                                   const StateNumbers<FieldElement>&,
                                                                   LawsAssumed, const Given&);
template OrderComparison compare_to_order(const ExpandedSides<FieldElement>&, int);
template std::optional<ExpandedSides<WideFieldElement>> expanded_sides(const Equality&,
                                                                       const StateNumbers<WideFieldElement>&,
                                                                       LawsAssumed, const Given&);
template OrderComparison compare_to_order(const ExpandedSides<WideFieldElement>&, int);
template std::optional<ExpandedSides<Ratio>> expanded_sides(const Equality&, const StateNumbers<Ratio>&,
                                                            LawsAssumed, const Given&);
template OrderComparison compare_to_order(const ExpandedSides<Ratio>&, int);

}  // namespace polhode
