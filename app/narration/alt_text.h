// SPDX-License-Identifier: MIT
// What a figure shows, in words, for readers who cannot see it.
#pragma once

#include "physics/body/state.h"
#include "render/scene/description/scene.h"

#include <string>
#include <vector>

namespace polhode {

/// Of a figure: the view, what is shown with its marks in words (SpeechText), the caption in words (empty:
/// none), and numbers computed for the moment of the picture: |ω| and the angle between ω and L. Plain text,
/// UTF-8. Depends on the arguments alone.
std::string alt_text(const Scene& scene, const std::vector<std::string>& marks, const std::string& caption,
                     const Vec3& w_B, double t_s);

}  // namespace polhode
