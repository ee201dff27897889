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
/// such unit, and of lengths and forces where the body has no size or no force. `at_s`: a time that is said
/// beside it.
bool is_known_number(const TypedNumber& number, const Lesson& lesson, const std::vector<ShownMotion>& motions,
                     const Effort& effort, std::optional<double> at_s = {});

/// How far a typed number may be from what it stands for, in its own unit: half a unit of its last digit. Of
/// "is 3" nobody thinks that it is rounded, still less of "is 0": without "about" it is no more than 3 %.
double rounded_off(const TypedNumber& number, Relation relation);

/// When something is said to be so: at the still or as the motion begins; all along what is shown; or, below
/// a picture that moves, either all along or of how the motion begins, by which motions are told apart.
enum class SaidOf { some_time, all_times, start_or_all_times };
/// The times of a motion that are then looked at; of all times those of films and of the window.
std::vector<double> times_of(const ShownMotion& motion, SaidOf when);

/// Whether it is the number of a quantity on one of these motions, as far as it is rounded off; nothing where
/// none has a value of it. Of greater and less: whether the quantity is that. `at_s`: the time of which it is
/// said.
std::optional<bool> is_number_of(const TypedNumber& number, const Expression& quantity,
                                 const std::vector<ShownMotion>& motions, const Effort& effort,
                                 Relation relation = Relation::equal, SaidOf when = SaidOf::some_time,
                                 std::optional<double> at_s = {});

/// Whether a quantity is between two numbers, as far as these are rounded off, on one of these motions;
/// nothing where none has a value of it.
std::optional<bool> is_between(const Expression& quantity, const TypedNumber& low, const TypedNumber& high,
                               const std::vector<ShownMotion>& motions, const Effort& effort, SaidOf when);

}  // namespace polhode
