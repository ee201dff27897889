// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/lesson_scene.h"

#include "base/spelling.h"
#include "physics/body/pivot.h"

#include <algorithm>
#include <utility>

namespace polhode {

bool has_heavy(const Torque& torque) {
  return std::any_of(torque.begin(), torque.end(),
                     [](const TorqueTerm& term) { return std::holds_alternative<HeavyTop>(term); });
}

namespace {

/// The `pivot_m` of a body of the lesson; null: it has none.
const Vec3* pivot_of(const Body& body, const LessonBodies& bodies) {
  const auto own = bodies.named.find(body.name);
  const auto pivot = bodies.pivots_m.find(body.name);
  return own != bodies.named.end() && own->second == body && pivot != bodies.pivots_m.end() ? &pivot->second
                                                                                            : nullptr;
}

Result<Torque, SceneFault> torque_of(const LessonScene& scene, const LessonBodies& bodies) {
  const Body& body = scene.scene.body;
  if (!scene.weighs) return scene.scene.torque;
  const Vec3* pivot_m = pivot_of(body, bodies);
  if (pivot_m == nullptr)
    return Failure<SceneFault>{
        {"\"weight\" turns a body about the point where it is held, and " + in_quotes(body.name) +
             " has none",
         bodies.named.contains(body.name)
             ? "give [body." + body.name + "] a mass_kg and pivot_m = [x, y, z], in m from its centre of mass"
             : "give the lesson a [body.NAME] of its own, with mass_kg and pivot_m = [x, y, z]"}};
  Torque torque{weight_at(body.mass_kg, *pivot_m)};
  torque.insert(torque.end(), scene.scene.torque.begin(), scene.scene.torque.end());
  return torque;
}

/// With moments about the pivot, where it hangs on one.
Result<Body, SceneFault> body_of(const LessonScene& scene, const Torque& torque, const LessonBodies& bodies) {
  const Body& body = scene.scene.body;
  const Vec3* pivot_m = pivot_of(body, bodies);
  if (bodies.drawn.contains(body.name)) return body;
  if (pivot_m != nullptr && has_heavy(torque)) {
    constexpr double kSame = 1e-6;  // of what is written with seven digits
    if (!((center_from_pivot_B(body.mass_kg, torque) + *pivot_m).norm() <= kSame * pivot_m->norm()))
      return Failure<SceneFault>{
          {"\"heavy\" holds " + in_quotes(body.name) + " at another point than its pivot_m",
           "write torque = \"weight\", or leave pivot_m out"}};
  }
  auto held = pivot_m != nullptr ? about_pivot(body, torque) : on_its_pivot(body, torque);
  if (held) return std::move(held).value();
  return Failure<SceneFault>{
      {held.error(),
       "let the axis of \"heavy\" be that of 1, 2 or 3, or give the body by moments about the pivot"}};
}

}  // namespace

FinishedScene finish(const LessonScene& given, const LessonBodies& bodies) {
  FinishedScene finished{given.scene};
  Scene& scene = finished.scene;
  if (given.falls) scene.F_S = Vec3(0.0, 0.0, -scene.body.mass_kg * kStandardGravity);
  if (auto torque = torque_of(given, bodies))
    scene.torque = std::move(torque).value();
  else
    finished.of_weight = torque.error();
  if (auto body = body_of(given, scene.torque, bodies))
    scene.body = std::move(body).value();
  else if (!finished.of_weight)
    finished.of_weight = body.error();
  if (finished.of_weight || !given.start) return finished;
  const auto state = state_of(*given.start, scene.body.moments, scene.torque);
  if (state) {
    scene.w0_B = state->w_B;
    scene.attitude = state->q_SB;
  } else {
    finished.of_start = state.error();
  }
  return finished;
}

Scene finished(const LessonScene& scene, const LessonBodies& bodies) { return finish(scene, bodies).scene; }

Result<Scene, SceneFault> finished_or_fault(const LessonScene& scene, const LessonBodies& bodies) {
  FinishedScene finished = finish(scene, bodies);
  if (finished.of_weight) return Failure<SceneFault>{*finished.of_weight};
  if (finished.of_start) return Failure<SceneFault>{*finished.of_start};
  return std::move(finished.scene);
}

Scene finished(const std::vector<LessonScene>& scenes, const LessonBodies& bodies) {
  Scene first = finished(scenes.front(), bodies);
  for (std::size_t i = 1; i < scenes.size(); ++i) first.beside.push_back(finished(scenes[i], bodies));
  return first;
}

}  // namespace polhode
