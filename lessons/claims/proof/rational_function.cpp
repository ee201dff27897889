// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/rational_function.h"

#include <limits>
#include <numeric>
#include <utility>

namespace polhode {
namespace {

using Whole = Ratio::Whole;

thread_local int products_left = kMostTermProducts;

Whole product_of(Whole a, Whole b) {
  Whole product = 0;
  if (__builtin_mul_overflow(a, b, &product)) throw BeyondAlgebra();
  return product;
}

Whole greatest_divisor(Whole a, Whole b) {
  while (b != 0) a = std::exchange(b, a % b);
  return a < 0 ? -a : a;
}

const Terms& one() {
  static const Terms kOne{{Monomial{}, Ratio(1)}};
  return kOne;
}

}  // namespace

void start_algebra() { products_left = kMostTermProducts; }

Ratio::Ratio(Whole above, Whole below) {
  const Whole divisor = greatest_divisor(above, below);
  above_ = above / divisor;
  below_ = below / divisor;
  if (below_ < 0) above_ = product_of(above_, -1), below_ = product_of(below_, -1);
}

Ratio operator+(const Ratio& a, const Ratio& b) {
  Whole sum = 0;
  if (__builtin_add_overflow(product_of(a.above_, b.below_), product_of(b.above_, a.below_), &sum))
    throw BeyondAlgebra();
  return {sum, product_of(a.below_, b.below_)};
}

Ratio operator-(const Ratio& a) { return {product_of(a.above_, -1), a.below_}; }

Ratio operator*(const Ratio& a, const Ratio& b) {
  return {product_of(a.above_, b.above_), product_of(a.below_, b.below_)};
}

Ratio Ratio::reciprocal() const { return {below_, above_}; }

Monomial times(const Monomial& a, const Monomial& b) {
  Monomial product;
  for (std::size_t i = 0; i < kSymbols; ++i) {
    const int exponent = a[i] + b[i];
    if (std::abs(exponent) > std::numeric_limits<std::int8_t>::max()) throw BeyondAlgebra();
    product[i] = static_cast<std::int8_t>(exponent);
  }
  return product;
}

Terms added(Terms a, const Terms& b, const Ratio& factor) {
  for (const auto& [monomial, coefficient] : b) {
    if (--products_left < 0) throw BeyondAlgebra();
    Ratio& sum = a[monomial];
    sum = sum + coefficient * factor;
    if (sum.sign() == 0) a.erase(monomial);
  }
  return a;
}

Terms multiplied(const Terms& a, const Terms& b) {
  Terms product;
  for (const auto& [monomial, coefficient] : a)
    for (const auto& [other, factor] : b) {
      if (--products_left < 0) throw BeyondAlgebra();
      const Monomial at = times(monomial, other);
      Ratio& sum = product[at];
      sum = sum + coefficient * factor;
      if (sum.sign() == 0) product.erase(at);
    }
  return product;
}

RationalFunction::RationalFunction(std::int64_t number) : below_(one()) {
  if (number != 0) above_.emplace(Monomial{}, Ratio(number));
}

RationalFunction RationalFunction::of(SymbolIndex symbol) {
  RationalFunction x;
  Monomial monomial{};
  monomial[symbol] = 1;
  x.above_.emplace(monomial, Ratio(1));
  return x;
}

bool RationalFunction::is_polynomial() const { return below_ == one(); }

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  RationalFunction sum;
  if (a.below_ == b.below_) {
    sum.above_ = added(a.above_, b.above_, 1);
    sum.below_ = a.below_;
  } else {
    sum.above_ = added(multiplied(a.above_, b.below_), multiplied(b.above_, a.below_), 1);
    sum.below_ = multiplied(a.below_, b.below_);
  }
  if (sum.above_.empty()) sum.below_ = one();
  return sum;
}

RationalFunction operator-(const RationalFunction& a) {
  RationalFunction negative = a;
  for (auto& [monomial, coefficient] : negative.above_) coefficient = -coefficient;
  return negative;
}

RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) { return a + -b; }

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  RationalFunction product;
  if (a.is_zero() || b.is_zero()) return product;
  product.above_ = multiplied(a.above_, b.above_);
  product.below_ = a.is_polynomial()   ? b.below_
                   : b.is_polynomial() ? a.below_
                                       : multiplied(a.below_, b.below_);
  return product;
}

RationalFunction inverse(const RationalFunction& a) {
  RationalFunction reciprocal;
  if (a.above_.size() > 1) {
    reciprocal.above_ = a.below_;
    reciprocal.below_ = a.above_;
    return reciprocal;
  }
  const auto& [monomial, coefficient] = *a.above_.begin();
  Monomial negative;
  for (std::size_t i = 0; i < kSymbols; ++i) negative[i] = static_cast<std::int8_t>(-monomial[i]);
  reciprocal.above_ = multiplied(a.below_, {{negative, coefficient.reciprocal()}});
  return reciprocal;
}

StateNumbers<RationalFunction> symbolic_numbers(bool turned) {
  StateNumbers<RationalFunction> numbers;
  SymbolIndex next = 0;
  for_each_number(numbers, [&next](RationalFunction& number) { number = RationalFunction::of(next++); });
  if (!turned) numbers.q = {1, 0, 0, 0};
  return numbers;
}

}  // namespace polhode
