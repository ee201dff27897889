// SPDX-License-Identifier: MIT
#include "app/cli/scene_facts.h"

#include "physics/analysis/characteristic_time.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

bool is_same(const Problem& a, const Problem& b) {
  return a.I == b.I && a.start.w_B == b.start.w_B && a.start.q_SB.coeffs() == b.start.q_SB.coeffs() &&
         a.torque == b.torque;
}

bool is_gravity_alone(const Torque& torque) {
  return std::all_of(torque.begin(), torque.end(),
                     [](const TorqueTerm& term) { return std::holds_alternative<HeavyTop>(term); });
}

SceneFacts facts_of(const Scene& scene) {
  const Problem problem = problem_of(scene);
  const RigidBodyState& start = problem.start;
  SceneFacts facts{.body = scene.body, .problem = problem};
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

}  // namespace

std::vector<SceneFacts> facts_of(const Stage& stage) {
  std::vector<SceneFacts> all;
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    const auto& scene = stage.steps[i].scene;
    if (!scene) continue;
    if (all.empty() || !is_same(all.back().problem, problem_of(*scene)) || all.back().body != scene->body) {
      all.push_back(facts_of(*scene));
      all.back().first_step = i + 1;
    }
    all.back().last_step = i + 1;
  }
  return all;
}

}  // namespace polhode
