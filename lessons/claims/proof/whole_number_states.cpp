// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/whole_number_states.h"

#include "lessons/claims/proof/counterexample_text.h"
#include "lessons/claims/proof/dependence.h"
#include "lessons/claims/proof/expansion.h"
#include "lessons/claims/proof/rational_function.h"
#include "lessons/claims/proof/whole_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace polhode {
namespace {

/// So many states are tried where sides are compared by their order: a sign may change anywhere.
constexpr int kMixedStates = 500;

CounterBody body_of(const StateNumbers<SizedNumber>& s, const Dependence& d) {
  CounterBody body;
  for (std::size_t i = 0; i < 3; ++i) {
    body.I[i] = s.I[i].value;
    body.w[i] = s.w[i].value;
    body.N[i] = d.N ? s.N_B[i].value : 0.0;
  }
  if (d.q)
    for (std::size_t i = 0; i < 4; ++i) body.q[i] = s.q[i].value;
  body.has_more = d.dw || d.ddw || d.dN || d.J || d.v || d.dv || d.ddv || d.A || d.dA || d.ddA || d.F ||
                  d.dF || d.m || d.h || d.k || !d.constants.empty();
  return body;
}

/// Whole numbers so small that what is zero is far below this, and what is not far above.
constexpr double kZero = 1e-9;

/// Whether the sides are not in this relation, by doubles. What they tell of equality is to be confirmed
/// exactly: agree(equality, exact) is not `residual > kZero`.
bool seems_to_fail(Relation relation, const Sides& sides) {
  const bool are_apart = sides.residual > kZero, are_equal = sides.residual < kZero;
  const bool is_less = sides.left[0].value.value < sides.right[0].value.value;
  switch (relation) {
    case Relation::equal:
    case Relation::approximate:
      return are_apart;
    case Relation::less:
      return are_equal || (are_apart && !is_less);
    case Relation::less_or_equal:
      return are_apart && !is_less;
    case Relation::greater:
      return are_equal || (are_apart && is_less);
    case Relation::greater_or_equal:
      return are_apart && is_less;
  }
  return false;
}

/// Whether they are equal, by doubles.
bool seems_to_hold(const Equality& equality, const ClaimState<SizedNumber>& real) {
  const std::optional<Sides> sides = sides_of(equality, real);
  return sides && sides->residual < kZero;
}

/// Whether all inequalities hold.
bool are_within(const Given& given, const ClaimState<SizedNumber>& state) {
  return std::all_of(given.bounds.begin(), given.bounds.end(),
                     [&](const Bound& bound) { return holds_in(bound, state, kZero, false); });
}

/// A possible body, and what it does, by doubles.
struct RealState {
  StateNumbers<SizedNumber> numbers;
  ClaimState<SizedNumber> state;
};
/// Nothing where no such body is possible, or what is given does not hold.
std::optional<RealState> real_state_of(const WholeNumbers& whole, LawsAssumed laws, const Given& given) {
  auto numbers = with_given(as<SizedNumber>(whole), given);
  if (!numbers || !is_possible_body(numbers->I)) return std::nullopt;
  auto state = state_of(*numbers, laws, given);
  if (!state || !are_within(given, *state)) return std::nullopt;
  return RealState{std::move(*numbers), std::move(*state)};
}

bool is_finite(const StateNumbers<SizedNumber>& numbers) {
  const auto all_finite = [](const std::array<SizedNumber, 3>& three) {
    return std::all_of(three.begin(), three.end(),
                       [](const SizedNumber& x) { return std::isfinite(x.value); });
  };
  return all_finite(numbers.w) && all_finite(numbers.N_B) && all_finite(numbers.F_S);
}

/// Of states times nodes; what is longer is tried in fewer states.
constexpr std::size_t kMostWork = 1'000'000;

std::size_t size_of(const Equality& equality) {
  return equality.left.nodes.size() + equality.right.nodes.size();
}

/// Of the inequalities that are given, which are looked at in each state.
std::size_t size_of(const std::vector<Bound>& bounds) {
  std::size_t nodes = 0;
  for (const Bound& bound : bounds) nodes += size_of(bound.sides);
  return nodes;
}

}  // namespace

bool is_possible(const Given& given) {
  constexpr int kMostDoublings = 140;
  for (const WholeNumbers& body : whole_number_bodies())
    for (int doublings = -kMostDoublings; doublings <= kMostDoublings; ++doublings) {
      auto numbers = as<SizedNumber>(body);
      for (SizedNumber& moment : numbers.I) moment = std::ldexp(moment.value, doublings);
      const auto replaced = with_given(numbers, given);
      if (replaced && is_possible_body(replaced->I) && is_finite(*replaced)) return true;
    }
  return false;
}

std::optional<Counterexample> first_whole_number_state(const Equality& equality, const Equality* premise,
                                                       LawsAssumed laws, const Given& given,
                                                       Relation relation, int* tried) {
  Dependence depends = dependence_of(equality, laws, given);
  if (premise) depends |= dependence_of(*premise, laws, given);
  std::optional<Counterexample> found;
  const std::size_t work = size_of(equality) + (premise ? size_of(*premise) : 0) + size_of(given.bounds);
  std::size_t work_left = kMostWork;
  const auto look_at = [&](const WholeNumbers& numbers) {
    if (work_left < work) return true;
    work_left -= work;
    const auto real = real_state_of(numbers, laws, given);
    if (!real || (premise && !seems_to_hold(*premise, real->state))) return false;
    const std::optional<Sides> sides = sides_of(equality, real->state);
    const bool is_found = sides && seems_to_fail(relation, *sides);
    if (!is_found && (tried == nullptr || !sides)) return false;
    // In a field a state costs far more, and where doubles see no difference it says nothing new.
    const auto exact_numbers = with_given(as<FieldElement>(numbers), given);
    const auto exact = exact_numbers ? state_of(*exact_numbers, laws, given) : std::nullopt;
    if (!exact || (premise && agree(*premise, *exact) != std::optional(true))) return false;
    if (tried != nullptr) ++*tried;
    if (!is_found || agree(equality, *exact) != std::optional(sides->residual < kZero)) return false;
    StateText state = text_of(real->numbers, real->state, depends, {});
    found = Counterexample{std::move(state.plain), value_text(sides->left, equality.left.type()),
                           value_text(sides->right, equality.right.type()), body_of(real->numbers, depends),
                           std::move(state.tex)};
    return true;
  };
  for_each_whole_number_state(depends, look_at);
  // Where inequalities are given, the states above may all be beyond them; and a premise may hold in none.
  if (!is_order(relation) && given.bounds.empty() && !premise) return found;
  std::mt19937_64 random(1);
  for (int n = 0; n < kMixedStates && !found; ++n) look_at(mixed_numbers(random));
  for (int n = 0; n < kMixedStates && !found && !given.bounds.empty(); ++n) look_at(uneven_numbers(random));
  return found;
}

std::optional<Counterexample> first_state_in_series(const Equality& equality, LawsAssumed laws,
                                                    const Given& given, int& differ_at) {
  const Dependence depends = dependence_of(equality, laws, given);
  std::optional<Counterexample> found;
  // An expansion costs as much as some thirty states.
  constexpr std::size_t kCost = 30;
  std::size_t work_left = kMostWork / kCost;
  const std::size_t work = size_of(equality) + size_of(given.bounds) / kCost;
  const auto look_at = [&](const WholeNumbers& numbers) {
    if (work_left < work) return true;
    work_left -= work;
    const auto real = real_state_of(numbers, laws, given);
    if (!real) return false;
    const auto sides = expanded_sides(equality, as<FieldElement>(numbers), laws, given);
    if (!sides || !compare_to_order(*sides, given.small.order).differ_at) return false;
    try {
      const auto exact = expanded_sides(equality, as<Ratio>(numbers), laws, given);
      const auto at = exact ? compare_to_order(*exact, given.small.order).differ_at : std::nullopt;
      if (!at) return false;
      differ_at = *at;
      StateText state = text_of(real->numbers, real->state, depends, given.small);
      found = Counterexample{std::move(state.plain),
                             text_of(exact->left, equality.left.type(), *at),
                             text_of(exact->right, equality.right.type(), *at),
                             {},
                             std::move(state.tex)};
    } catch (const BeyondAlgebra&) {  // a number too large to be written
      return false;
    }
    return true;
  };
  for_each_whole_number_state(depends, look_at);
  std::mt19937_64 random(1);
  for (int n = 0; n < kMixedStates && !found; ++n) look_at(mixed_numbers(random));
  return found;
}

bool bounds_are_possible(const Given& given) {
  if (given.bounds.empty()) return true;
  std::mt19937_64 random(1);
  constexpr int kTried = 4000;
  std::size_t work = size_of(given.bounds), work_left = kMostWork / 2;
  for (const Setting& setting : given.settings) work += 2 * setting.value.nodes.size();
  for (int n = 0; n < kTried && work_left >= work; ++n) {
    work_left -= work;
    auto numbers = as<SizedNumber>(n % 2 == 0 ? mixed_numbers(random) : uneven_numbers(random));
    if (n % 4 > 1) {  // as small and as large as numbers in SI units may be
      const auto scaled = [&random](auto&... all) {
        const int doublings = static_cast<int>(random() % 121) - 60;
        const auto scale = [doublings](SizedNumber& x) { x = std::ldexp(x.value, doublings); };
        (std::for_each(all.begin(), all.end(), scale), ...);
      };
      scaled(numbers.I);
      scaled(numbers.w);
      scaled(numbers.N_B);
      scaled(numbers.constants);
    }
    const auto replaced = with_given(numbers, given);
    if (!replaced || !is_possible_body(replaced->I) || !is_finite(*replaced)) continue;
    const auto state = state_of(numbers, LawsAssumed::identity, given);
    if (state && std::all_of(given.bounds.begin(), given.bounds.end(),
                             [&](const Bound& bound) { return holds_in(bound, *state, kZero, true); }))
      return true;
  }
  return false;
}

}  // namespace polhode
