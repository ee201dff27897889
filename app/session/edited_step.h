// SPDX-License-Identifier: MIT
// Where a lesson was edited.
#pragma once

#include "lessons/reader/lesson.h"

#include <optional>

namespace polhode {

/// The step with the first line in which a lesson differs from what it was. Nothing where they are the same,
/// or differ in the front matter first.
std::optional<StepPlace> edited_step(const Lesson& before, const Lesson& after);

}  // namespace polhode
