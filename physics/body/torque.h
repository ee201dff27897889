// SPDX-License-Identifier: MIT
// Torque on the body, as a sum of terms; Goldstein, Classical Mechanics, 3rd ed., §5.5-5.7.
//
// The first four terms are external torques: dL/dt = N in S, dT/dt = N·ω. The last, EnergySink, is not a
// torque: no external torque acts, so L is constant in S, and friction inside the body turns T into heat.
//
// Why L can be constant while T falls: in a perfectly rigid body L̇_B = L_B×ω_B with ω_B = I⁻¹L_B keeps T. Let
// parts inside the body slip (a liquid, a damper), so that its principal axes turn with ω_B + s_B while L_B =
// I ω_B as before:
//
//     s_B = c (L_B×ω_B)/|L|,     L̇_B = L_B×(ω_B + s_B),     q̇_SB = ½ q_SB ⊗ (0, ω_B + s_B).
//
// Then L_S = R_SB L_B is constant, as a vector, because L_B is merely seen from axes that turn with ω + s;
// and Ṫ = ω·L̇ = −c |L×ω|²/|L| ≤ 0, zero only in steady rotation. For c > 0 every motion ends, but for
// unstable steady ones, in rotation about the axis of the largest moment (the major-axis rule). The body
// equation is the double-bracket dissipation of Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys.
// 175 (1996) 1-42, with the normalisation 1/|L|, which makes c a pure number: the decay per radian turned
// does not depend on the units or the size of the body. What it leaves out: the momentum of the slipping
// parts has no dynamics of its own (the "energy sink" of spacecraft dynamics, good for c ≪ 1), and q̇ = ½ q ω
// holds only up to the slip s.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/body/state.h"

#include <variant>
#include <vector>

namespace polhode {

/// N_S constant in space, N m.
struct SpaceTorque {
  Vec3 N_S = Vec3::Zero();
  bool operator==(const SpaceTorque&) const = default;
};
/// N_B constant in the body, N m.
struct BodyTorque {
  Vec3 N_B = Vec3::Zero();
  bool operator==(const BodyTorque&) const = default;
};
/// Gravity along −z of space on a body held at a point: N_S = (R_SB a_B) × (−mgr e_z). The moments are those
/// about that point. Keeps T + mgr e_z·R_SB a_B and L_Sz.
struct HeavyTop {
  double mgr = 0.0;             ///< weight times distance from the pivot to the centre of mass, N m
  Vec3 axis_B = Vec3::UnitZ();  ///< unit, from the pivot to the centre of mass; checked(Problem) sees to it
  bool operator==(const HeavyTop&) const = default;
};
/// N_B = −c ω_B: dT/dt = −c|ω|².
struct LinearDamping {
  double c = 0.0;  ///< N m s
  bool operator==(const LinearDamping&) const = default;
};
/// Friction inside the body at constant L in space; see the top of this file.
struct EnergySink {
  double c = 0.0;  ///< pure number, ≥ 0: slip s_B = c (L_B×ω_B)/|L|
  bool operator==(const EnergySink&) const = default;
};

using TorqueTerm = std::variant<SpaceTorque, BodyTorque, HeavyTop, LinearDamping, EnergySink>;
using Torque = std::vector<TorqueTerm>;  ///< empty: torque-free

/// Sum of the external torques at this state, N m, body components. An EnergySink is none and adds nothing.
Vec3 torque_B(const Torque& torque, const RigidBodyState& state);

/// s_B, rad/s: the rate at which the body's axes turn beyond ω_B = I⁻¹L_B. Zero without an EnergySink, and at
/// ω = 0. With it and torque_B the whole motion can be written down: L̇_B = N_B + L_B×(ω_B + s_B).
Vec3 slip_B(const Torque& torque, const PrincipalMoments& I, const Vec3& w_B);

/// Energy of the conservative terms, J: Σ mgr e_z·R_SB a_B over HeavyTop, zero at the pivot's height. T and
/// this together are what a heavy top keeps.
double potential_energy(const Torque& torque, const RigidBodyState& state);

/// True if the torque depends on the attitude (space, heavy): ω cannot then be integrated alone.
bool depends_on_attitude(const Torque& torque);

/// True if every number in it is finite.
bool is_finite(const Torque& torque);

}  // namespace polhode
