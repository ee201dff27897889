// SPDX-License-Identifier: MIT
// What a picture shows, in words, for readers who cannot see it.
#pragma once

#include "lessons/lesson.h"
#include "physics/state.h"

#include <string>

namespace polhode {

/// The stage's title, the view, what is shown, the scene's caption, and numbers computed for the moment of
/// the picture: |ω| and the angle between ω and L. Plain text, UTF-8. Depends on the arguments alone.
std::string alt_text(const Stage& stage, const Scene& scene, const Vec3& w_B, double t_s);

}  // namespace polhode
