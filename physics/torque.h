// SPDX-License-Identifier: MIT
// External torque on the body, as a sum of terms.
#pragma once

#include <variant>
#include <vector>

#include "physics/principal_moments.h"
#include "physics/state.h"

namespace polhode {

/// N_S constant in space, N m.
struct SpaceTorque {
  Vec3 N_S;
};
/// N_B constant in the body, N m.
struct BodyTorque {
  Vec3 N_B;
};
/// Gravity along −z of space on a body held at a point: N_S = (R_SB a_B) × (−mgr e_z).
struct HeavyTop {
  double mgr;     ///< weight times distance from the pivot to the centre of mass, N m
  Vec3 axis_B;    ///< unit, from the pivot to the centre of mass
};
/// N_B = −c ω_B.
struct LinearDamping {
  double c;  ///< N m s
};
/// Dissipation that keeps L in space... N is zero in S; see euler.h for how it enters. N_B = c (ω×L)×L / ... .
struct EnergySink {
  double c;
};

using TorqueTerm = std::variant<SpaceTorque, BodyTorque, HeavyTop, LinearDamping, EnergySink>;
using Torque = std::vector<TorqueTerm>;  ///< empty: torque-free

/// Sum of the terms at this state, N m, body components.
Vec3 torque_B(const Torque& torque, const PrincipalMoments& I, const RigidBodyState& state);

/// True if the torque depends on the attitude (space, heavy): ω cannot then be integrated alone.
bool depends_on_attitude(const Torque& torque);

}  // namespace polhode
