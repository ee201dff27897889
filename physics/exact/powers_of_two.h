// SPDX-License-Identifier: MIT
// Scaling by powers of two, which is exact: results are then the same to the bit at any scale.
#pragma once

#include "physics/body/types.h"

#include <cmath>

namespace polhode {

/// v·2^e, exact unless a component falls below the range of double.
inline Vec3 times_two_to(int e, const Vec3& v) {
  if (e == 0) return v;
  return {std::scalbn(v[0], e), std::scalbn(v[1], e), std::scalbn(v[2], e)};
}

/// e with 2^e ≤ max |v_i| < 2^(e+1); v ≠ 0.
inline int exponent_of(const Vec3& v) { return std::ilogb(v.cwiseAbs().maxCoeff()); }

/// |v|, whose squares leave the range of double no more than it does itself. To the bit v.norm() elsewhere.
inline double norm_of(const Vec3& v) {
  if (v.isZero(0.0) || !v.allFinite()) return v.norm();
  const int e = exponent_of(v);
  return std::scalbn(times_two_to(-e, v).norm(), e);
}

}  // namespace polhode
