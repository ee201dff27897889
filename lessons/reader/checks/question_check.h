// SPDX-License-Identifier: MIT
// Whether the questions of a lesson can be answered, and only by who knows the answer.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/effort.h"

#include <string_view>
#include <vector>

namespace polhode {

/// A lesson with so many questions for one choice is looked at as a whole.
inline constexpr int kLeastChoicesToCount = 6;
/// More of them under one letter, and with the right choice longer than all others, are warned of.
inline constexpr double kMostUnderOneLetter = 0.4, kMostLongest = 0.5;
/// What a prediction is held against is over in so many seconds of the watch.
inline constexpr double kLongestPlay_s = 30;

/// Of a lesson whose answers are computed (number_question.h): errors where a number has no value or is not
/// told from 0, or is asked for in another unit than its own, where two choices are the same, and where what
/// a prediction plays cannot be shown; warnings where a wrong choice of a list
/// has no reply, and where one letter, or the longest choice, is right too often.
std::vector<Diagnostic> check_questions(const Lesson& lesson, std::string_view file_name,
                                        const Effort& effort = {});

}  // namespace polhode
