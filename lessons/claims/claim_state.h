// SPDX-License-Identifier: MIT
// States of a body in which claims are tried, and what is assumed of its motion. Internal to lessons/claims/.
#pragma once

#include "lessons/claims/expressions/evaluation.h"
#include "lessons/claims/given.h"

#include <optional>

namespace polhode {

/// What a state obeys. identity: nothing, ω̇, N, v̇, F and their rates vary freely. motion: Euler's equations
/// with any N and any rate of it, and m v̇ = F. free: the same with N = 0 all the time.
enum class LawsAssumed { identity, motion, free };

/// The numbers that a state is made of, on the body axes unless the name says otherwise.
template <class N>
struct StateNumbers {
  std::array<N, 4> q{N(1), N(0), N(0), N(0)};  ///< w x y z, of any length but 0: body to space
  std::array<N, 3> I{};
  std::array<N, 6> J{};
  std::array<N, 3> w{}, dw{}, v_S{}, dv_S{}, A_S{}, dA_S{}, N_B{}, F_S{};
  std::array<N, 3> ddw{}, ddv_S{}, ddA_S{}, dN_B{}, dF_S{};  ///< second rates; of N and F the first
  N m{1};
  N h{1}, k{1};
  std::array<N, kMaxConstants> constants{};
};

/// Takes body components to space components: R(q) = homogeneous / |q|², with its rate.
template <class N>
std::array<ComponentJets<N>, 3> attitude_matrix(const std::array<Jet<N>, 4>& q) {
  const auto& [w, x, y, z] = q;
  const Jet<N> scale = inverse(w * w + x * x + y * y + z * z);
  const auto twice = [](const Jet<N>& a) { return a + a; };
  const std::array<ComponentJets<N>, 3> homogeneous{
      {{w * w + x * x - y * y - z * z, twice(x * y - w * z), twice(x * z + w * y)},
       {twice(x * y + w * z), w * w - x * x + y * y - z * z, twice(y * z - w * x)},
       {twice(x * z - w * y), twice(y * z + w * x), w * w - x * x - y * y + z * z}}};
  std::array<ComponentJets<N>, 3> R;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) R[i][k] = scale * homogeneous[i][k];
  return R;
}

/// q̇ = ½ q ω, and so q̈ = ½ (q̇ ω + q ω̇).
template <class N>
std::array<Jet<N>, 4> turning(const std::array<N, 4>& q, const std::array<N, 3>& w_B,
                              const std::array<N, 3>& dw_B) {
  const N half = inverse(N(2));
  const auto times = [&half](const std::array<N, 4>& a, const std::array<N, 3>& b) -> std::array<N, 4> {
    return {
        -(half * (a[1] * b[0] + a[2] * b[1] + a[3] * b[2])), half * (a[0] * b[0] + a[2] * b[2] - a[3] * b[1]),
        half * (a[0] * b[1] + a[3] * b[0] - a[1] * b[2]), half * (a[0] * b[2] + a[1] * b[1] - a[2] * b[0])};
  };
  const std::array<N, 4> rate = times(q, w_B), turned = times(rate, w_B), hastened = times(q, dw_B);
  std::array<Jet<N>, 4> all;
  for (std::size_t i = 0; i < 4; ++i) all[i] = {q[i], rate[i], turned[i] + hastened[i]};
  return all;
}

/// I ω̇ = N − ω×Iω, component by component: Euler's equations. Of numbers, or of jets: then ω̈ is the rate.
template <class N>
std::array<N, 3> euler_rate(const std::array<N, 3>& I, const std::array<N, 3>& w,
                            const std::array<N, 3>& torque_B) {
  return {inverse(I[0]) * (torque_B[0] - w[1] * w[2] * (I[2] - I[1])),
          inverse(I[1]) * (torque_B[1] - w[2] * w[0] * (I[0] - I[2])),
          inverse(I[2]) * (torque_B[2] - w[0] * w[1] * (I[1] - I[0]))};
}

/// The state of these numbers under these laws, which overrule the rates of ω and v, and what is given,
/// which overrules what it sets; of N and F also the rates. Nothing where what is given is not defined, or a
/// moment would be 0. Precondition: q, I and m are not zero.
template <class N>
std::optional<ClaimState<N>> state_of(StateNumbers<N> n, LawsAssumed laws, const Given& given);

/// The same where nothing is given: there is always one.
template <class N>
ClaimState<N> state_of(const StateNumbers<N>& n, LawsAssumed laws) {
  return *state_of(n, laws, Given());
}

/// The numbers with those replaced that are given, one after the other; rates are not. Nothing where one of
/// them is not defined, or a moment would be 0.
template <class N>
std::optional<StateNumbers<N>> with_given(StateNumbers<N> n, const Given& given);

/// Whether a body can have these moments: each is positive, and at most the sum of the other two.
bool is_possible_body(const std::array<SizedNumber, 3>& I);

/// Whether an inequality holds in a state, as far as `tolerance` of its terms; `strictly`: also where it may
/// be an equality. What is strict holds only where the sides are further apart.
bool holds_in(const Bound& bound, const ClaimState<SizedNumber>& state, double tolerance, bool strictly);

/// Whether the two sides of each setting agree in a state, as far as `tolerance` of their terms, and all
/// inequalities hold. Of what is small nothing is said.
bool holds_in(const Given& given, const ClaimState<SizedNumber>& state, double tolerance);

/// The value in a state, by jets of the expression's order; nothing where it is not defined.
template <class N>
std::optional<ComponentJets<N, 0>> value_in(const ClaimState<N>& state, const Expression& expression);

/// Whether both sides are equal in a state; nothing where one of them is not defined.
template <class N>
std::optional<bool> agree(const Equality& equality, const ClaimState<N>& state);

/// |left − right| relative to the larger of the two sides' sizes: of terms that cancel, the rounding error.
/// 0 if there is nothing but zeros; not finite where an operand is not.
double relative_residual(const ComponentJets<SizedNumber, 0>& left,
                         const ComponentJets<SizedNumber, 0>& right);

/// Both sides in doubles.
struct Sides {
  ComponentJets<SizedNumber, 0> left, right;  ///< components in space
  double residual = 0;                        ///< relative_residual
};
/// Nothing where one of them is not defined, or not finite.
std::optional<Sides> sides_of(const Equality& equality, const ClaimState<SizedNumber>& state);

}  // namespace polhode
