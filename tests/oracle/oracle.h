// SPDX-License-Identifier: MIT
// Whether an equality holds, by symbolic algebra: derived anew, so that a slip in lessons/ is not made twice.
//
// Body and space axes coincide at the moment t = 0 at which all is decided, and to second order
// R(t) = 1 + t[ω]× + t²/2([ω̇]× + [ω]×²);
// every operation of the language turns with its vectors, and v, A, F and their rates are free, so that what
// holds in this attitude for all of them holds in every one; the axes of space are any such triad, which does
// not turn. Rates are taken by differentiating what has been written out in symbols: no dual numbers. A
// motion is chosen by its ω̇ and v̇, and N = Iω̇ + ω×Iω, F = m v̇ follow, so that nothing is divided by; without
// torque ω̇ is what makes that N zero.
#pragma once

#include "lessons/claims/claim_state.h"

#include <ginac/ginac.h>

#include <array>
#include <random>
#include <vector>

namespace polhode::oracle {

enum class Decision { same, different, undefined };

class Oracle {
 public:
  using Vector = std::array<GiNaC::ex, 3>;

  /// One side, written out in symbols; of a scalar the first component.
  struct Side {
    Vector value;
    std::vector<GiNaC::ex> divisors;  ///< what is divided by on the way
    bool defined = true;
  };

  /// What is given is put in, one after the other; a torque that is given makes the motion, not the other way
  /// round.
  explicit Oracle(LawsAssumed assumption, const Given& given = {});

  Side side(const Expression& expression) const;

  /// Evaluates at random rational points first: where the sides differ, exactly, they are different. Where
  /// they agree at all kPoints it is proved: by expanding, which brings polynomials in the symbols and their
  /// reciprocals to one form, and with other divisors by normal(). Above kLargest terms of the degree a proof
  /// would take too long; then `by_points` counts one, and it errs with a probability below (d/2⁴⁰)^kPoints,
  /// d ≤ 10⁴.
  Decision compare(const Side& left, const Side& right) const;
  Decision compare(const Equality& equality) const {
    return compare(side(equality.left), side(equality.right));
  }

  /// Whether sides agree through ε^order, as is given: by rational functions of ε alone. At random rational
  /// points each component of left − right is brought to one fraction P/Q of polynomials in ε, and the least
  /// powers of ε in P and Q are counted: no series are expanded. `are_zero`: neither side has a term through
  /// ε^order.
  Decision compare_to_order(const Equality& equality, bool& are_zero) const;

  static constexpr int kPoints = 4;
  static constexpr std::size_t kLargest = 20000;
  int proofs() const { return proofs_; }
  int by_points() const { return by_points_; }

 private:
  Vector rate(const Vector& moving, bool goes_on) const;
  Vector axis(std::size_t i, bool moving) const;
  Vector in_space(const Vector& on_body_axes, bool moving) const;
  bool is_zero(const GiNaC::ex& difference, bool has_divisors) const;
  GiNaC::exmap random_point() const;
  Vector value(const Expression& expression, int index, bool moving, Side& side) const;
  Vector quantity(Quantity quantity, bool moving) const;
  void set(const Setting& setting);

  GiNaC::symbol t_, small_;
  int order_ = 0;  ///< of what is small
  std::vector<GiNaC::symbol> free_;
  Vector gyroscopic() const;
  Vector rate_of_gyroscopic() const;
  void set_rates(const Setting& setting);

  Vector I_, w_, dw_, ddw_, N_, dN_, v_, dv_, ddv_, A_, dA_, ddA_, F_, dF_;
  std::array<Vector, 3> space_;  ///< the axes of space, by a quaternion: they stand still
  GiNaC::ex length2_;            ///< of that quaternion, squared
  std::array<GiNaC::ex, 6> J_;
  GiNaC::ex m_, h_, k_;
  std::array<GiNaC::ex, kMaxConstants> constants_;
  mutable bool twice_ = false;  ///< second rates are asked for: t² is kept
  mutable std::mt19937_64 random_{1};
  mutable int proofs_ = 0, by_points_ = 0;
};

}  // namespace polhode::oracle
