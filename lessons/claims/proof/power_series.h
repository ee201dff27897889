// SPDX-License-Identifier: MIT
// Series in one small number ε, cut off: what an expression is where some quantities are small.
//
// A series is Σ c_i ε^(f+i), i = 0 … n − 1, and an unknown rest of order ε^(f+n); f may be negative, so that
// what is divided by something small is a series too. All operations are those of formal Laurent series over
// a field N and keep what can be known of the result and nothing else (Knuth, The Art of Computer
// Programming 2, 3rd ed., §4.7: product (3), reciprocal by (2)):
//   (a + b)_k = a_k + b_k,  (a b)_k = Σ a_i b_(k−i),  (1/a)_0 = 1/a_0,  (1/a)_k = −1/a_0 Σ_(i ≥ 1) a_i
//   (1/a)_(k−i).
// Over residues modulo a prime or ratios, coefficients are exact.
//
// At most kTerms coefficients are kept, from the first one that is not 0 on, as digits of a floating-point
// number are. Where leading terms cancel, fewer are left: end() says how far the series is known, and nothing
// is ever taken for 0 beyond it. A sum costs 8 additions, a product and a reciprocal at most 36 products;
// those with a coefficient 0 are left out, so that numbers without ε cost hardly more than N itself.
// Internal to lessons/claims/.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace polhode {

template <class N>
class PowerSeries {
 public:
  /// Enough for the fourth order (small orders are at most that) where three leading terms cancel.
  static constexpr int kTerms = 8;
  /// Known to all orders: of the exact 0.
  static constexpr int kExact = 1 << 20;

  PowerSeries() = default;                                    ///< exactly 0
  PowerSeries(std::int64_t whole) : PowerSeries(N(whole)) {}  // a number is one: implicit
  /// number·ε^exponent
  explicit PowerSeries(const N& number, int exponent = 0) {
    if (number.is_zero()) return;
    first_ = exponent;
    count_ = kTerms;
    c_[0] = number;
  }

  /// The exponent of the first term that is not 0; without one end().
  int first() const { return first_; }
  /// Nothing is known of this power of ε and those beyond it.
  int end() const { return first_ + count_; }
  /// Of ε^exponent. Precondition: exponent < end().
  N coefficient(int exponent) const { return exponent < first_ ? N(0) : c_[place(exponent - first_)]; }
  /// No term is known that is not 0: whether it is 0 is known of an exact one alone.
  bool is_zero() const { return count_ == 0; }

  friend PowerSeries operator+(const PowerSeries& a, const PowerSeries& b) {
    if (a.first_ == kExact) return b;
    if (b.first_ == kExact) return a;
    PowerSeries sum;
    sum.first_ = std::min(a.first_, b.first_);
    sum.count_ = std::min(std::min(a.end(), b.end()) - sum.first_, kTerms);
    for (const PowerSeries* x : {&a, &b})
      for (int i = 0; i < x->count_ && x->first_ + i < sum.end(); ++i) {
        N& into = sum.c_[place(x->first_ + i - sum.first_)];
        if (!x->c_[place(i)].is_zero()) into = into + x->c_[place(i)];
      }
    sum.drop_zeros();
    return sum;
  }
  friend PowerSeries operator-(const PowerSeries& a) {
    PowerSeries negative = a;
    for (int i = 0; i < a.count_; ++i) negative.c_[place(i)] = -a.c_[place(i)];
    return negative;
  }
  friend PowerSeries operator-(const PowerSeries& a, const PowerSeries& b) { return a + -b; }

  friend PowerSeries operator*(const PowerSeries& a, const PowerSeries& b) {
    PowerSeries product;
    if (a.first_ == kExact || b.first_ == kExact) return product;
    product.first_ = a.first_ + b.first_;
    product.count_ = std::min(a.count_, b.count_);
    for (int i = 0; i < product.count_; ++i) {
      if (a.c_[place(i)].is_zero()) continue;
      for (int k = 0; i + k < product.count_; ++k)
        if (!b.c_[place(k)].is_zero())
          product.c_[place(i + k)] = product.c_[place(i + k)] + a.c_[place(i)] * b.c_[place(k)];
    }
    return product;
  }

  /// Precondition: it is not is_zero().
  friend PowerSeries inverse(const PowerSeries& a) {
    PowerSeries reciprocal;
    reciprocal.first_ = -a.first_;
    reciprocal.count_ = a.count_;
    const N leading = inverse(a.c_[0]);
    reciprocal.c_[0] = leading;
    for (int k = 1; k < a.count_; ++k) {
      N sum(0);
      for (int i = 1; i <= k; ++i)
        if (!a.c_[place(i)].is_zero() && !reciprocal.c_[place(k - i)].is_zero())
          sum = sum + a.c_[place(i)] * reciprocal.c_[place(k - i)];
      if (!sum.is_zero()) reciprocal.c_[place(k)] = -(leading * sum);
    }
    return reciprocal;
  }

 private:
  static constexpr std::size_t place(int i) { return static_cast<std::size_t>(i); }

  /// So that the first coefficient is none.
  void drop_zeros() {
    int zeros = 0;
    while (zeros < count_ && c_[place(zeros)].is_zero()) ++zeros;
    if (zeros == 0) return;
    std::move(c_.begin() + zeros, c_.begin() + count_, c_.begin());
    std::fill(c_.begin() + (count_ - zeros), c_.begin() + count_, N(0));
    first_ += zeros;
    count_ -= zeros;
  }

  int first_ = kExact, count_ = 0;
  std::array<N, kTerms> c_{};
};

}  // namespace polhode
