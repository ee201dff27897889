// SPDX-License-Identifier: MIT
// A lesson with a question of each kind that is answered by typing.
#pragma once

#include "tests/app/session/example_lesson.h"

namespace polhode::test {

/// Stage "first" asks sign (an expression), which (a choice of B among three) and order (C A B); the second
/// step of stage "second" asks derive (dL/dt = N becomes Euler's equation). Two outcomes.
std::shared_ptr<const LoadedLesson> quiz();

/// Right answers to all of them.
AnswerLog all_right();
inline const char* const kDerived = "d*L/dt + omega x L = N\nI d*omega/dt + omega x (I omega) = N";

}  // namespace polhode::test
