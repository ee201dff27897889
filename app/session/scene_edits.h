// SPDX-License-Identifier: MIT
// What a student has changed of a step's scene by hand, apart from the scene itself: the lesson stays as it
// is, and one key gives it back.
#pragma once

#include "base/result.h"
#include "render/scene/description/scene.h"

#include <optional>
#include <vector>

namespace polhode {

/// What is absent is the lesson's.
struct SceneEdits {
  std::vector<double> numbers{};  ///< of the scene's `vary`, in their order; empty: the lesson's
  std::optional<Body> body{};
  std::optional<Vec3> w0_B{};  ///< rad/s at t = 0
  std::optional<AttitudeSpec> attitude{};
  std::optional<Torque> torque{};
  std::optional<MotionSpec> motion{};
  /// It shows a counterexample: the rate and duration of the lesson are not meant for it.
  bool is_counterexample = false;
  OverlaySet on{}, off{};  ///< shown, not shown, whatever the lesson says; disjoint
  std::optional<std::vector<View>> views{};
  std::optional<CameraSpec> camera{};
  std::optional<QualityLevel> quality{};

  bool empty() const { return *this == SceneEdits{}; }
  bool operator==(const SceneEdits&) const = default;
};

/// The scene with the edits in it. A caption speaks of the lesson's motion, its method, and what the lesson
/// shows of it from where: what has another, or hides some of it, has none; what shows more keeps it. ω and
/// the attitude of the lesson stay with another body; L keeps pointing down where the plane, which had it so,
/// is hidden. A body of a shape hangs on the pivot of the lesson's heavy torque, if there is one
/// (physics/body/pivot.h). A method that cannot serve the body or torque is left to make_model to refuse.
/// Scenes beside it are looked at as it is. One that shows the same start goes along with it: body, ω,
/// attitude and torque, and the method where that is the same too. Other motions are the lesson's, and so are
/// all beside a counterexample. Rate and duration of the lesson are not meant for an ω some hundred times
/// smaller or larger: one turn takes 4 s then.
/// @throws std::domain_error if the body cannot hang there
Scene edited(Scene scene, const SceneEdits& edits);

/// Whether a scene beside another one shows the same start, and so goes along with it.
bool starts_like(const Scene& scene, const Scene& other);

/// The camera of a scene beside another one, which is `shown` by a camera: that one too, so that what is
/// turned can be compared, unless it is the lesson's.
CameraSpec camera_beside(const CameraSpec& lesson_camera, const CameraSpec& own, const CameraSpec& shown);

/// Shows the overlay, or hides it. Where the lesson does so anyway, there is nothing left to edit.
void set_shown(SceneEdits& edits, const Scene& lesson_scene, Overlay overlay, bool is_shown);

/// A body known by these moments alone, kg m², or the inequality that forbids them.
Result<Body> body_with_moments(const Vec3& moments);

/// A camera that is about to be turned by hand: it keeps the scale at which it fills the picture now.
CameraSpec turned_from_here(CameraSpec camera);

/// The camera as a lesson can state it: angles in whole 1e-4°, azimuth within half a turn, the rest within
/// the format's bounds. What is on the screen can then be saved without moving by a hair.
CameraSpec writable(const CameraSpec& camera);

/// The attitude as a lesson states it, by components of few digits: at most 1e-12 rad beside the one given.
AttitudeSpec writable(const AttitudeSpec& attitude);

}  // namespace polhode
