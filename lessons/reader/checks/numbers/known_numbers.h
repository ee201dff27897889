// SPDX-License-Identifier: MIT
// Numbers that an author typed with a unit, held against what a lesson and its motions have of that kind.
#pragma once

#include "lessons/notation/tex_sides.h"
#include "lessons/reader/lesson.h"

#include <optional>
#include <vector>

namespace polhode {

/// A motion that a text may speak of.
struct ShownMotion {
  const SceneModel& model;
  double still_s = 0;
};

/// Whether "5 J" is, to half a unit of its last digit, a number that the lesson declares as a constant, or
/// that one of these motions has at its still or as it begins: its energy, a moment, a component of ω, a
/// time, or what the lesson defines. True as well of angles that are constructed, 90° or 45°, of what has no
/// such unit, and of lengths and forces where the body has no size or no force.
bool is_known_number(const TypedNumber& number, const Lesson& lesson, const std::vector<ShownMotion>& motions,
                     const Effort& effort);

/// Whether it is the number of a quantity on one of these motions, likewise; nothing where none has a value
/// of it. Of greater and less: whether the quantity is that.
std::optional<bool> is_number_of(const TypedNumber& number, const Expression& quantity,
                                 const std::vector<ShownMotion>& motions, const Effort& effort,
                                 Relation relation = Relation::equal);

}  // namespace polhode
