// SPDX-License-Identifier: MIT
#include "app/narration/still_numbers.h"

#include <algorithm>

namespace polhode {

bool have_one_caption(const std::vector<const Scene*>& shown) {
  const Scene& first = *shown.front();
  const bool has_number =
      first.caption.find("\\live") != std::string::npos || first.caption.find("\\value") != std::string::npos;
  return (!first.label.empty() || !has_number) &&
         std::all_of(shown.begin(), shown.end(),
                     [&](const Scene* scene) { return scene->caption == first.caption; });
}

const StillNumbers::Values& StillNumbers::of(const Lesson& lesson, const Step& step) {
  return of_caption(lesson, step, step.scene ? step.scene->before : 0);
}

const StillNumbers::Values& StillNumbers::of_caption(const Lesson& lesson, const Step& step,
                                                     std::size_t shown) {
  const auto known = known_.find({&step, shown});
  if (known != known_.end()) return known->second;
  return known_.emplace(std::pair(&step, shown), computed(lesson, step, shown)).first->second;
}

StillNumbers::Values StillNumbers::computed(const Lesson& lesson, const Step& step, std::size_t shown) const {
  if (!step.scene) return {};
  std::vector<int> ids;
  if (shown == step.scene->before) ids = numbers_in(step);
  if (const RichText* caption = caption_of(step, shown))
    for (const int id : numbers_in(*caption)) ids.push_back(id);
  Values values = values_in_tables(lesson.numbers, ids, effort_);
  std::erase_if(ids, [&](int id) { return lesson.numbers[static_cast<std::size_t>(id)].row != nullptr; });
  if (ids.empty()) return values;
  const Scene& scene = *shown_scenes(*step.scene)[shown];
  const std::optional<LiveState> live =
      live_state(make_model(scene, ModelFor::numbers, effort_), still_time_s(*step.scene));
  for (const int id : ids)
    if (const auto value =
            live ? value_of(lesson.numbers[static_cast<std::size_t>(id)], *live) : std::nullopt)
      values.emplace(id, *value);
  return values;
}

}  // namespace polhode
