// SPDX-License-Identifier: MIT
// Names of quantities in words, as far as they can be read: what stands beside a number, above a column, over
// a plot or in a question is then held against what is shown.
#pragma once

#include "lessons/reader/lesson.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// "the ratio of $I_1$ to $I_3$", "half the energy", "the angle between $\vec\omega$ and axis 2", "largest
/// moment": what that is. A lesson's symbols are called as their `say` says, before all else.
///
///   name      = ["the" | "its" | …] name | formula | word [formula]
///             | "half" name | "twice" name | "a tenth of" name | "three times" name
///             | "square of" name | "length of" name | "sum of" name "and" name | "product …" | "mean …"
///             | "ratio of" name "to" name | name "divided by" name | name "over" name
///             | "angle between" name "and" name | "component of" name "along" name | word "about axis 2"
///
/// Nothing of other words: nothing is guessed. Beside a number a vector is its length.
enum class VectorsSaid { as_lengths, as_vectors };
std::optional<Expression> quantity_said(const std::vector<TextSpan>& name, const Lesson& lesson,
                                        VectorsSaid vectors = VectorsSaid::as_lengths);

/// The same of the longest end of a line that can be read, unless what stands before it goes on with it: of
/// "at first half of $T$" half of T.
std::optional<Expression> quantity_said_at_end(const std::vector<TextSpan>& line, const Lesson& lesson,
                                               VectorsSaid vectors = VectorsSaid::as_lengths);

/// Whether a name that stands behind these words is a part of a longer one: "the square of", "half".
bool goes_on_with_name(std::string_view before);

/// What a name in words means wherever the rotation of a body is written about, whatever the lesson calls so.
std::optional<Expression> quantity_of_common_name(const std::string& name, const Lesson& lesson);

/// The axis that a name speaks of, and it alone: '2' of "axis 2", "2", and of a letter with the index 2.
std::optional<char> axis_of_name(const std::string& name);
/// Those of the body that an expression speaks of by their numbers: "12" of w1*e2.
std::string axes_in(const Expression& expression);

/// A line of plain text and formulas between dollars, as titles of plots are written. Formulas that cannot be
/// parsed are words.
std::vector<TextSpan> stretches_of(const std::string& line);

}  // namespace polhode
