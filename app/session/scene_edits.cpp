// SPDX-License-Identifier: MIT
#include "app/session/scene_edits.h"

#include "base/angles.h"
#include "lessons/reader/scene/scene_keys.h"
#include "lessons/reader/scene/scene_values.h"
#include "physics/body/pivot.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace polhode {

namespace {

/// A quotient of whole numbers, so that its decimals are few.
double whole_parts_of_degree(double angle_rad) {
  constexpr double kParts = 1e4;
  return std::round(angle_rad / kRadiansPerDegree * kParts) / kParts;
}

template <class T>
void replace(T& value, const std::optional<T>& edit) {
  if (edit) value = *edit;
}

Body or_throw(Result<Body> body) {
  if (!body) throw std::domain_error(body.error());
  return std::move(body).value();
}

template <class T>
bool leaves(const T& value, const std::optional<T>& edit) {
  return !edit || *edit == value;
}

bool includes(const std::vector<View>& views, const std::vector<View>& others) {
  return std::all_of(others.begin(), others.end(),
                     [&](View view) { return std::find(views.begin(), views.end(), view) != views.end(); });
}

/// A caption speaks of the lesson's motion as it is computed there, and of what is seen of it; nobody knows
/// whether it is true of another. What is shown besides makes nothing false: another view, a ghost, more
/// arrows; but with the plane comes another attitude, where none is stated.
bool may_keep_caption(const Scene& lesson, const SceneEdits& edits) {
  MotionSpec motion = edits.motion.value_or(lesson.motion);
  motion.ghost = motion.ghost && lesson.motion.ghost;
  const bool turns = edits.on.contains(Overlay::plane) && !lesson.attitude && !edits.attitude;
  const bool same_motion = leaves(lesson.body, edits.body) && leaves(lesson.w0_B, edits.w0_B) &&
                           leaves(attitude_spec(lesson), edits.attitude) &&
                           leaves(lesson.torque, edits.torque) && motion == lesson.motion && !turns;
  return same_motion && edits.off == OverlaySet{} &&
         includes(edits.views.value_or(lesson.views), lesson.views);
}

void show(OverlaySet& shown, const SceneEdits& edits) {
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    if (edits.on.contains(overlay)) shown.insert(overlay);
    if (edits.off.contains(overlay)) shown.erase(overlay);
  }
}

/// Of the edits those that change a scene beside another one: how it is looked at, and the motion too, as far
/// as it is the motion of that one, seen in another way.
SceneEdits edits_beside(const SceneEdits& edits, const Scene& scene, const Scene& other) {
  SceneEdits of_other = edits;
  of_other.is_counterexample = false;
  const bool same_start = starts_like(scene, other);
  if (!same_start || edits.is_counterexample) {
    of_other.body = {};
    of_other.w0_B = {};
    of_other.attitude = {};
    of_other.torque = {};
  }
  if (!same_start || edits.is_counterexample || other.motion != scene.motion) of_other.motion = {};
  return of_other;
}

/// A motion some hundred times slower or faster than the lesson's stands still at its rate, or flickers: one
/// turn takes some seconds then.
void keep_pace(Scene& scene, const Vec3& w_before) {
  constexpr double kOther = 100, kSeconds = 4, kTurns = 4;
  const double now = scene.w0_B.norm(), before = w_before.norm();
  if (!(now > 0) || !(before > 0) || (now < kOther * before && before < kOther * now)) return;
  const double turn_s = 2 * std::numbers::pi / now;
  scene.rate = turn_s / kSeconds;
  scene.duration_s = kTurns * turn_s;
}

}  // namespace

Scene edited(Scene scene, const SceneEdits& edits) {
  const bool keeps_caption = may_keep_caption(scene, edits);
  const CameraSpec lesson_camera = scene.camera;
  std::vector<SceneEdits> of_others;
  for (const Scene& other : scene.beside) of_others.push_back(edits_beside(edits, scene, other));
  if (!scene.attitude) {
    // The plane, shown or not, decides on an attitude that nobody stated. Hiding it does not turn the body
    // over; nor does showing it under a torque, which knows up from down: that would be another motion.
    const bool hides = scene.show.contains(Overlay::plane) && edits.off.contains(Overlay::plane);
    const bool shows = !scene.show.contains(Overlay::plane) && edits.on.contains(Overlay::plane);
    if (hides) scene.attitude = LPoints::down;
    if (shows && !scene.torque.empty()) scene.attitude = LPoints::up;
  }
  if (edits.attitude) scene.attitude = edits.attitude;
  replace(scene.torque, edits.torque);
  if (edits.is_counterexample) {
    scene.rate.reset();
    scene.duration_s.reset();
  }
  if (!keeps_caption) leave_out_caption(scene);
  if (edits.body) scene.body = or_throw(on_its_pivot(*edits.body, scene.torque));
  const Vec3 w_before = scene.w0_B;
  replace(scene.w0_B, edits.w0_B);
  if (!edits.is_counterexample) keep_pace(scene, w_before);
  replace(scene.motion, edits.motion);
  replace(scene.views, edits.views);
  replace(scene.camera, edits.camera);
  replace(scene.quality, edits.quality);
  show(scene.show, edits);
  for (std::size_t i = 0; i < scene.beside.size(); ++i) {
    Scene other = edited(scene.beside[i], of_others[i]);
    other.camera = camera_beside(lesson_camera, scene.beside[i].camera, scene.camera);
    scene.beside[i] = std::move(other);
  }
  return scene;
}

bool starts_like(const Scene& scene, const Scene& other) {
  return other.body == scene.body && other.w0_B == scene.w0_B && other.attitude == scene.attitude &&
         other.torque == scene.torque;
}

CameraSpec camera_beside(const CameraSpec& lesson_camera, const CameraSpec& own, const CameraSpec& shown) {
  CameraSpec turned = shown;
  if (auto& fitted = turned.fitted) {
    fitted->w0_B.reset();  // this and the attitude are the other scene's
    fitted->attitude.reset();
    const bool stands =
        fitted->azimuth_rad == turned.azimuth_rad && fitted->elevation_rad == turned.elevation_rad;
    if (stands) fitted.reset();
  }
  return turned == lesson_camera || turned == writable(lesson_camera) ? own : turned;
}

void set_shown(SceneEdits& edits, const Scene& lesson_scene, Overlay overlay, bool is_shown) {
  edits.on.erase(overlay);
  edits.off.erase(overlay);
  if (lesson_scene.show.contains(overlay) != is_shown) (is_shown ? edits.on : edits.off).insert(overlay);
}

Result<Body> body_with_moments(const Vec3& moments) {
  if (auto why = why_impossible(moments[0], moments[1], moments[2])) return failure(std::move(*why));
  return Body{"own-body", PrincipalMoments(moments[0], moments[1], moments[2]), std::nullopt};
}

CameraSpec turned_from_here(CameraSpec camera) {
  if (!camera.fitted) camera.fitted = CameraFit{camera.azimuth_rad, camera.elevation_rad};
  return camera;
}

CameraSpec writable(const CameraSpec& camera) {
  const auto writable_angles = [](const CameraFit& from) -> CameraFit {
    const double azimuth_deg = whole_parts_of_degree(std::remainder(from.azimuth_rad, 2 * std::numbers::pi));
    const double elevation_deg =
        std::clamp(whole_parts_of_degree(from.elevation_rad), -kMostElevationDeg, kMostElevationDeg);
    return {std::remainder(azimuth_deg, 360.0) * kRadiansPerDegree, elevation_deg * kRadiansPerDegree,
            from.w0_B, from.attitude ? std::optional(writable(*from.attitude)) : std::nullopt};
  };
  const CameraFit own = writable_angles({camera.azimuth_rad, camera.elevation_rad});
  CameraSpec made{own.azimuth_rad, own.elevation_rad,
                  std::clamp(camera.distance, kLeastCameraScale, kMostCameraScale),
                  std::clamp(camera.zoom, kLeastCameraScale, kMostCameraScale)};
  if (camera.fitted) made.fitted = writable_angles(*camera.fitted);
  made.holds_still = camera.holds_still;
  return made;
}

AttitudeSpec writable(const AttitudeSpec& attitude) {
  const Quat* q_SB = std::get_if<Quat>(&attitude);
  return q_SB ? attitude_from(wxyz_in_short(*q_SB)) : attitude;
}

}  // namespace polhode
