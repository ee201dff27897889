// SPDX-License-Identifier: MIT
// Arithmetic modulo the prime p = 2⁶¹ − 1, where equality is exact.
#pragma once

#include <cstdint>

namespace polhode {

inline constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;

/// A residue 0 … p − 1.
class FieldElement {
 public:
  constexpr FieldElement() = default;
  constexpr FieldElement(std::int64_t integer)  // a number is one: implicit
      : value_(integer >= 0 ? static_cast<std::uint64_t>(integer) % kPrime
                            : kPrime - 1 - static_cast<std::uint64_t>(-(integer + 1)) % kPrime) {}

  constexpr std::uint64_t value() const { return value_; }
  constexpr bool is_zero() const { return value_ == 0; }

  friend constexpr FieldElement operator+(FieldElement a, FieldElement b) {
    return from_below_2p(a.value_ + b.value_);
  }
  friend constexpr FieldElement operator-(FieldElement a, FieldElement b) {
    return from_below_2p(a.value_ + kPrime - b.value_);
  }
  friend constexpr FieldElement operator-(FieldElement a) { return FieldElement() - a; }
  friend constexpr FieldElement operator*(FieldElement a, FieldElement b) {
    const auto product = static_cast<Wide>(a.value_) * b.value_;
    // 2⁶¹ = 1: the upper bits are added to the lower ones.
    return from_below_2p(static_cast<std::uint64_t>(product & kPrime) +
                         static_cast<std::uint64_t>(product >> 61));
  }
  friend constexpr bool operator==(FieldElement a, FieldElement b) = default;

 private:
  __extension__ using Wide = unsigned __int128;

  static constexpr FieldElement from_below_2p(std::uint64_t sum) {
    FieldElement result;
    result.value_ = sum >= kPrime ? sum - kPrime : sum;
    return result;
  }

  std::uint64_t value_ = 0;
};

/// a^(p−2), by Fermat 1/a; about 120 products. Precondition: a is not zero.
constexpr FieldElement inverse(FieldElement a) {
  FieldElement result(1);
  for (std::uint64_t exponent = kPrime - 2; exponent != 0; exponent >>= 1) {
    if (exponent & 1) result = result * a;
    a = a * a;
  }
  return result;
}

}  // namespace polhode
