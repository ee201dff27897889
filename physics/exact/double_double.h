// SPDX-License-Identifier: MIT
// Double-double numbers with an exponent of their own: about 106 bits, and no product leaves the range.
//
//     x = (hi + lo)·2^e,   1 ≤ |hi| < 2,   hi = the double nearest to hi + lo,
//
// so that every number has one representation. The sum hi + lo of two doubles that do not overlap is that of
// Dekker, Numer. Math. 18 (1971) 224-242, and of Hida, Li & Bailey, ARITH-15 (2001) 155-162. Because hi stays
// within [1, 2), error-free transformations can neither overflow nor underflow, and scaling by powers of two
// changes no digit. The price is to normalise after each operation: some integer instructions.
//
// Relative errors, u = 2⁻⁵³. JMP is Joldes, Muller & Popescu, ACM Trans. Math. Softw. 44 (2017) 15res.
//
//     x + y, x − y    3u² + 13u³    JMP, algorithm 6; also where they cancel, and x − y = 0 only if x = y
//     x y             5u²           JMP, algorithm 12
//     x/y             12u²          Dekker's, with the remainder of the leading quotient exact by fma
//     √x              5u²           Dekker's, with the remainder of the leading root exact by fma
//     asinh x         100u²         halved argument and series: some 3 µs
//
// A product of two doubles is exact, and so is the sum of two that are less than 2²⁰⁰ apart. The bounds of
// quotient and root are first-order sums: a remainder is at most 3u of x, it is rounded up to three times (u
// each), and divided by hi instead of hi + lo (u).
//
// Zero has no sign. There is no infinity: what is infinite or not a number, such as x/0 and √−1, is NaN, and
// so is all that is computed from it; no comparison with it holds. Exponents are ints, good for
// |log₂ x| < 2²⁷, not checked: a product of 10⁵ doubles.
//
// Costs one after the other, where std::fma is an instruction of the processor: product 12 ns, sum, quotient
// and root 20 ns. The results are the same to the bit on all machines of IEEE 754, if expressions are not
// contracted (-ffp-contract=off).
#pragma once

#include <Eigen/Core>

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <numbers>

namespace polhode {

class DoubleDouble {
 public:
  constexpr DoubleDouble() = default;

  /// Exact; also of a subnormal.
  constexpr DoubleDouble(double x) : DoubleDouble(normalised(x, 0.0, 0)) {}

  /// (hi + lo)·2^exponent; hi is the double nearest to hi + lo.
  static constexpr DoubleDouble of_parts(double hi, double lo, int exponent) {
    return normalised(hi, lo, exponent);
  }

  constexpr double hi() const { return hi_; }
  constexpr double lo() const { return lo_; }
  constexpr int exponent() const { return exponent_; }

  /// The nearest double, infinite beyond the range. Below 2⁻¹⁰²² a tie is decided by hi alone.
  explicit operator double() const { return std::scalbn(hi_, exponent_); }

  friend constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi_, -x.lo_, x.exponent_}; }

  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    return x.exponent_ >= y.exponent_ ? sum(x, y) : sum(y, x);
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

  friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const double product = x.hi_ * y.hi_, error = std::fma(x.hi_, y.hi_, -product);
    const double cross = std::fma(x.lo_, y.hi_, std::fma(x.hi_, y.lo_, x.lo_ * y.lo_));
    return rounded(product, error + cross, x.exponent_ + y.exponent_);
  }

  friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.hi_ / y.hi_;
    const double remainder = std::fma(-quotient, y.hi_, x.hi_) + std::fma(-quotient, y.lo_, x.lo_);
    return rounded(quotient, remainder / y.hi_, x.exponent_ - y.exponent_);
  }

  friend DoubleDouble sqrt(const DoubleDouble& x) {
    if (x.hi_ == 0) return x;
    const double unit = (x.exponent_ & 1) == 0 ? 1.0 : 2.0;  // an even exponent is left
    const double hi = unit * x.hi_, lo = unit * x.lo_, root = std::sqrt(hi);
    const double remainder = std::fma(-root, root, hi) + lo;
    return rounded(root, remainder / (2 * root), x.exponent_ >> 1);
  }

  friend DoubleDouble& operator+=(DoubleDouble& x, const DoubleDouble& y) { return x = x + y; }
  friend DoubleDouble& operator-=(DoubleDouble& x, const DoubleDouble& y) { return x = x - y; }
  friend DoubleDouble& operator*=(DoubleDouble& x, const DoubleDouble& y) { return x = x * y; }
  friend DoubleDouble& operator/=(DoubleDouble& x, const DoubleDouble& y) { return x = x / y; }

  friend constexpr bool operator==(const DoubleDouble& x, const DoubleDouble& y) { return (x - y).hi_ == 0; }
  friend constexpr std::partial_ordering operator<=>(const DoubleDouble& x, const DoubleDouble& y) {
    return (x - y).hi_ <=> 0.0;
  }

  friend constexpr DoubleDouble abs(const DoubleDouble& x) { return x.hi_ < 0 ? -x : x; }

  /// x·2^n, exact.
  friend constexpr DoubleDouble scalbn(const DoubleDouble& x, int n) {
    return normalised(x.hi_, x.lo_, x.exponent_ + n);
  }

  /// e with 2^e ≤ |hi|·2^e < 2^(e+1), |hi| as in hi(): that of |x| but for an |x| within u of a power of two.
  friend constexpr int ilogb(const DoubleDouble& x) { return x.exponent_; }

  friend DoubleDouble asinh(const DoubleDouble& x);

 private:
  // Of zero and NaN the exponent is such that a sum with any other number is that number, and NaN.
  static constexpr int kZero = -(1 << 28), kNaN = 1 << 28;

  constexpr DoubleDouble(double hi, double lo, int exponent) : hi_(hi), lo_(lo), exponent_(exponent) {}

  static constexpr double power_of_two(int e) {  // −1022 ≤ e ≤ 1023
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  }

  // Of hi the nearest double to hi + lo.
  static constexpr DoubleDouble normalised(double hi, double lo, int exponent) {
    constexpr int kBias = 1023, kFirst = 64, kLast = 2000;  // biased exponents that need no care
    const int biased = static_cast<int>(std::bit_cast<std::uint64_t>(hi) >> 52) & 0x7ff;
    if (biased < kFirst || biased > kLast) return normalised_with_care(hi, lo, exponent);
    const double unit = power_of_two(kBias - biased);
    return {hi * unit, lo * unit, exponent + biased - kBias};
  }

  // Zero, NaN, infinity, and doubles at the ends of the range.
  static constexpr DoubleDouble normalised_with_care(double hi, double lo, int exponent) {
    if (hi == 0) return {};
    if (!(hi - hi == 0)) return {std::numeric_limits<double>::quiet_NaN(), 0.0, kNaN};
    const bool is_small = -1 < hi && hi < 1;
    const double unit = is_small ? 0x1p128 : 0x1p-128;
    return normalised(hi * unit, lo * unit, is_small ? exponent - 128 : exponent + 128);
  }

  // |lo| no larger than |hi|, or hi = 0: Dekker's fast two-sum.
  static constexpr DoubleDouble rounded(double hi, double lo, int exponent) {
    const double sum = hi + lo;
    return normalised(sum, lo - (sum - hi), exponent);
  }

  // Of x with the larger exponent.
  static constexpr DoubleDouble sum(const DoubleDouble& x, const DoubleDouble& y) {
    constexpr int kNegligible = 200;
    const int gap = x.exponent_ - y.exponent_;
    if (gap > kNegligible) return x;
    const double unit = power_of_two(-gap), y_hi = y.hi_ * unit, y_lo = y.lo_ * unit;
    const double hi = x.hi_ + y_hi, lo = x.lo_ + y_lo;
    const double middle = error_of_sum(x.hi_, y_hi, hi) + lo;
    const double larger = hi + middle, smaller = error_of_sum(x.lo_, y_lo, lo) + (middle - (larger - hi));
    return rounded(larger, smaller, x.exponent_);
  }

  // Knuth's two-sum: x + y − sum, exact.
  static constexpr double error_of_sum(double x, double y, double sum) {
    const double y_part = sum - x;
    return (x - (sum - y_part)) + (y - y_part);
  }

  double hi_ = 0, lo_ = 0;
  int exponent_ = kZero;
};

}  // namespace polhode

/// π to 107 bits: the two doubles are the leading ones of π/2.
template <>
inline constexpr polhode::DoubleDouble std::numbers::pi_v<polhode::DoubleDouble> =
    polhode::DoubleDouble::of_parts(0x1.921fb54442d18p0, 0x1.1a62633145c07p-54, 1);

/// Vectors of them. A vector's norm is the root of the sum of its squares, none of which leaves the range.
template <>
struct Eigen::NumTraits<polhode::DoubleDouble> : Eigen::GenericNumTraits<polhode::DoubleDouble> {
  enum { IsSigned = 1, RequireInitialization = 1, AddCost = 20, MulCost = 15 };
};
