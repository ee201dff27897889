// SPDX-License-Identifier: MIT
// What a figure shows, in words, for readers who cannot see it.
#pragma once

#include "physics/body/state.h"
#include "render/scene/model/model.h"

#include <string>
#include <vector>

namespace polhode {

/// What is said of a scene in the words of its lesson (SpeechText): the caption (empty: none), and what its
/// marks are.
struct SceneInWords {
  std::string caption{};
  std::vector<std::string> marks{};
  /// A question is asked of it, whose answer may lie in what is computed: that is left out.
  bool is_asked = false;
};

/// Of a figure: the view, what is shown, its marks, the caption, and numbers computed for the moment of the
/// picture: |ω|, and the angle between ω and L where both are drawn. Plain text, UTF-8. Depends on the
/// arguments alone.
std::string alt_text(const Scene& scene, const SceneInWords& said, const Vec3& w_B, double t_s);

/// The same of all that the model shows side by side, one after the other. What is `said` is of each scene,
/// in their order.
std::string alt_text(const SceneModel& model, const std::vector<SceneInWords>& said, double t_s);

/// Of the pictures of one motion at several moments, the first of which is from_s and has the alternative
/// text above: what has changed since then. Seen from space, how far each axis of the body points away from
/// where it pointed; where ω is drawn, or else L, its components along the axes, of the first moment too.
std::string moment_in_words(const SceneModel& model, double from_s, double t_s);

}  // namespace polhode
