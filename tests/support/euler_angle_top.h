// SPDX-License-Identifier: MIT
// A heavy symmetric top in Euler's angles z-x-z, followed by classical Runge-Kutta steps: an independent way
// to what the program computes by quaternions and Euler's equations. Lagrange's equations (Goldstein, 3rd
// ed., §5.7) with a = I3 ω3/I1 and g = m g l/I1, ω3 constant:
//
//     θ̈ = φ̇² sinθ cosθ − a φ̇ sinθ + g sinθ,   φ̈ = (a − 2 φ̇ cosθ) θ̇/sinθ,   ψ̇ = ω3 − φ̇ cosθ.
#pragma once

#include <array>
#include <cmath>

namespace polhode::test {

struct EulerAngleTop {
  double I1, I3, mgl, w3;
  /// θ, φ, ψ, θ̇, φ̇
  using State = std::array<double, 5>;

  State rate(const State& y) const {
    const double s = std::sin(y[0]), c = std::cos(y[0]), a = I3 * w3 / I1, g = mgl / I1;
    return {y[3], y[4], w3 - y[4] * c, y[4] * y[4] * s * c - a * y[4] * s + g * s,
            (a - 2 * y[4] * c) * y[3] / s};
  }

  /// Error of the order of (|ω| h)⁴ |ω| t/120.
  State after(State y, double t_s, int steps) const {
    const double h = t_s / steps;
    const auto beside = [&](const State& k, double by) {
      State z = y;
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * k[i];
      return z;
    };
    for (int n = 0; n < steps; ++n) {
      const State k1 = rate(y), k2 = rate(beside(k1, h / 2)), k3 = rate(beside(k2, h / 2)),
                  k4 = rate(beside(k3, h));
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    return y;
  }
};

}  // namespace polhode::test
