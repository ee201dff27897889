// SPDX-License-Identifier: MIT
#include "physics/body/torque.h"

#include "physics/body/euler.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

// N_B of one term. EnergySink is no torque.
struct TermTorque {
  const RigidBodyState& state;

  Vec3 operator()(const SpaceTorque& term) const { return state.q_SB.conjugate() * term.N_S; }
  Vec3 operator()(const BodyTorque& term) const { return term.N_B; }
  Vec3 operator()(const HeavyTop& term) const {
    const Vec3 weight_B = state.q_SB.conjugate() * Vec3(0, 0, -term.mgr);
    return term.axis_B.cross(weight_B);
  }
  Vec3 operator()(const LinearDamping& term) const { return -term.c * state.w_B; }
  Vec3 operator()(const EnergySink&) const { return Vec3::Zero(); }
};

struct TermIsFinite {
  bool operator()(const SpaceTorque& term) const { return term.N_S.allFinite(); }
  bool operator()(const BodyTorque& term) const { return term.N_B.allFinite(); }
  bool operator()(const HeavyTop& term) const { return std::isfinite(term.mgr) && term.axis_B.allFinite(); }
  bool operator()(const LinearDamping& term) const { return std::isfinite(term.c); }
  bool operator()(const EnergySink& term) const { return std::isfinite(term.c); }
};

}  // namespace

Vec3 torque_B(const Torque& torque, const RigidBodyState& state) {
  Vec3 N_B = Vec3::Zero();
  for (const TorqueTerm& term : torque) N_B += std::visit(TermTorque{state}, term);
  return N_B;
}

Vec3 slip_B(const Torque& torque, const PrincipalMoments& I, const Vec3& w_B) {
  double c = 0.0;
  for (const TorqueTerm& term : torque) {
    if (const auto* sink = std::get_if<EnergySink>(&term)) c += sink->c;
  }
  if (c == 0.0) return Vec3::Zero();

  const Vec3 L_B = angular_momentum_B(I, w_B);
  const double L = L_B.stableNorm();
  if (L == 0.0) return Vec3::Zero();
  return c * (L_B / L).cross(w_B);
}

double potential_energy(const Torque& torque, const RigidBodyState& state) {
  double V = 0.0;
  for (const TorqueTerm& term : torque) {
    if (const auto* top = std::get_if<HeavyTop>(&term)) V += top->mgr * (state.q_SB * top->axis_B).z();
  }
  return V;
}

bool depends_on_attitude(const Torque& torque) {
  return std::any_of(torque.begin(), torque.end(), [](const TorqueTerm& term) {
    return std::holds_alternative<SpaceTorque>(term) || std::holds_alternative<HeavyTop>(term);
  });
}

bool is_finite(const Torque& torque) {
  return std::all_of(torque.begin(), torque.end(),
                     [](const TorqueTerm& term) { return std::visit(TermIsFinite{}, term); });
}

}  // namespace polhode
