// SPDX-License-Identifier: MIT
// The live numbers of a lesson as they are on the stills of their own steps.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/effort.h"

#include <map>

namespace polhode {

/// Each step's motion is computed once, when its numbers are first asked for. The lesson must outlive it.
class StillNumbers {
 public:
  using Values = std::map<const Expression*, double>;

  /// `effort` is told what the motions cost.
  explicit StillNumbers(Effort effort = {}) : effort_(std::move(effort)) {}

  /// The numbers in the equations that the step adds, except those that have no value there. Empty without a
  /// scene.
  /// @throws what `effort` throws; nothing is remembered then
  const Values& of(const Step& step);

 private:
  Values computed(const Step& step) const;

  Effort effort_;
  std::map<const Step*, Values> known_;
};

}  // namespace polhode
