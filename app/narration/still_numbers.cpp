// SPDX-License-Identifier: MIT
#include "app/narration/still_numbers.h"

namespace polhode {

const StillNumbers::Values& StillNumbers::of(const Lesson& lesson, const Step& step) {
  const auto known = known_.find(&step);
  return known != known_.end() ? known->second : known_.emplace(&step, computed(lesson, step)).first->second;
}

StillNumbers::Values StillNumbers::computed(const Lesson& lesson, const Step& step) const {
  std::vector<int> ids = numbers_in(step);
  if (step.caption)
    for (const int id : numbers_in(*step.caption)) ids.push_back(id);
  if (!step.scene || ids.empty()) return {};
  const std::optional<LiveState> live =
      live_state(make_model(*step.scene, Product::numbers, effort_), still_time_s(*step.scene));
  Values values;
  for (const int id : ids)
    if (const auto value =
            live ? value_of(lesson.numbers[static_cast<std::size_t>(id)], *live) : std::nullopt)
      values.emplace(id, *value);
  return values;
}

}  // namespace polhode
