// SPDX-License-Identifier: MIT
#include "physics/body/principal_moments.h"

#include "base/numbers.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace polhode {
namespace {

constexpr double kEps = 0x1p-53;
constexpr const char* kNoBody = ": no rigid body has these moments";

/// In six digits if it takes more.
std::string short_number(double x) {
  constexpr int kDigits = 6;
  const std::string all = shortest(x), rounded = digits(x, kDigits);
  return rounded.size() < all.size() ? rounded : all;
}

std::string symbol(int axis) { return "I" + std::to_string(axis + 1); }

// largest > b + c by more than 4ε of the sum; every operation but the last is exact (two-sum, Sterbenz).
bool exceeds_sum(double largest, double b, double c) {
  const double sum = b + c;
  const double b_part = sum - c;
  const double rounding = (b - b_part) + (c - (sum - b_part));
  return (largest - sum) - rounding > 4 * kEps * sum;
}

}  // namespace

std::optional<std::string> why_impossible(double I1, double I2, double I3) {
  const Vec3 I(I1, I2, I3);
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(I[i])) return symbol(i) + " = " + shortest(I[i]) + " is not finite" + kNoBody;
    if (!(I[i] > 0)) return symbol(i) + " = " + shortest(I[i]) + " is not positive" + kNoBody;
  }

  int i = 0;
  I.maxCoeff(&i);
  const int j = (i + 1) % 3 < (i + 2) % 3 ? (i + 1) % 3 : (i + 2) % 3;
  const int k = 3 - i - j;
  const int e = std::ilogb(I[i]);  // exact scaling: the sum can then neither overflow nor be subnormal
  if (!exceeds_sum(std::scalbn(I[i], -e), std::scalbn(I[j], -e), std::scalbn(I[k], -e))) return std::nullopt;
  const double sum = I[j] + I[k];
  const bool is_close = short_number(I[i]) == short_number(sum);
  const auto written = [&](double x) { return is_close ? shortest(x) : short_number(x); };
  return symbol(i) + " = " + written(I[i]) + " exceeds " + symbol(j) + " + " + symbol(k) + " = " +
         written(sum) + kNoBody + " (each must be at most the sum of the other two)";
}

PrincipalMoments::PrincipalMoments(double I1, double I2, double I3) : I_(I1, I2, I3) {
  if (const auto why = why_impossible(I1, I2, I3)) throw std::domain_error(*why);
}

}  // namespace polhode
