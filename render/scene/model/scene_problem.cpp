// SPDX-License-Identifier: MIT
#include "render/scene/model/scene_problem.h"

#include "physics/analysis/characteristic_time.h"
#include "physics/exact/powers_of_two.h"
#include "physics/geometry/poinsot.h"
#include "physics/method.h"
#include "render/scene/model/scene_needs.h"

#include <numbers>

namespace polhode {
namespace {

constexpr double kHerpolhodePeriods = 3.0;   // enough for the annulus to show
constexpr double kTurnsWithoutPeriod = 4.0;  // of ω, where torque leaves no polhode period

Quat turn_half_about_x() { return Quat(0.0, 1.0, 0.0, 0.0); }

/// Shortest rotation that takes `from_B` to `to_S`; where that exceeds a quarter turn, a half turn about x
/// comes first, so that the result is defined and continuous also for opposite directions.
Quat align(const Vec3& from_B, const Vec3& to_S) {
  if (from_B.isZero(0.0)) return Quat::Identity();
  if (from_B.dot(to_S) >= 0.0) return shortest_rotation(from_B, to_S);
  const Quat half = turn_half_about_x();
  return shortest_rotation(half * from_B, to_S) * half;
}

/// A vector along L, whatever the units: |L| itself may be out of range.
Vec3 along_L_B(const Scene& scene) {
  const Vec3 &I = scene.body.moments.vector(), &w_B = scene.w0_B;
  if (w_B.isZero(0.0) || !w_B.allFinite()) return Vec3::Zero();
  return times_two_to(-exponent_of(I), I).cwiseProduct(times_two_to(-exponent_of(w_B), w_B));
}

Quat initial_attitude(const Scene& scene) {
  const AttitudeSpec spec = attitude_spec(scene);
  if (const Quat* given = std::get_if<Quat>(&spec)) return given->normalized();
  const double z = std::get<LPoints>(spec) == LPoints::down ? -1.0 : 1.0;
  return align(along_L_B(scene), Vec3(0.0, 0.0, z));
}

}  // namespace

AttitudeSpec attitude_spec(const Scene& scene) {
  return scene.attitude.value_or(scene.show.contains(Overlay::plane) ? LPoints::down : LPoints::up);
}

Problem problem_of(const Scene& scene) {
  return {scene.body.moments, {initial_attitude(scene), scene.w0_B}, scene.torque};
}

bool same_motion(const Scene& a, const Scene& b) {
  const Problem of_a = problem_of(a), of_b = problem_of(b);
  const auto method = [](const Scene& scene, const Problem& problem) {
    return scene.motion.method.value_or(default_method(problem));
  };
  return of_a.I.vector() == of_b.I.vector() && of_a.start.w_B == of_b.start.w_B &&
         of_a.start.q_SB.coeffs() == of_b.start.q_SB.coeffs() && of_a.torque == of_b.torque &&
         method(a, of_a) == method(b, of_b) && a.motion.step_s == b.motion.step_s &&
         a.motion.tolerance == b.motion.tolerance && a.body.mass_kg == b.body.mass_kg && a.v0_S == b.v0_S &&
         a.F_S == b.F_S && a.arrow == b.arrow;
}

bool same_picture(Scene a, Scene b) {
  for (Scene* scene : {&a, &b}) {
    scene->caption.clear();
    scene->duration_s.reset();
    scene->rate.reset();
  }
  return a == b;
}

double natural_span_s(const Scene& scene) {
  const double turn_s = turn_time(scene.w0_B).value_or(1.0);
  if (!scene.torque.empty()) return kTurnsWithoutPeriod * turn_s;
  return polhode_period(scene.body.moments, scene.w0_B).value_or(turn_s);
}

double span_s(const Scene& scene) { return scene.duration_s.value_or(natural_span_s(scene)); }

double herpolhode_span_s(const Scene& scene) {
  return scene.duration_s.value_or(kHerpolhodePeriods * natural_span_s(scene));
}

double shown_rate(const Scene& scene) {
  constexpr double kShownSecondsPerPeriod = 8.0;
  return scene.rate.value_or(natural_span_s(scene) / kShownSecondsPerPeriod);
}

Scene completed(Scene scene) {
  scene.attitude = attitude_spec(scene);
  MotionSpec& motion = scene.motion;
  motion.method = motion.method.value_or(default_method(problem_of(scene)));
  if (facts_of(*motion.method).control == StepControl::adaptive)
    motion.tolerance = motion.tolerance.value_or(kDefaultTolerance);
  scene.rate = shown_rate(scene);
  if (scene.beside.empty()) scene.duration_s = span_s(scene);  // else each has its own
  scene.still_s = still_time_s(scene);
  for (Scene& other : scene.beside) other = completed(std::move(other));
  return scene;
}

double table_step_s(const Scene& scene) {
  constexpr double kStepsPerTurn = 64.0;
  return scene.motion.step_s.value_or(turn_time(scene.w0_B).value_or(2.0 * std::numbers::pi) / kStepsPerTurn);
}

}  // namespace polhode
