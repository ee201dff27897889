// SPDX-License-Identifier: MIT
#include "app/cli/scene_facts.h"

#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <set>
#include <utility>

namespace polhode {

namespace {

bool is_same(const Problem& a, const Problem& b) {
  return a.I == b.I && a.start.w_B == b.start.w_B && a.start.q_SB.coeffs() == b.start.q_SB.coeffs() &&
         a.torque == b.torque;
}

SceneFacts facts_of(const Scene& scene) {
  const Problem problem = problem_of(scene);
  return {motion_facts(problem), 1, 1, scene.body, problem};
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
