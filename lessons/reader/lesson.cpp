// SPDX-License-Identifier: MIT
#include "lessons/reader/lesson.h"

#include "base/spelling.h"

#include <algorithm>

namespace polhode {

const Stage* Lesson::find_stage(std::string_view stage_id) const {
  const auto found =
      std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.id == stage_id; });
  return found == stages.end() ? nullptr : &*found;
}

Result<const Stage*> Lesson::stage_named(std::string_view stage_id) const {
  if (const Stage* stage = find_stage(stage_id)) return stage;
  std::vector<std::string> known;
  for (const Stage& stage : stages) known.push_back(stage.id);
  return failure("lesson \"" + id + "\" has no stage \"" + std::string(stage_id) + "\"" +
                 did_you_mean(stage_id, known));
}

std::vector<const Equation*> equations_of(const Stage& stage) {
  std::vector<const Equation*> all;
  for (const Step& step : stage.steps) {
    const auto more = blocks_of<Equation>(step);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace polhode
