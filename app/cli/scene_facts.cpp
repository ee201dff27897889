// SPDX-License-Identifier: MIT
#include "app/cli/scene_facts.h"

#include "physics/analysis/characteristic_time.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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
  std::set<std::size_t> before;  // what the last step with a scene shows
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    if (!stage.steps[i].scene) continue;
    std::set<std::size_t> now;
    for (const Scene* scene : shown_scenes(*stage.steps[i].scene)) {
      const auto goes_on = [&](std::size_t k) {
        return is_same(all[k].problem, problem_of(*scene)) && all[k].body == scene->body;
      };
      const auto same = std::find_if(before.begin(), before.end(), goes_on);
      const std::size_t k = same != before.end() ? *same : all.size();
      if (k == all.size()) {
        all.push_back(facts_of(*scene));
        all.back().first_step = i + 1;
      }
      all[k].last_step = i + 1;
      now.insert(k);
      before.insert(k);  // scenes side by side may differ in their looks alone
    }
    before = std::move(now);
  }
  return all;
}

}  // namespace polhode
