// SPDX-License-Identifier: MIT
// A double that knows how large the terms were which it is the sum of: what a residual is relative to.
#pragma once

#include <cmath>
#include <type_traits>

namespace polhode {

/// `size` is what `value` would be had every term been added with its absolute value: 1 − 1 is 0 of size 2.
/// Where a true zero is computed, value/size is the relative rounding error.
struct SizedNumber {
  double value = 0, size = 0;

  SizedNumber() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number> SizedNumber(Number its_value)  // a number is one: implicit
      : value(static_cast<double>(its_value)), size(std::abs(value)) {}
  SizedNumber(double number, double its_size) : value(number), size(its_size) {}

  bool is_zero() const { return value == 0; }

  friend SizedNumber operator+(SizedNumber a, SizedNumber b) { return {a.value + b.value, a.size + b.size}; }
  friend SizedNumber operator-(SizedNumber a, SizedNumber b) { return {a.value - b.value, a.size + b.size}; }
  friend SizedNumber operator-(SizedNumber a) { return {-a.value, a.size}; }
  friend SizedNumber operator*(SizedNumber a, SizedNumber b) { return {a.value * b.value, a.size * b.size}; }
};

/// The size of 1/a grows with the relative error that a may have.
inline SizedNumber inverse(SizedNumber a) { return {1.0 / a.value, a.size / (a.value * a.value)}; }

}  // namespace polhode
