// SPDX-License-Identifier: MIT
// How what learners type is read: with the lesson's symbols by their names, and of its constants and
// definitions those alone that they can know.
#pragma once

#include "lessons/derivation/derivation.h"
#include "lessons/reader/lesson.h"

#include <map>
#include <string>

namespace polhode {

/// As the lesson's author types: every name is read. It refers to the notation.
LineNotation line_notation(const EquationNotation& notation, const std::map<std::string, Symbol>& symbols,
                           const MathMacros& macros);

/// As who answers the question types. Names that a lesson gives to arrows of its figures are words of its
/// file, which no page shows: of constants and definitions those are read that the question's formulas print,
/// and those that its answer or its lines are written with. It refers to the lesson, or has its own notation.
LineNotation line_notation(const Lesson& lesson, const Ask& ask);

}  // namespace polhode
