// SPDX-License-Identifier: MIT
#include "physics/exact/double_double.h"

namespace polhode {

// asinh x = 2 asinh(x/√(2(1 + √(1 + x²)))), which squares no number that is not far below the range, until
// the series DLMF 4.38.1 has 18 terms: (1/8)³⁶ < u²/4.
DoubleDouble asinh(const DoubleDouble& x) {
  constexpr int kTerms = 18;
  DoubleDouble y = x;
  int halvings = 0;
  for (; abs(y) > 0.125; ++halvings) y /= sqrt(2 * (1 + sqrt(1 + y * y)));
  const DoubleDouble minus_y2 = -y * y;
  DoubleDouble term = y, sum = y;
  for (int n = 1; n < kTerms; ++n) {
    term *= minus_y2 * (2 * n - 1) / (2 * n);
    sum += term / (2 * n + 1);
  }
  return scalbn(sum, halvings);
}

}  // namespace polhode
