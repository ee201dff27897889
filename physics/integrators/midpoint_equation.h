// SPDX-License-Identifier: MIT
// The implicit equation of the implicit midpoint rule and of Moser-Veselov's discrete body, one quadratic
// equation for the mean angular velocity w of a step:
//
//     w = (1 + β|w|²) a + g∘(w_y w_z, w_z w_x, w_x w_y)
//
// (∘ by components.) Let F(w) be the left side less the right, and J its Jacobian at a guess p. Being
// quadratic, F(p + δ) = F(p) + J δ − Q(δ) exactly, with Q(δ) = β|δ|² a + g∘(δ_y δ_z, …). So one residual and
// one Jacobian give the root w = p + δ: δ ← J⁻¹(Q(δ) − F(p)), from δ = −J⁻¹ F(p), gains as many digits per
// round as the guess has. The guess extrapolates the steps before; without them, or if it is poor, it is
// Newton's method from a. Internal to physics/.
#pragma once

#include "physics/integrators/fixed_step_motion.h"

#include <array>
#include <limits>

namespace polhode {

struct MidpointEquation {
  Triple g;
  double beta;
};

struct MidpointRoot {
  Triple w;  ///< NaN if none was found
  int evaluations;
};

namespace midpoint_detail {

// −F(w).
inline Triple residual(const MidpointEquation& eq, const Triple& a, const Triple& w) {
  return (1.0 + eq.beta * dot(w, w)) * a + times(eq.g, pairs(w, w)) - w;
}

inline Triple quadratic(const MidpointEquation& eq, const Triple& a, const Triple& d) {
  return (eq.beta * dot(d, d)) * a + times(eq.g, pairs(d, d));
}

// J⁻¹ of J = 1 − 2β a wᵀ − g∘(0 w_z w_y; w_z 0 w_x; w_y w_x 0), by cofactors.
class InverseJacobian {
 public:
  InverseJacobian(const MidpointEquation& eq, const Triple& a, const Triple& w) {
    const Triple b = (2.0 * eq.beta) * a;
    const Triple& g = eq.g;
    const Triple r1{1.0 - b.x * w.x, -b.x * w.y - g.x * w.z, -b.x * w.z - g.x * w.y};
    const Triple r2{-b.y * w.x - g.y * w.z, 1.0 - b.y * w.y, -b.y * w.z - g.y * w.x};
    const Triple r3{-b.z * w.x - g.z * w.y, -b.z * w.y - g.z * w.x, 1.0 - b.z * w.z};
    c1_ = cross(r2, r3);
    c2_ = cross(r3, r1);
    c3_ = cross(r1, r2);
    const double f = 1.0 / dot(r1, c1_);
    c1_ = f * c1_;
    c2_ = f * c2_;
    c3_ = f * c3_;
  }

  Triple operator*(const Triple& v) const { return v.x * c1_ + v.y * c2_ + v.z * c3_; }

  /// The determinant has overflowed: no step it gives means anything.
  bool is_zero() const { return size(c1_) + size(c2_) + size(c3_) == 0; }

 private:
  Triple c1_, c2_, c3_;  // columns
};

}  // namespace midpoint_detail

/// Newton's method from w = a. It gives up after 60 rounds.
inline MidpointRoot root_from_scratch(const MidpointEquation& eq, const Triple& a) {
  constexpr int kMostRounds = 60;
  constexpr double kNearEnough = 0x1p-28;  // its square is below rounding
  Triple w = a;
  for (int i = 1; i <= kMostRounds; ++i) {
    const midpoint_detail::InverseJacobian inverse(eq, a, w);
    if (inverse.is_zero()) break;
    const Triple step = inverse * midpoint_detail::residual(eq, a, w);
    w = w + step;
    if (size(step) <= kNearEnough * size(w)) return {w, i};
    if (!is_finite(w)) break;
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  return {{kNaN, kNaN, kNaN}, kMostRounds};
}

/// From a guess; from scratch if the guess is a poor one.
inline MidpointRoot root_near(const MidpointEquation& eq, const Triple& a, const Triple& guess) {
  constexpr int kMostRounds = 6;
  constexpr double kRounding = 0x1p-55;
  const midpoint_detail::InverseJacobian inverse(eq, a, guess);
  const Triple first = inverse * midpoint_detail::residual(eq, a, guess);
  const double size_of_guess = size(guess);
  if (size(first) <= 0.125 * size_of_guess) {
    Triple d = first;
    Triple q_before{0, 0, 0};
    for (int i = 1; i <= kMostRounds; ++i) {
      const Triple q = midpoint_detail::quadratic(eq, a, d);
      if (size(q - q_before) <= kRounding * size_of_guess) return {guess + d, i};
      d = first + inverse * q;
      q_before = q;
    }
  }
  const MidpointRoot root = root_from_scratch(eq, a);
  return {root.w, root.evaluations + kMostRounds};
}

/// The roots of the steps before, extrapolated to the next by the polynomial through them.
class Extrapolation {
 public:
  bool is_ready() const { return known_ == kPoints; }

  Triple next() const {
    return 7.0 * (past_[0] - past_[5]) - 21.0 * (past_[1] - past_[4]) + 35.0 * (past_[2] - past_[3]) +
           past_[6];
  }

  void add(const Triple& w) {
    for (std::size_t i = kPoints - 1; i > 0; --i) past_[i] = past_[i - 1];
    past_[0] = w;
    if (known_ < kPoints) ++known_;
  }

 private:
  static constexpr std::size_t kPoints = 7;
  std::array<Triple, kPoints> past_{};
  std::size_t known_ = 0;
};

}  // namespace polhode
