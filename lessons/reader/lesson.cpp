// SPDX-License-Identifier: MIT
#include "lessons/reader/lesson.h"

#include <algorithm>

namespace polhode {

const Stage* Lesson::find_stage(std::string_view stage_id) const {
  const auto found =
      std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.id == stage_id; });
  return found == stages.end() ? nullptr : &*found;
}

}  // namespace polhode
