// SPDX-License-Identifier: MIT
// Where the controls are in a window of 1280 x 800, px.
#pragma once

#include "tests/window/played_lesson.h"

namespace polhode::window_test {

inline constexpr Point kPreviousStep{24, 775}, kNextStep{120, 775}, kOutline{200, 775};
inline constexpr Point kPlay{300, 775};
inline constexpr Point kTimeLineStart{400, 775}, kTimeLineEnd{700, 775};
/// A row of the outline, from 1.
inline Point outline_row(int n) { return {1100, 40 + 22 * n}; }

/// In the figure, and its rectangle.
inline constexpr Point kFigureFrom{640, 60}, kFigureTo{1270, 480};
inline constexpr Point kInFigure{900, 300};
/// ω's tip in played.md at its start.
inline constexpr Point kOmegaTip{980, 200};

}  // namespace polhode::window_test
