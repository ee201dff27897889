// SPDX-License-Identifier: MIT
// A scene as an author would write it: what was made by hand in the window becomes a lesson.
#pragma once

#include "app/companion/companion.h"

#include <string>

namespace polhode {

/// The keys of a ```scene block, without the fence: all that differs from Scene{}, numbers with as many
/// digits as give the same double; at = t_s. Reading it back gives the same scene, so that its picture has
/// the same pixels.
std::string scene_keys_of(const Scene& scene, double t_s);

/// A whole lesson of one stage and one step that `polhode export` reads: front matter with the lesson's
/// symbols, macros and the scene's body, the title and text of the present step, its equations and claims,
/// and the scene.
std::string lesson_of(const Companion& companion);

/// As `polhode trace --format csv`: of the present motion, over the interval of the time line, with a line
/// for each frame shown.
std::string trace_of(const Companion& companion);

}  // namespace polhode
