// SPDX-License-Identifier: MIT
// Words for what a motion is as a whole, besides the quantities that it has at each time: its period, the
// rates of its precession, and how wrong its method is.
//
// Numbers that are computed for one time can speak of them: the columns of tables, and what is typed. They
// are in expressions as constants whose value is not a number until a motion is known.
#pragma once

#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/claims/live_claims.h"
#include "physics/analysis/horizon.h"
#include "physics/analysis/motion_errors.h"
#include "physics/analysis/motion_facts.h"
#include "physics/effort.h"

#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace polhode {

class MotionNumbers;

struct MotionWord {
  std::string_view name;   ///< in expressions
  std::string_view unit;   ///< of SI
  std::string_view tex;    ///< as it is printed where nothing else is said
  std::string_view means;  ///< in FORMAT.md
  /// Nothing where the motion has none.
  std::optional<double> (*value)(MotionNumbers&);
};
/// In the order of FORMAT.md.
std::span<const MotionWord> motion_words();

/// Adds those words that the lesson has not itself; `dimensions` are those of constants, by their numbers.
void add_motion_words(Vocabulary& vocabulary, std::map<int, Dimension>& dimensions);

/// Why a number of this dimension is none of this unit: Hz counts turns, and degrees are of angles. Empty if
/// it may be.
std::string why_not_in(const Expression& expression, std::string_view unit);

/// Whether an expression speaks of a motion as a whole.
bool has_motion_words(const Expression& expression);

/// The numbers of a motion at one time. What needs more than its state then is computed once, when it is
/// first asked for.
class MotionNumbers {
 public:
  /// The model must outlive it.
  MotionNumbers(const SceneModel& model, double t_s, Effort effort = {});

  /// Nothing where it is not defined on the motion. @throws what `effort` throws
  std::optional<double> value_of(const Expression& scalar);
  /// The same with the words of this motion replaced by their values; nothing where one is not defined.
  std::optional<Expression> written_out(const Expression& expression);

  const MotionFacts& facts();
  /// Half the period; nothing of a motion without flips (physics/geometry/flips.h).
  std::optional<double> flip_interval_s();
  /// How far the motion is known (physics/analysis/horizon.h).
  Horizon horizon() const { return horizon_of(problem_); }
  /// Of the computed motion at t, from the closed form, or under a torque from a much smaller tolerance;
  /// nothing of a closed form, which is itself what others are compared with.
  std::optional<StateError> error();
  /// From 0 to t: the largest over kDriftSamples times and the end.
  const InvariantDrift& drift();
  /// Of the equations of motion, from 0 to t; nothing of a closed form.
  std::optional<double> evaluations() const;

 private:
  bool is_computed() const;

  const SceneModel& model_;
  double t_s_;
  Effort effort_;
  Problem problem_;
  std::optional<LiveState> live_;
  std::optional<MotionFacts> facts_;
  std::optional<StateError> error_;
  std::optional<InvariantDrift> drift_;
};

}  // namespace polhode
