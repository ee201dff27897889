// SPDX-License-Identifier: MIT
#include "app/session/steering.h"

#include "base/words/answer_words.h"
#include "render/scene/model/scene_problem.h"

namespace polhode {
namespace {

void add(std::string& words, std::string_view more) {
  words += (words.empty() ? "" : ", ") + std::string(more);
}

/// What was changed of a scene, all of it.
SteeredState difference(const Scene& lesson, const Scene& now) {
  SteeredState state;
  if (now.w0_B != lesson.w0_B) state.w0_B = now.w0_B;
  if (!(now.body.moments == lesson.body.moments)) state.moments = now.body.moments.vector();
  if (attitude_spec(now) != attitude_spec(lesson)) state.attitude = attitude_spec(now);
  const TorqueTerm constant = constant_torque(now.torque);
  if (now.torque != lesson.torque && with_constant(lesson.torque, constant) == now.torque)
    state.torque = constant;
  return state;
}

std::string words_in(Language language, const SteeredParts& parts) {
  std::string words;
  for (std::size_t i = 0; i < kSteered.size(); ++i)
    if (parts.contains(static_cast<Steered>(i))) add(words, kSteered[i].words.in(language));
  return words;
}

bool has_same_method(const MotionSpec& a, const MotionSpec& b) {
  return a.method == b.method && a.step_s == b.step_s && a.tolerance == b.tolerance;
}

}  // namespace

Steering steering_of(const LessonSession& session, const StateTask& task) {
  const Scene &lesson = *task.scene, &now = session.model()->scene;
  Steering steering;
  steering.state = difference(lesson, now);
  SteeredParts others;
  const auto keep = [&](Steered part, auto& value) {
    if (!value || task.change.contains(part)) return;
    others.insert(part);
    value.reset();
  };
  keep(Steered::omega, steering.state.w0_B);
  keep(Steered::moments, steering.state.moments);
  keep(Steered::attitude, steering.state.attitude);
  keep(Steered::torque, steering.state.torque);
  const Language language = session.lesson().about.language;
  steering.elsewhere = words_in(language, others);
  const bool has_other_torque =
      now.torque != lesson.torque && with_constant(lesson.torque, constant_torque(now.torque)) != now.torque;
  if (has_other_torque) add(steering.elsewhere, facts_of(Steered::torque).words.in(language));
  if (!has_same_method(now.motion, lesson.motion)) add(steering.elsewhere, words::kTheMethod.in(language));
  steering.t_s = judged_time_s(task, session.t_s());
  if (task.change.contains(Steered::t)) steering.state.t_s = session.t_s();
  steering.goals = read_goals(task, *session.model(), steering.t_s, session.effort());
  return steering;
}

SceneEdits put_back(SceneEdits edits, const StateTask& task) {
  if (!task.change.contains(Steered::omega)) edits.w0_B.reset();
  if (!task.change.contains(Steered::moments)) edits.body.reset();
  if (!task.change.contains(Steered::attitude)) edits.attitude.reset();
  if (!task.change.contains(Steered::torque)) edits.torque.reset();
  edits.numbers.clear();
  edits.motion.reset();
  return edits;
}

}  // namespace polhode
