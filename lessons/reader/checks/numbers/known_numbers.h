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

/// How far a typed number may be from what it stands for, in its own unit: half a unit of its last digit. Of
/// "is 3" nobody thinks that it is rounded, still less of "is 0": without "about" it is no more than 3 %.
double rounded_off(const TypedNumber& number, Relation relation);

/// Whether it is the number of a quantity on one of these motions, as far as it is rounded off; nothing where
/// none has a value of it. Of greater and less: whether the quantity is that.
std::optional<bool> is_number_of(const TypedNumber& number, const Expression& quantity,
                                 const std::vector<ShownMotion>& motions, const Effort& effort,
                                 Relation relation = Relation::equal);

}  // namespace polhode
