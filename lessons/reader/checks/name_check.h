// SPDX-License-Identifier: MIT
// Whether the plots, arrows and angles of a scene are named as what they show.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/lesson.h"

#include <vector>

namespace polhode {

/// An error for each name that its author gave, and that is that of another quantity on the scene's motion: a
/// curve of T as E, an arrow of L as ω. What has no name of its own, and a vector that the lesson defines,
/// may be called by that of what it stands for, such as what a method comes to in one step. An arrow is as
/// long as its author likes: its direction counts. Some µs a name.
void check_names(const Lesson& lesson, const SceneModel& model, SourcePlace place, Report& report);

/// Whether a scene gives such names.
bool has_names(const Scene& scene);

}  // namespace polhode
