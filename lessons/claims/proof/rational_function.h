// SPDX-License-Identifier: MIT
// Exact quotients of polynomials in the numbers that a state is made of: where signs are proved, and where
// conditions are solved. Expressions are evaluated over them as over any other numbers (evaluation.h).
// Internal to lessons/claims/.
#pragma once

#include "lessons/claims/claim_state.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>

namespace polhode {

/// A number of StateNumbers, by its place in them.
using SymbolIndex = std::size_t;
inline constexpr std::size_t kSymbols = 4 + 3 + 6 + 13 * 3 + 3 + kMaxConstants;
/// The first of: the quaternion, moments, J, the vectors in the order of StateNumbers, m h k, constants.
namespace symbols {
inline constexpr SymbolIndex kAttitude = 0, kMoments = 4, kTensor = 7, kVectors = 13, kMass = 52,
                             kConstants = 55;
inline constexpr SymbolIndex kSpin = kVectors, kSpinRate = kVectors + 3, kVelocity = kVectors + 6,
                             kTorque = kVectors + 18, kForce = kVectors + 21;
}  // namespace symbols

/// Calls use(number) for each, in the order of symbols.
template <class Numbers, class Use>
void for_each_number(Numbers& n, const Use& use) {
  const auto all = [&use](auto& numbers) {
    for (auto& number : numbers) use(number);
  };
  all(n.q), all(n.I), all(n.J);
  for (auto* vector : {&n.w, &n.dw, &n.v_S, &n.dv_S, &n.A_S, &n.dA_S, &n.N_B, &n.F_S, &n.ddw, &n.ddv_S,
                       &n.ddA_S, &n.dN_B, &n.dF_S})
    all(*vector);
  use(n.m), use(n.h), use(n.k);
  all(n.constants);
}

/// What grows beyond kMostTermProducts or 127 bits. Thrown and caught within lessons/claims/.
struct BeyondAlgebra {};
/// Products and sums of two terms in one thread, between two calls of start_algebra(): some 5 ms.
inline constexpr int kMostTermProducts = 5'000;
void start_algebra();

/// A ratio of whole numbers, in lowest terms. All throw BeyondAlgebra where it grows too large.
class Ratio {
 public:
  __extension__ using Whole = __int128;
  Ratio(std::int64_t whole = 0) : above_(whole) {}  // a number is one: implicit
  Whole above() const { return above_; }
  Whole below() const { return below_; }  ///< positive
  int sign() const { return above_ > 0 ? 1 : above_ < 0 ? -1 : 0; }
  bool is_zero() const { return above_ == 0; }
  friend Ratio operator+(const Ratio& a, const Ratio& b);
  friend Ratio operator-(const Ratio& a);
  friend Ratio operator-(const Ratio& a, const Ratio& b) { return a + -b; }
  friend Ratio operator*(const Ratio& a, const Ratio& b);
  friend bool operator==(const Ratio& a, const Ratio& b) = default;
  Ratio reciprocal() const;  ///< precondition: it is not 0
  friend Ratio inverse(const Ratio& a) { return a.reciprocal(); }

 private:
  Ratio(Whole above, Whole below);
  Whole above_ = 0, below_ = 1;
};

/// Exponents of the symbols; they may be negative.
using Monomial = std::array<std::int8_t, kSymbols>;
Monomial times(const Monomial& a, const Monomial& b);

/// Σ c x^a …, no c is 0.
using Terms = std::map<Monomial, Ratio>;
Terms added(Terms a, const Terms& b, const Ratio& factor);
Terms multiplied(const Terms& a, const Terms& b);

/// above/below; below is 1, or has more than one term.
class RationalFunction {
 public:
  RationalFunction(std::int64_t number = 0);  // a number is one: implicit
  static RationalFunction of(SymbolIndex symbol);

  const Terms& above() const { return above_; }
  const Terms& below() const { return below_; }
  bool is_zero() const { return above_.empty(); }
  bool is_polynomial() const;  ///< but for negative exponents: below is 1

  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a);
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction inverse(const RationalFunction& a);  ///< precondition: it is not 0

 private:
  Terms above_, below_;
};

/// All numbers are symbols; the axes of body and space coincide unless `turned`.
StateNumbers<RationalFunction> symbolic_numbers(bool turned);

}  // namespace polhode
