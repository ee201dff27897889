// SPDX-License-Identifier: MIT
// What a figure shows, in words, for readers who cannot see it.
#pragma once

#include "physics/body/state.h"
#include "render/scene/model/model.h"

#include <string>
#include <vector>

namespace polhode {

/// Of a figure: the view, what is shown, the caption in words (empty: none), and numbers computed for the
/// moment of the picture: |ω| and the angle between ω and L. Plain text, UTF-8. Depends on the arguments
/// alone.
std::string alt_text(const Scene& scene, const std::string& caption, const Vec3& w_B, double t_s);

/// The same of all that the model shows side by side, one after the other. `captions` are in the order in
/// which they stand, as many as scenes.
std::string alt_text(const SceneModel& model, const std::vector<std::string>& captions, double t_s);

}  // namespace polhode
