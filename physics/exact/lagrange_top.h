// SPDX-License-Identifier: MIT
// The heavy symmetric top, held at a point of its axis, in closed form: ω and attitude at any time, past or
// future, for the same price. Lagrange 1788, Jacobi 1849; Klein & Sommerfeld, The Theory of the Top, vol. II,
// ch. VI; Whittaker, Analytical Dynamics, 4th ed., §71-72; docs/numerics.md §2.6.
//
// Axis c of the body is that of symmetry, towards the centre of mass; (a, b, c) is right-handed. I1 = I_a =
// I_b, I3 = I_c, θ is the angle of axis c from the vertical, u = cosθ. With
//
//     γ = 2 mgl/I1,   α = I3 ω_c/I1,   P = (L_z + L_c)/I1,   Q = (L_z − L_c)/I1,
//     u̇² = (1 − u²)(E − γu) − (L_z/I1 − αu)² = γ (u − u1)(u − u2)(u − u3),   u1 ≤ u ≤ u2 ≤ 1 ≤ u3,
//     u = u1 + (u2 − u1) sn²(λt + const),   λ² = γ (u3 − u1)/4,   k² = (u2 − u1)/(u3 − u1).
//
// The attitude is that of the Cayley-Klein parameters, each of which is a single-valued function of time:
//
//     q_w + i q_c = √((1+u)/2) e^{i(φ+ψ)/2} = C e^{iρt}  θ_1(x − i y_P)/θ_4(x),
//     q_a + i q_b = √((1−u)/2) e^{i(φ−ψ)/2} = C' e^{iρ't} θ_2(x − i y_Q)/θ_4(x),
//     ω_a + i ω_b = C'' e^{i(ρ'−ρ)t} e^{±ix} θ_2(x − i y_E)/θ_4(x),
//
// x = π(λt + const)/2K: their zeros in complex time are where u = −1, u = 1, and where ω has no part across
// the axis. Integrals of the third kind are complete ones only, in ρ and ρ'. Close to the separatrix Jacobi's
// imaginary transformation gives series in the complementary nome, and on it hyperbolic functions. Roots are
// found in double-double from sums that do not cancel: so is the smallest nutation, and an axis that leaves
// the vertical by 10⁻¹⁰⁰.
#pragma once

#include "physics/body/problem.h"
#include "physics/exact/theta_series.h"
#include "physics/motion.h"

#include <array>
#include <complex>
#include <optional>
#include <string>

namespace polhode {

/// The axis and the weight of a top that this motion serves.
struct TopAxis {
  int axis = 2;     ///< of symmetry: 0, 1, 2
  double sign = 1;  ///< −1: the centre of mass lies on its negative side
  double mgl = 0;   ///< N m, ≥ 0
};
/// Why the body under this torque is no such top, or nothing if it is one: the torque must be weight alone
/// (HeavyTop, of which several add up), along a principal axis, and the moments across that axis equal. No
/// tolerance: equal is equal to the last bit.
std::optional<std::string> why_no_top(const PrincipalMoments& I, const Torque& torque);
/// @throws std::domain_error with why_no_top.
TopAxis top_axis(const PrincipalMoments& I, const Torque& torque);

/// What a top's motion is known by. θ is the angle of its axis, towards the centre of mass, from the
/// vertical.
struct TopFacts {
  double theta_least_rad = 0, theta_most_rad = 0;  ///< between which θ swings; equal: steady, or asleep
  /// 2K/λ, from one least θ to the next; infinite where the axis comes to rest upright, or rests there.
  double nutation_period_s = 0;
  /// What φ gains in a nutation, divided by its period, rad/s. Where the axis passes through the vertical, by
  /// which it gains half a turn either way, without that half turn.
  double mean_precession = 0;
  double mean_spin = 0;  ///< the same of ψ, rad/s
};

/// Invariant: why_no_top is empty. Also a top without weight, and a body that hangs.
class LagrangeTopMotion final : public Motion {
 public:
  /// Some 4 µs: the roots and the complete integrals.
  /// @throws std::domain_error if checked(Problem) does, and with why_no_top.
  explicit LagrangeTopMotion(const Problem& problem);

  /// |Δω|/|ω| and |Δq| ≤ 4ε(1 + cond), cond the condition number with respect to I1, I3, mgl and the given q,
  /// ω and t: about the angles turned in general, 1/δ |t|/period at relative distance δ from the separatrix.
  /// Energy, L_z and |q| within some ε at any t, ω_c exact: nothing accumulates. Results are the same to the
  /// bit under scaling of moments and weight, or of ω, 1/t and the root of the weight, by powers of two.
  /// at(0) is the start to the bit. Three sines and cosines, or two and an exponential.
  RigidBodyState at(double t_s) const override;
  std::string_view method() const override { return "lagrange-top"; }

  const TopFacts& facts() const { return facts_; }

  /// How the theta functions are summed; `rotation`: the axis rests in the vertical.
  enum class Series { rotation, in_nome, in_complementary_nome, separatrix };
  Series series() const { return f_.series; }

 private:
  using Complex = std::complex<double>;
  // θ_1 and θ_2 of x − iy in the nome: real and imaginary parts as polynomials; in the complementary nome
  // what depends on Y = π y/2y_max alone.
  struct Theta {
    ThetaSeries re{}, im{};
    double sin_Y2 = 0;                     // sin²Y
    Complex e1{1, 0}, e2{1, 0}, e4{1, 0};  // e^{iY}, e^{2iY}, e^{4iY}
  };
  // Rates in units of 2^e.
  struct Formula {
    Series series = Series::rotation;
    std::array<int, 3> axes{0, 1, 2};
    double sign = 1;                 // of the axes b and c
    Quat to_top = Quat::Identity();  // from (a, b, c) to the axes of the body
    double unit = 1;                 // 2^e
    double w_c = 0;
    double last_time = 0;            // beyond it the phase is lost, and time stands still
    double v0 = 0, v_rate = 0;       // half periods from the place of `from_top`; λt on the separatrix
    bool from_top = false;           // where x is measured from: u2, else u1; the nearer at the start
    double turn_P = 0, turn_Q = 0;   // ρ and ρ' in quarter turns
    double jump_P = 0, jump_Q = 0;   // at each half period, in_complementary_nome
    double X_per_v = 1;              // πK/K'
    double nome = 0, root_nome = 0;  // the complementary one
    // Multiples of x by which the series are turned: P and Q by −1, 1 or 0, so that they and their linear
    // phase do not turn against one another; E by what follows from that.
    double x_turn_P = 0, x_turn_Q = 0, x_turn_E = 1;
    Theta P{}, Q{}, E{};
    double C_P = 1, C_Q = 1, C_E = 0;  // amplitudes; C_E with its sign
    Complex start_P{1, 0}, start_Q{1, 0};
  };
  struct Shape;
  struct Setup;

  static Shape shape(const Formula& f, double v);

  RigidBodyState start_;
  Formula f_;
  TopFacts facts_;
};

}  // namespace polhode
