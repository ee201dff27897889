// SPDX-License-Identifier: MIT
// Arithmetic modulo the Mersenne primes 2⁶¹ − 1 and 2¹²⁷ − 1, where equality is exact.
#pragma once

#include <cstdint>
#include <type_traits>

namespace polhode {

/// A residue 0 … p − 1 modulo p = 2^Bits − 1; of 61 bits a product costs some 2 ns, of 127 some 8.
template <int Bits>
class MersenneElement {
  static_assert(Bits == 61 || Bits == 127);
  __extension__ using Wide = unsigned __int128;

 public:
  using Residue = std::conditional_t<Bits == 61, std::uint64_t, Wide>;
  static constexpr Residue kModulus = (Residue{1} << Bits) - 1;

  constexpr MersenneElement() = default;
  constexpr MersenneElement(std::int64_t integer)  // a number is one: implicit
      : value_(integer >= 0 ? static_cast<Residue>(integer) % kModulus
                            : kModulus - 1 - static_cast<Residue>(-(integer + 1)) % kModulus) {}

  constexpr Residue value() const { return value_; }
  constexpr bool is_zero() const { return value_ == 0; }

  friend constexpr MersenneElement operator+(MersenneElement a, MersenneElement b) {
    return from_below_2p(a.value_ + b.value_);
  }
  friend constexpr MersenneElement operator-(MersenneElement a, MersenneElement b) {
    return from_below_2p(a.value_ + kModulus - b.value_);
  }
  friend constexpr MersenneElement operator-(MersenneElement a) { return MersenneElement() - a; }
  friend constexpr MersenneElement operator*(MersenneElement a, MersenneElement b) {
    // 2^Bits = 1: the upper bits of a product are added to the lower ones.
    if constexpr (Bits == 61) {
      const Wide product = static_cast<Wide>(a.value_) * b.value_;
      return from_below_2p(static_cast<Residue>(product & kModulus) + static_cast<Residue>(product >> 61));
    } else {
      // (a₁ 2⁶⁴ + a₀)(b₁ 2⁶⁴ + b₀), and 2¹²⁸ = 2.
      const Wide a1 = a.value_ >> 64, a0 = static_cast<std::uint64_t>(a.value_);
      const Wide b1 = b.value_ >> 64, b0 = static_cast<std::uint64_t>(b.value_);
      const Wide upper = a1 * b1, middle = a1 * b0 + a0 * b1, lower = a0 * b0;
      const Wide middle_kept = (middle & ((Wide{1} << 63) - 1)) << 64;
      return from_below_2p(2 * upper) + from_below_2p(middle_kept + (middle >> 63)) +
             from_below_2p((lower & kModulus) + (lower >> 127));
    }
  }
  friend constexpr bool operator==(MersenneElement a, MersenneElement b) = default;

 private:
  static constexpr MersenneElement from_below_2p(Residue sum) {
    MersenneElement result;
    result.value_ = sum >= kModulus ? sum - kModulus : sum;
    return result;
  }

  Residue value_ = 0;
};

using FieldElement = MersenneElement<61>;
using WideFieldElement = MersenneElement<127>;
inline constexpr std::uint64_t kPrime = FieldElement::kModulus;

/// a^(p−2), by Fermat 1/a; about 2·Bits products. Precondition: a is not zero.
template <int Bits>
constexpr MersenneElement<Bits> inverse(MersenneElement<Bits> a) {
  MersenneElement<Bits> result(1);
  for (auto exponent = MersenneElement<Bits>::kModulus - 2; exponent != 0; exponent >>= 1) {
    if (exponent & 1) result = result * a;
    a = a * a;
  }
  return result;
}

}  // namespace polhode
