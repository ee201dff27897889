// SPDX-License-Identifier: MIT
// The three principal moments of inertia of a rigid body.
#pragma once

#include "physics/body/types.h"

#include <optional>
#include <string>

namespace polhode {

/// Why no rigid body has these principal moments (kg m²), or nothing if one has: each must be finite and > 0,
/// and the largest at most the sum of the others, I3 = ∫(x²+y²) dm ≤ ∫(y²+z²) dm + ∫(x²+z²) dm = I1 + I2
/// (Goldstein, Classical Mechanics, 3rd ed., §5.3). The sum may fall short by 4ε relative (ε = 2⁻⁵³), because
/// decimal input such as 0.1, 0.7, 0.8 rounds; the moments are then used as given. The text names the
/// inequality.
std::optional<std::string> why_impossible(double I1, double I2, double I3);

/// Invariant: why_impossible(I1, I2, I3) is empty. Any order of the axes.
class PrincipalMoments {
 public:
  /// @throws std::domain_error with the text of why_impossible.
  PrincipalMoments(double I1, double I2, double I3);

  double operator[](int axis) const { return I_[axis]; }
  const Vec3& vector() const { return I_; }

  bool operator==(const PrincipalMoments& other) const { return I_ == other.I_; }

 private:
  Vec3 I_;  // kg m²
};

}  // namespace polhode
