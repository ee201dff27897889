// SPDX-License-Identifier: MIT
// Bodies and states of small whole numbers, the simplest first. Internal to lessons/claims/.
#pragma once

#include "lessons/claims/claim_state.h"
#include "lessons/claims/proof/dependence.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace polhode {

using Whole = std::int64_t;
using Whole3 = std::array<Whole, 3>;

constexpr std::array<Whole, 7> kConstants{2, 3, 1, 5, -1, 4, 7};

/// What else there is; the eigenvalues of J lie between 6 and 12 (Gershgorin), so that it is possible.
struct OtherQuantities {
  std::array<Whole, 6> J;
  Whole3 v, dv, A, dA, F;
  Whole m, h, k;
  Whole3 ddv, ddA, dF;
};
struct WholeNumbers {
  Whole3 I, w, dw, ddw, N, dN;
  OtherQuantities other;
  std::array<Whole, 4> q;
  std::size_t first_constant = 0;  ///< its place in kConstants
};

template <class N>
StateNumbers<N> as(const WholeNumbers& whole) {
  StateNumbers<N> numbers;
  const auto copy = [](const auto& from, auto& into) {
    for (std::size_t i = 0; i < from.size(); ++i) into[i] = N(from[i]);
  };
  copy(whole.I, numbers.I);
  copy(whole.w, numbers.w);
  copy(whole.dw, numbers.dw);
  copy(whole.ddw, numbers.ddw);
  copy(whole.N, numbers.N_B);
  copy(whole.dN, numbers.dN_B);
  copy(whole.other.J, numbers.J);
  copy(whole.other.v, numbers.v_S);
  copy(whole.other.dv, numbers.dv_S);
  copy(whole.other.A, numbers.A_S);
  copy(whole.other.dA, numbers.dA_S);
  copy(whole.other.F, numbers.F_S);
  copy(whole.other.ddv, numbers.ddv_S);
  copy(whole.other.ddA, numbers.ddA_S);
  copy(whole.other.dF, numbers.dF_S);
  numbers.m = N(whole.other.m);
  numbers.h = N(whole.other.h);
  numbers.k = N(whole.other.k);
  copy(whole.q, numbers.q);
  for (std::size_t i = 0; i < kMaxConstants; ++i)
    numbers.constants[i] = N(kConstants[(whole.first_constant + i) % kConstants.size()]);
  return numbers;
}

/// Calls `use` with every combination that makes a difference until it returns true.
void for_each_whole_number_state(const Dependence& depends,
                                 const std::function<bool(const WholeNumbers&)>& use);

/// Every body and each of the other quantities, in one state that turns and has a torque.
std::vector<WholeNumbers> whole_number_bodies();

/// Small whole numbers of either sign, all of them at once.
WholeNumbers mixed_numbers(std::mt19937_64& random);

/// The same with numbers of very different sizes: for bodies as flat and as long as inequalities ask for.
WholeNumbers uneven_numbers(std::mt19937_64& random);

}  // namespace polhode
