// SPDX-License-Identifier: MIT
// Torque that depends on attitude alone, in plain doubles: the kick of kick / free flow / kick. With ω at
// rest in q the kick L_B += h N_B(q_SB) is exact.
//
//     kick h/2, free flow h, kick h/2:   Strang, SIAM J. Numer. Anal. 5 (1968) 506-517; Hairer, Lubich &
//     Wanner, Geometric Numerical Integration, 2nd ed., §II.5 eq. (5.9).
//
// Order 2 whatever the order of the free flow; reversible if that is. The torque of gravity has no vertical
// component: L_z of a heavy top is kept to rounding, the energy to O(h²) without drift. Internal to physics/.
#pragma once

#include "physics/body/torque.h"
#include "physics/integrators/step_arithmetic.h"

#include <stdexcept>

namespace polhode {

class AttitudeTorque {
 public:
  static constexpr bool kActs = true;

  /// @throws std::domain_error if a term depends on ω.
  explicit AttitudeTorque(const Torque& torque) {
    for (const TorqueTerm& term : torque) add(term);
  }

  /// N_B at a unit q_SB.
  Triple N_B(const Quadruple& q) const {
    return in_body(q, N_S_) + N_B_ + cross(in_body(q, {0, 0, -1}), weight_B_);
  }

 private:
  void add(const TorqueTerm& term) {
    if (const auto* space = std::get_if<SpaceTorque>(&term))
      N_S_ = N_S_ + triple(space->N_S);
    else if (const auto* body = std::get_if<BodyTorque>(&term))
      N_B_ = N_B_ + triple(body->N_B);
    else if (const auto* top = std::get_if<HeavyTop>(&term))
      weight_B_ = weight_B_ - top->mgr * triple(top->axis_B);
    else
      throw std::domain_error("the torque must depend on attitude alone");
  }

  // R_SBᵀ v = v + 2 (s (v×u) + u×(u×v)) for q = (s, u).
  static Triple in_body(const Quadruple& q, const Triple& v_S) {
    const Triple u{q.x, q.y, q.z};
    const Triple c = 2.0 * cross(v_S, u);
    return v_S + q.s * c + cross(c, u);
  }

  Triple N_S_{0, 0, 0}, N_B_{0, 0, 0};
  Triple weight_B_{0, 0, 0};  // −Σ mgr a_B
};

/// Free motion: no kick.
class NoTorque {
 public:
  static constexpr bool kActs = false;
  explicit NoTorque(const Torque&) {}
};

}  // namespace polhode
