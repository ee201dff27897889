// SPDX-License-Identifier: MIT
// The computed numbers of a lesson as they are on the stills of their own steps.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/effort.h"

#include <map>
#include <utility>

namespace polhode {

/// Whether scenes that are shown side by side have one caption between them: the same words, without a
/// number, which each would have of its own motion. The pictures of a filmstrip, which have labels, share
/// theirs anyway.
bool have_one_caption(const std::vector<const Scene*>& shown);

/// Each step's motion is computed once, when its numbers are first asked for. The lesson must outlive it.
class StillNumbers {
 public:
  /// Each number in its unit, under its LiveNumber::id.
  using Values = std::map<int, double>;

  /// `effort` is told what the motions cost.
  explicit StillNumbers(Effort effort = {}) : effort_(std::move(effort)) {}

  /// The numbers that the step adds, and those of its figure's caption, except those that have no value
  /// there. Empty without a scene.
  /// @throws what `effort` throws; nothing is remembered then
  const Values& of(const Lesson& lesson, const Step& step);
  /// Those in the caption of one of the scenes side by side, by their order: of its own motion.
  const Values& of_caption(const Lesson& lesson, const Step& step, std::size_t shown);

 private:
  Values computed(const Lesson& lesson, const Step& step, std::size_t shown) const;

  Effort effort_;
  std::map<std::pair<const Step*, std::size_t>, Values> known_;
};

}  // namespace polhode
