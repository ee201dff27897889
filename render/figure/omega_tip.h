// SPDX-License-Identifier: MIT
// Where the tip of ω is drawn, for a hand that takes it: now, and as it would be if the scene began with
// another ω.
#pragma once

#include "render/figure/camera.h"
#include "render/scene/model/model.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace polhode {

/// The tip in axes of the pane's view, scene units, and the pane's camera.
struct DrawnOmega {
  Vec3 tip_V{0, 0, 0};
  Camera camera;
};

/// Whether an arrow of the lesson's is this vector from the centre, at the scale that its overlay has.
inline bool is_as_overlay(const ArrowMark& arrow, Overlay vector) {
  return arrow.of.overlay == vector && !arrow.at && !arrow.length && !arrow.like;
}
/// Whether an arrow of the lesson's is this vector from the centre, whatever its length: its overlay would be
/// a second one on the same line.
inline bool has_arrow_along(const Scene& scene, Overlay vector) {
  return std::any_of(scene.marks.arrows.begin(), scene.marks.arrows.end(),
                     [vector](const ArrowMark& arrow) { return arrow.of.overlay == vector && !arrow.at; });
}
/// Whether an arrow of the lesson's is this vector as its overlay draws it.
bool draws_by_arrow(const SceneModel& model, Overlay vector);
/// Whether ω is drawn from the centre at the scale of a figure: by its overlay, or by an arrow of the
/// lesson's that is ω as it is.
bool draws_omega(const SceneModel& model);

/// In a pane (one for each view) of the figure of this width / height; as make_figure draws it. Nothing where
/// no ω is drawn.
std::optional<DrawnOmega> drawn_omega(const SceneModel& model, double t_s, std::size_t pane, double aspect);

/// Likewise the tips of arrows of the lesson's that are ω with a tail, a length or a scale of their own: no
/// hand takes ω by them.
std::vector<DrawnOmega> drawn_otherwise(const SceneModel& model, double t_s, std::size_t pane, double aspect);

/// The camera of a scene whose ω a hand takes: the frame stays, so that nothing but ω goes with the hand. It
/// is that of the motion that begins with the ω that it has been kept for, or the scene's.
CameraSpec held_by_hand(const Scene& scene);

/// Tries ω after ω without making models: what drawn_omega gives for the scene's model at t = 0 with this ω,
/// the camera held by hand and, if they are given, this attitude and this camera. About 1 µs each. It is made
/// at the cost of a model where only the motion knows what the frame is.
class TrialOmega {
 public:
  TrialOmega(const SceneModel& model, std::size_t pane, double aspect,
             const std::optional<AttitudeSpec>& attitude = std::nullopt,
             const std::optional<CameraSpec>& camera = std::nullopt);
  std::optional<DrawnOmega> at(const Vec3& w0_B);

 private:
  SceneModel trial_;  ///< no motion, no curves
  Camera camera_;
  std::size_t pane_;
};

}  // namespace polhode
