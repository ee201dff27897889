// SPDX-License-Identifier: MIT
// The step that the implicit midpoint rule and Moser-Veselov integrators share. With w the root of
// midpoint_equation.h for a_i = σ_i ω_i, g_i = ½ σ_i G_i and β = h²/4 or 0,
//
//     ω_i ← ω_i + G_i w_j w_k/α,   q ← q ⊗ (1, ½hw)/√(1 + |½hw|²) or q ⊗ exp(½hw),   α = 1 + β|w|².
//
//     implicit midpoint:  σ = 1,  G_i = h g_i,  β = 0: w is the mean of ω before and after
//     Moser-Veselov:      σ_i = s + e I_i,  G_i = h g_i s/(σ_j σ_k),  β = h²/4  (moser_veselov.h)
//
// with g_i = (I_j − I_k)/I_i. The increments of ω are summed with compensation (Kahan, Comm. ACM 8 (1965)
// 40): T and |L|, on which the period depends, then drift some ten times less; Vilmart, J. Comput. Phys. 227
// (2008) 7083-7093. Internal to physics/.
#pragma once

#include "physics/integrators/attitude_torque.h"
#include "physics/integrators/fixed_step_motion.h"
#include "physics/integrators/midpoint_equation.h"

namespace polhode {

struct MidpointCoefficients {
  double h;
  Triple sigma, G;
  MidpointEquation equation;
};

/// q ⊗ (1, v)/√(1 + |v|²): the rotation by 2 atan|v| about v.
struct CayleyAttitude {
  static Quadruple turned(const Quadruple& q, const Triple& v) {
    return (1.0 / std::sqrt(1.0 + dot(v, v))) * (q + product(q, v));
  }
};

/// q ⊗ exp(v): the rotation by 2|v| about v.
struct ExponentialAttitude {
  static Quadruple turned(const Quadruple& q, const Triple& v) {
    const double size = std::sqrt(dot(v, v));
    return size == 0 ? q : product(q, std::cos(size), (std::sin(size) / size) * v);
  }
};

struct MidpointState : StepState {  // v = ω_B
  Triple rest;                      // what rounding has taken from the sum of ω's increments
  Extrapolation roots;
};

/// Rule: coefficients(h, ω_B), which do not change along a free motion.
template <class Rule, class Attitude, class TorqueOnBody>
class MidpointStepper {
 public:
  using State = MidpointState;
  using Plan = MidpointCoefficients;

  MidpointStepper(const Problem& problem)
      : I_(triple(problem.I.vector())),
        start_w_B_(triple(problem.start.w_B)),
        rule_(problem.I),
        torque_(problem.torque) {}

  Plan plan(double h) const { return rule_.coefficients(h, start_w_B_); }

  State start(const RigidBodyState& state) const {
    State y;
    y.v = triple(state.w_B);
    y.q = quadruple(state.q_SB);
    return y;
  }

  Vec3 w_B(const State& y) const { return vec3(y.v); }

  void advance(State& y, const Plan& plan, std::int64_t n) const {
    if constexpr (TorqueOnBody::kActs) {
      Triple kick = half_kick(y.q, plan.h);
      for (; n > 0; --n) {
        add(y, kick);
        step(y, rule_.coefficients(plan.h, y.v));
        kick = half_kick(y.q, plan.h);
        add(y, kick);
      }
    } else {
      State local = y;
      // A copy that no store into `local` can be thought to change.
      const Plan fixed = plan;  // NOLINT(performance-unnecessary-copy-initialization)
      for (; n > 0; --n) step(local, fixed);
      y = local;
    }
  }

 private:
  static void step(State& y, const MidpointCoefficients& f) {
    const Triple a = times(f.sigma, y.v);
    const MidpointRoot root =
        y.roots.is_ready() ? root_near(f.equation, a, y.roots.next()) : root_from_scratch(f.equation, a);
    const Triple& w = root.w;
    add(y, (1.0 / (1.0 + f.equation.beta * dot(w, w))) * times(f.G, pairs(w, w)));
    y.q = Attitude::turned(y.q, (0.5 * f.h) * w);
    y.roots.add(w);
    y.evaluations += root.evaluations;
  }

  // Compensated: T and |L| then err by the rounding of the increments, some ten times less.
  static void add(State& y, const Triple& increment) {
    const Triple exact = increment + y.rest;
    const Triple sum = y.v + exact;
    y.rest = exact - (sum - y.v);
    y.v = sum;
  }

  Triple half_kick(const Quadruple& q, double h) const { return over((0.5 * h) * torque_.N_B(q), I_); }

  Triple I_, start_w_B_;
  Rule rule_;
  TorqueOnBody torque_;
};

}  // namespace polhode
