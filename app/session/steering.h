// SPDX-License-Identifier: MIT
// How far a reader has come with a question of the type state: what was changed of its scene by hand, and
// how far each goal is.
#pragma once

#include "app/session/lesson_session.h"
#include "lessons/reader/questions/state_task.h"

#include <string>
#include <vector>

namespace polhode {

struct Steering {
  SteeredState state;  ///< of what the question offers: what is judged, and kept as the answer
  /// What else was changed, "the moments of inertia, the method"; empty: nothing. It is not judged until that
  /// is put back.
  std::string elsewhere;
  std::vector<GoalReading> goals;  ///< on the motion that is shown
  double t_s = 0;                  ///< at which they are read
};
/// Precondition: the session shows a scene, and the question is one of its step.
Steering steering_of(const LessonSession& session, const StateTask& task);

/// The edits without those that the question does not offer, nor another method.
SceneEdits put_back(SceneEdits edits, const StateTask& task);

}  // namespace polhode
