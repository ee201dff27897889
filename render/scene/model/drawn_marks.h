// SPDX-License-Identifier: MIT
// What the marks of a scene (mark.h) come to on its motion: how long their vectors become, and what of them
// there is to see.
#pragma once

#include "physics/effort.h"
#include "render/scene/description/scene.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

struct SceneModel;

/// Whether the marks of a scene are drawn: where a body is turned by hand there is no motion for them.
bool draws_marks(const Scene& scene);

/// Whether earlier poses are drawn: where the body is seen to fly. About a centre at rest they would cover
/// one another.
bool draws_poses(const Scene& scene);

/// The angle of the arc from one vector to another, 0 to π, rad. Nothing where there is no arc to draw: one
/// of them is 0, or they are parallel.
std::optional<double> arc_between(const Vec3& a, const Vec3& b);

/// Whether they span a parallelogram: neither is 0, and they are not parallel.
bool span_area(const Vec3& a, const Vec3& b);

/// A vector over the model's span: at even times from 0 to the end, SI, components in space; NaN where it has
/// no value.
struct VectorCourse {
  std::vector<Vec3> values_S;
  double longest = 0.0;  ///< of those that have a value
};
/// By the fingerprint of the quantity.
using VectorCourses = std::map<std::string, VectorCourse>;
inline constexpr int kCourseSteps = 64;  ///< a picture's scale: nothing hangs on its last digits

/// Of all vectors of the marks.
VectorCourses vector_courses(const SceneModel& model, const Effort& effort);

/// What of the marks shows nothing over the span, and why: `the arrow of "N" shows nothing: N is 0
/// throughout`.
std::vector<std::string> unseen_marks(const SceneModel& model);

}  // namespace polhode
