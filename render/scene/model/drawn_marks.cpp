// SPDX-License-Identifier: MIT
#include "render/scene/model/drawn_marks.h"

#include "base/angles.h"
#include "render/scene/model/model.h"
#include "render/scene/model/translation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace polhode {
namespace {

template <class Take>
void for_each_vector(const Marks& marks, const Take& take) {
  const auto take_if = [&](const std::optional<MarkVector>& vector) {
    if (vector) take(*vector);
  };
  for (const TrailMark& trail : marks.trails) take(trail.of);
  for (const ArrowMark& arrow : marks.arrows) {
    take(arrow.of);
    take_if(arrow.at);
    take_if(arrow.like);
  }
  for (const AngleMark& angle : marks.angles) {
    take(angle.from);
    take(angle.to);
    take_if(angle.at);
  }
  for (const AreaMark& area : marks.areas) {
    take(area.from);
    take(area.to);
  }
  for (const LineMark& line : marks.lines) {
    take(line.from);
    take(line.to);
  }
  for (const PlaneMark& plane : marks.planes) {
    take(plane.normal);
    take_if(plane.through);
  }
  for (const NoteMark& note : marks.notes) take(note.at);
}

class Unseen {
 public:
  explicit Unseen(const SceneModel& model) : model_(model) {}

  /// Whether nothing is to be seen for want of this vector.
  bool says_why(const std::string& what, const MarkVector& vector, bool may_be_zero = false) {
    const VectorCourse& course = model_.courses.at(vector.quantity.fingerprint);
    const bool has_value = std::any_of(course.values_S.begin(), course.values_S.end(),
                                       [](const Vec3& value_S) { return value_S.allFinite(); });
    if (has_value && (may_be_zero || course.longest > 0.0)) return false;
    found_.push_back(what + " shows nothing: " + quoted(vector) +
                     (has_value ? " is 0 throughout" : " has no value on this motion"));
    return true;
  }

  void angle(const AngleMark& mark) {
    const std::string what = "the angle from " + quoted(mark.from) + " to " + quoted(mark.to);
    if (says_why(what, mark.from) || says_why(what, mark.to)) return;
    if (mark.at && says_why(what, *mark.at, true)) return;
    const std::vector<Vec3>&from_S = model_.courses.at(mark.from.quantity.fingerprint).values_S,
          &to_S = model_.courses.at(mark.to.quantity.fingerprint).values_S;
    for (std::size_t n = 0; n < from_S.size(); ++n)
      if (from_S[n].allFinite() && to_S[n].allFinite() && arc_between(from_S[n], to_S[n])) return;
    found_.push_back(what + " shows nothing: they are parallel throughout, or within 0.6° of it");
  }

  void area(const AreaMark& mark) {
    const std::string what = "the area from " + quoted(mark.from) + " to " + quoted(mark.to);
    if (says_why(what, mark.from) || says_why(what, mark.to)) return;
    const std::vector<Vec3>&from_S = model_.courses.at(mark.from.quantity.fingerprint).values_S,
          &to_S = model_.courses.at(mark.to.quantity.fingerprint).values_S;
    for (std::size_t n = 0; n < from_S.size(); ++n)
      if (from_S[n].allFinite() && to_S[n].allFinite() && span_area(from_S[n], to_S[n])) return;
    found_.push_back(what + " shows nothing: they are parallel throughout");
  }

  std::string quoted(const MarkVector& vector) const { return '"' + vector.quantity.text + '"'; }
  std::vector<std::string> take() { return std::move(found_); }

 private:
  const SceneModel& model_;
  std::vector<std::string> found_;
};

}  // namespace

std::optional<double> arc_between(const Vec3& a, const Vec3& b) {
  constexpr double kLeast = 0.01;  // rad, 0.6°: an arc that is shorter than its line is thick
  if (a.isZero(0.0) || b.isZero(0.0)) return std::nullopt;
  const Vec3 u = a.stableNormalized(), v = b.stableNormalized();
  const double angle_rad = angle_between(u, v);
  constexpr double kNoPlane = 1e-6;  // of opposite vectors
  const bool is_seen = angle_rad >= kLeast && u.cross(v).norm() > kNoPlane;
  return is_seen ? std::optional(angle_rad) : std::nullopt;
}

bool span_area(const Vec3& a, const Vec3& b) {
  constexpr double kLeast = 1e-6;  // the sine of their angle
  return !a.isZero(0.0) && !b.isZero(0.0) && a.stableNormalized().cross(b.stableNormalized()).norm() > kLeast;
}

bool draws_marks(const Scene& scene) {
  return !scene.marks.empty() && !scene.show.contains(Overlay::turn_orders);
}

bool draws_poses(const Scene& scene) {
  const bool is_seen = std::find(scene.views.begin(), scene.views.end(), View::space) != scene.views.end() &&
                       scene.show.contains(Overlay::shape) && !scene.show.contains(Overlay::puck) &&
                       !scene.show.contains(Overlay::turn_orders);
  return scene.poses.count > 0 && is_seen && drifts(scene);
}

VectorCourses vector_courses(const SceneModel& model, const Effort& effort) {
  constexpr std::int64_t kEvaluations = 10;  // of a value, with its rates
  VectorCourses courses;
  for_each_vector(model.scene.marks, [&](const MarkVector& vector) {
    const auto [at, is_new] = courses.emplace(vector.quantity.fingerprint, VectorCourse{});
    if (!is_new) return;
    VectorCourse& course = at->second;
    for (int n = 0; n <= kCourseSteps; ++n) {
      const double t_s = model.span_s * n / kCourseSteps;
      const RigidBodyState state = model.motion->at(t_s);
      const bool is_computable = state.w_B.allFinite() && state.q_SB.coeffs().allFinite();
      const auto value_S = is_computable ? vector.quantity.value(model, t_s, state) : std::nullopt;
      course.values_S.push_back(value_S.value_or(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
      if (value_S) course.longest = std::max(course.longest, value_S->stableNorm());
    }
    spend(effort, kEvaluations * kCourseSteps);
  });
  return courses;
}

std::vector<std::string> unseen_marks(const SceneModel& model) {
  const Marks& marks = model.scene.marks;
  if (model.scene.poses.count > 0 && !draws_poses(model.scene))
    return {"poses show nothing: they are of a body with its shape that flies, seen from space"};
  if (marks.empty()) return {};
  if (!draws_marks(model.scene))
    return {
        "trails, arrows, angles, areas, lines, planes and notes show nothing beside turn-orders: that body "
        "is "
        "turned by hand, and has no motion"};
  Unseen unseen(model);
  for (const TrailMark& trail : marks.trails)
    unseen.says_why("the trail of " + unseen.quoted(trail.of), trail.of);
  for (const ArrowMark& arrow : marks.arrows) {
    const std::string what = "the arrow of " + unseen.quoted(arrow.of);
    if (!unseen.says_why(what, arrow.of) && arrow.at) unseen.says_why(what, *arrow.at, true);
  }
  for (const AngleMark& angle : marks.angles) unseen.angle(angle);
  for (const AreaMark& area : marks.areas) unseen.area(area);
  for (const LineMark& line : marks.lines) {
    const std::string what = "the line from " + unseen.quoted(line.from) + " to " + unseen.quoted(line.to);
    if (!unseen.says_why(what, line.from, true)) unseen.says_why(what, line.to, true);
  }
  for (const PlaneMark& plane : marks.planes) {
    const std::string what = "the plane normal to " + unseen.quoted(plane.normal);
    if (!unseen.says_why(what, plane.normal) && plane.through) unseen.says_why(what, *plane.through, true);
  }
  for (const NoteMark& note : marks.notes) unseen.says_why("the note \"" + note.text + '"', note.at, true);
  return unseen.take();
}

}  // namespace polhode
