// SPDX-License-Identifier: MIT
#include "physics/analysis/motion_facts.h"

#include "physics/analysis/characteristic_time.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

bool is_gravity_alone(const Torque& torque) {
  return std::all_of(torque.begin(), torque.end(),
                     [](const TorqueTerm& term) { return std::holds_alternative<HeavyTop>(term); });
}

}  // namespace

MotionFacts motion_facts(const Problem& problem) {
  const RigidBodyState& start = problem.start;
  MotionFacts facts;
  facts.T = kinetic_energy(problem.I, start.w_B);
  facts.L = norm_of(angular_momentum_B(problem.I, start.w_B));
  facts.period_s = polhode_period(problem);
  if (problem.torque.empty()) facts.free = free_precession(problem.I, start.w_B);
  const auto top = symmetric_top(problem.I, problem.torque);
  if (!top || !is_gravity_alone(problem.torque)) return facts;
  const double cos_theta = std::clamp((start.q_SB * top->axis_B).z(), -1.0, 1.0);
  facts.theta_rad = std::acos(cos_theta);
  if (std::abs(cos_theta) < 1) facts.steady = steady_precession(*top, cos_theta, start.w_B.dot(top->axis_B));
  facts.nutation = nutation(*top, start);
  return facts;
}

}  // namespace polhode
