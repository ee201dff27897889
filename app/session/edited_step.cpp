// SPDX-License-Identifier: MIT
#include "app/session/edited_step.h"

#include <algorithm>

namespace polhode {

std::optional<StepPlace> edited_step(const Lesson& before, const Lesson& after) {
  const std::string &old = before.source, &now = after.source;
  if (old == now) return std::nullopt;
  auto first = std::mismatch(now.begin(), now.end(), old.begin(), old.end()).first;
  // Empty lines before a new step belong to nothing: what is written behind them does.
  while (first != now.begin() && first != now.end() && first[-1] == '\n' && *first == '\n') ++first;
  const auto line = 1 + std::count(now.begin(), first, '\n');
  std::optional<StepPlace> edited;
  for (std::size_t stage = 0; stage < after.stages.size(); ++stage)
    for (std::size_t step = 0; step < after.stages[stage].steps.size(); ++step)
      if (after.stages[stage].steps[step].place.line <= line) edited = StepPlace{stage, step};
  return edited;
}

}  // namespace polhode
