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
struct SmallNumbers {
  Whole3 I, w, dw, ddw, N, dN;
  OtherQuantities other;
  std::array<Whole, 4> q;
  std::size_t first_constant = 0;  ///< its place in kConstants
};

template <class N>
StateNumbers<N> as(const SmallNumbers& small) {
  StateNumbers<N> numbers;
  const auto copy = [](const auto& from, auto& into) {
    for (std::size_t i = 0; i < from.size(); ++i) into[i] = N(from[i]);
  };
  copy(small.I, numbers.I);
  copy(small.w, numbers.w);
  copy(small.dw, numbers.dw);
  copy(small.ddw, numbers.ddw);
  copy(small.N, numbers.N_B);
  copy(small.dN, numbers.dN_B);
  copy(small.other.J, numbers.J);
  copy(small.other.v, numbers.v_S);
  copy(small.other.dv, numbers.dv_S);
  copy(small.other.A, numbers.A_S);
  copy(small.other.dA, numbers.dA_S);
  copy(small.other.F, numbers.F_S);
  copy(small.other.ddv, numbers.ddv_S);
  copy(small.other.ddA, numbers.ddA_S);
  copy(small.other.dF, numbers.dF_S);
  numbers.m = N(small.other.m);
  numbers.h = N(small.other.h);
  numbers.k = N(small.other.k);
  copy(small.q, numbers.q);
  for (std::size_t i = 0; i < kMaxConstants; ++i)
    numbers.constants[i] = N(kConstants[(small.first_constant + i) % kConstants.size()]);
  return numbers;
}

/// Calls `use` with every combination that makes a difference until it returns true.
void for_each_small_state(const Dependence& depends, const std::function<bool(const SmallNumbers&)>& use);

/// Every body and each of the other quantities, in one state that turns and has a torque.
std::vector<SmallNumbers> small_bodies();

/// Small whole numbers of either sign, all of them at once.
SmallNumbers mixed_numbers(std::mt19937_64& random);

/// The same with numbers of very different sizes: for bodies as flat and as long as inequalities ask for.
SmallNumbers uneven_numbers(std::mt19937_64& random);

}  // namespace polhode
