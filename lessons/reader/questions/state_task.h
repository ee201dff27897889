// SPDX-License-Identifier: MIT
// A question of the type `state`: readers bring the motion of a scene to a goal, by hand in the figure, by
// sliders, or in words. It is judged by what the motion is, never by its picture.
#pragma once

#include "lessons/claims/answers/answers.h"
#include "lessons/reader/checks/numbers/computed_number.h"
#include "lessons/reader/questions/steered_state.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline constexpr std::size_t kMaxGoals = 4;

/// A number of the motion, and where it is to lie; in its unit.
struct StateGoal {
  ComputedNumber number;
  std::string say;           ///< what it is, in words; empty: as the expression is typed
  std::optional<double> is;  ///< the middle of the range, where the lesson says one
  std::optional<double> least, most;

  const std::string& words() const { return say.empty() ? number.written.expression : say; }
};
/// "40° ± 1°", "at least 0.5 rad/s"; 0,5 where the language has it so.
std::string range_of(const StateGoal& goal, Language language = Language::en);
struct StateTask {
  std::vector<StateGoal> goals;  ///< all of them hold together
  SteeredParts change;           ///< what readers may change
  SteeredState solution;         ///< the lesson's own
  /// The scene that is asked about, as the lesson has it; null until its step is read.
  std::shared_ptr<const Scene> scene{};
};

/// The time at which goals are judged: that of the state, or where readers do not choose it t = 0, at which
/// the motion is set going.
double judged_time_s(const StateTask& task, double t_s);

/// How far one of the goals is from being reached.
struct GoalReading {
  std::optional<double> value{};  ///< in its unit; nothing: it is not defined on this motion
  double off = 0;                 ///< value − goal, or − the end of the range that it is beyond
  bool is_reached = false;
};
/// Of each goal. What is not defined is not reached. Some 50 µs where the goals speak of the state at t
/// alone.
/// @throws what `effort` throws
std::vector<GoalReading> read_goals(const StateTask& task, const SceneModel& model, double t_s,
                                    const Effort& effort = {});
bool are_reached(const std::vector<GoalReading>& goals);
/// "35.2°": the value, or how far it is off, with so many digits as tell the value from the goal; far from
/// it three of the value.
std::string value_text(const StateGoal& goal, const GoalReading& reading, double number);
/// "35.2°, 4.8° too small"; of what is reached "39.6°".
std::string words_of(const StateGoal& goal, const GoalReading& reading);

/// What a state changes though the question does not offer it, or a torque on other axes than the scene's:
/// one sentence; empty: it may be so.
std::string why_not_allowed(const StateTask& task, const SteeredState& state);

/// Judges a state; the reason has the goals that are not reached. What cannot be, and a time that the motion
/// does not reach, is unreadable.
AnswerJudgement judge_state(const StateTask& task, const SteeredState& state, const Effort& effort = {});
/// The same of a state as it is typed.
AnswerJudgement judge_state(const StateTask& task, std::string_view text, const Effort& effort = {});

}  // namespace polhode
