// SPDX-License-Identifier: MIT
// States of a body in which claims are tried, and what is assumed of its motion. Internal to lessons/.
#pragma once

#include "lessons/claims/evaluation.h"
#include "lessons/claims/given.h"

#include <optional>

namespace polhode {

/// What a state obeys. identity: nothing, ω̇, N, v̇, F vary freely. motion: Euler's equations with any N, and
/// m v̇ = F. free: the same with N = 0.
enum class Assumption { identity, motion, free };

/// The numbers that a state is made of, on the body axes unless the name says otherwise.
template <class N>
struct StateNumbers {
  std::array<N, 4> q{N(1), N(0), N(0), N(0)};  ///< w x y z, of any length but 0: body to space
  std::array<N, 3> I{};
  std::array<N, 6> J{};
  std::array<N, 3> w{}, dw{}, v_S{}, dv_S{}, A_S{}, dA_S{}, N_B{}, F_S{};
  N m{1};
  N h{1}, k{1};
  std::array<N, kMaxConstants> constants{};
};

/// Takes body components to space components: R(q) = homogeneous / |q|², with its rate.
template <class N>
std::array<Triple<N>, 3> attitude_matrix(const std::array<Dual<N>, 4>& q) {
  const auto& [w, x, y, z] = q;
  const Dual<N> scale = inverse(w * w + x * x + y * y + z * z);
  const auto twice = [](const Dual<N>& a) { return a + a; };
  const std::array<Triple<N>, 3> homogeneous{
      {{w * w + x * x - y * y - z * z, twice(x * y - w * z), twice(x * z + w * y)},
       {twice(x * y + w * z), w * w - x * x + y * y - z * z, twice(y * z - w * x)},
       {twice(x * z - w * y), twice(y * z + w * x), w * w - x * x - y * y + z * z}}};
  std::array<Triple<N>, 3> R;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) R[i][k] = scale * homogeneous[i][k];
  return R;
}

/// q̇ = ½ q ω.
template <class N>
std::array<Dual<N>, 4> turning(const std::array<N, 4>& q, const std::array<N, 3>& w_B) {
  const auto& [w, x, y, z] = q;
  const N half = inverse(N(2));
  return {{{w, -(half * (x * w_B[0] + y * w_B[1] + z * w_B[2]))},
           {x, half * (w * w_B[0] + y * w_B[2] - z * w_B[1])},
           {y, half * (w * w_B[1] + z * w_B[0] - x * w_B[2])},
           {z, half * (w * w_B[2] + x * w_B[1] - y * w_B[0])}}};
}

/// I ω̇ = N − ω×Iω, component by component: equations (7) to (9).
template <class N>
std::array<N, 3> euler_rate(const std::array<N, 3>& I, const std::array<N, 3>& w,
                            const std::array<N, 3>& torque_B) {
  return {inverse(I[0]) * (torque_B[0] - w[1] * w[2] * (I[2] - I[1])),
          inverse(I[1]) * (torque_B[1] - w[2] * w[0] * (I[0] - I[2])),
          inverse(I[2]) * (torque_B[2] - w[0] * w[1] * (I[1] - I[0]))};
}

/// The state of these numbers under an assumption, which overrules dw, dv_S and N_B. Precondition: q, I and m
/// are not zero.
template <class N>
ClaimState<N> state_of(StateNumbers<N> n, Assumption assumption) {
  if (assumption == Assumption::free) n.N_B = {N(0), N(0), N(0)};
  if (assumption != Assumption::identity) {
    n.dw = euler_rate(n.I, n.w, n.N_B);
    const N reciprocal = inverse(n.m);
    for (std::size_t i = 0; i < 3; ++i) n.dv_S[i] = reciprocal * n.F_S[i];
  }
  ClaimState<N> state;
  state.R = attitude_matrix(turning(n.q, n.w));
  state.I = n.I;
  state.J = n.J;
  state.N_B = n.N_B;
  state.F_S = n.F_S;
  state.m = n.m;
  state.h = n.h;
  state.k = n.k;
  state.constants = n.constants;
  for (std::size_t i = 0; i < 3; ++i) {
    state.w_B[i] = {n.w[i], n.dw[i]};
    state.v_S[i] = {n.v_S[i], n.dv_S[i]};
    state.A_S[i] = {n.A_S[i], n.dA_S[i]};
  }
  return state;
}

/// The numbers with those replaced that are given, one after the other. Nothing where one of them is not
/// defined, or a moment would be 0.
template <class N>
std::optional<StateNumbers<N>> with_given(StateNumbers<N> n, const Given& given);

/// Whether a body can have these moments: each is positive, and at most the sum of the other two.
bool is_possible_body(const std::array<SizedNumber, 3>& I);

/// Whether the two sides of each setting agree in a state, as far as `tolerance` of their terms.
bool holds_in(const Given& given, const ClaimState<SizedNumber>& state, double tolerance);

/// Whether both sides are equal in a state; nothing where one of them is not defined.
template <int Bits>
std::optional<bool> agree(const Equality& equality, const ClaimState<MersenneElement<Bits>>& state);

/// |left − right| relative to the larger of the two sides' sizes: of terms that cancel, the rounding error.
/// 0 if there is nothing but zeros; not finite where an operand is not.
double relative_residual(const Triple<SizedNumber>& left, const Triple<SizedNumber>& right);

/// Both sides in doubles.
struct Sides {
  Triple<SizedNumber> left, right;  ///< components in space
  double residual = 0;              ///< relative_residual
};
/// Nothing where one of them is not defined, or not finite.
std::optional<Sides> sides_of(const Equality& equality, const ClaimState<SizedNumber>& state);

}  // namespace polhode
