// SPDX-License-Identifier: MIT
// Both sides of a claim as series in ε where quantities are small (given.h). Internal to lessons/claims/.
#pragma once

#include "lessons/claims/claim_state.h"
#include "lessons/claims/proof/power_series.h"

#include <array>
#include <optional>

namespace polhode {

/// Sides of so many nodes together are expanded: at most some 10 ms of a proof. More are undecided.
inline constexpr std::size_t kMostExpandedNodes = 600;

template <class N>
using Expansion = std::array<PowerSeries<N>, 3>;  ///< components in space; of a scalar the first

template <class N>
struct ExpandedSides {
  Expansion<N> left, right;
};

/// In the state of these numbers, under these laws and with what is given put in, where each quantity w
/// that is small is ε w. Nothing where a side is not defined: something is divided by 0, or by what is not
/// known to be anything else.
template <class N>
std::optional<ExpandedSides<N>> expanded_sides(const Equality& sides, const StateNumbers<N>& numbers,
                                               LawsAssumed laws, const Given& given);

/// How two sides compare through ε^order.
struct OrderComparison {
  std::optional<int> differ_at;  ///< the first exponent at which they differ, if it is at most the order
  bool is_known = true;          ///< false: so many terms cancel that nothing can be said of the order
  bool are_zero = true;          ///< neither has a term through ε^order
};
template <class N>
OrderComparison compare_to_order(const ExpandedSides<N>& sides, int order);

}  // namespace polhode
