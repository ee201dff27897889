// SPDX-License-Identifier: MIT
// What a figure shows, in words, for readers who cannot see it.
#pragma once

#include "physics/body/state.h"
#include "render/scene/model/model.h"

#include <array>
#include <string>
#include <vector>

namespace polhode {

/// What is said of a scene in the words of its lesson (SpeechText): the caption (empty: none), and what its
/// marks are.
struct SceneInWords {
  std::string caption{};
  std::vector<std::string> marks{};
  /// Of the axes of the body, "nose", where an arrow has other names for them; empty: none.
  std::array<std::string, 3> axes{};
  std::string body{};  ///< what the lesson calls the body in its text, "plate"; empty: nothing
  /// A question is asked of it, whose answer may lie in what is computed: that is left out, but for what the
  /// figure prints.
  bool is_asked = false;
};

/// Of a figure: the view, what is shown, its marks, the caption, and numbers computed for the moment of the
/// picture: |ω|, and the angle between ω and L where both are drawn. Plain text, UTF-8. Depends on the
/// arguments alone.
std::string alt_text(const Scene& scene, const SceneInWords& said, const Vec3& w_B, double t_s);

/// The same of all that the model shows side by side, one after the other, and the curves of plots of orders:
/// method, error and work at both ends, order. What is `said` is of each scene,
/// in their order.
std::string alt_text(const SceneModel& model, const std::vector<SceneInWords>& said, double t_s);

/// Of the pictures of one motion at several moments, from one instant to another, the first of which has the
/// alternative text above: what has changed since then, in as few numbers as tell it. Seen from space, how
/// often two axes of a symmetric top have gone round L where that is drawn and constant, or how far an axis
/// that a body has turned points away from where it pointed, and the arrow A, and how far its centre has
/// come; seen from the body, how often ω, or else L, has gone round an axis, or its components, of the first
/// moment too.
std::string moment_in_words(const SceneModel& model, const std::vector<SceneInWords>& said, double from_s,
                            double to_s, double t_s);

}  // namespace polhode
