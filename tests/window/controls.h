// SPDX-License-Identifier: MIT
// Where the controls are in a window of 1280 x 800, px.
#pragma once

#include "tests/window/played_lesson.h"

namespace polhode::window_test {

inline constexpr Point kPreviousStep{55, 775}, kNextStep{148, 775}, kPlay{302, 775};
inline constexpr Point kTimeLineStart{378, 775}, kTimeLineEnd{505, 775};
inline constexpr Point kOutline{876, 775}, kAnswer{1104, 775};
/// The third stage in the outline of euler-equations, at its beginning.
inline constexpr Point kThirdStage{1100, 499};

/// The figure of played.md and its plots, a place in it that is background, and the tip of ω at the start.
inline constexpr Point kFigureFrom{640, 10}, kFigureTo{1270, 500};
inline constexpr Point kPlotsFrom{640, 530}, kPlotsTo{1270, 745};
inline constexpr Point kInFigure{720, 440};
inline constexpr Point kOmegaTip{928, 178};
/// With the panel of its question: the tip of ω in steered.md, and the button that makes an answer of it.
inline constexpr Point kSteeredTip{764, 336}, kCheckState{1114, 343};
/// ω in its text, and what is written there.
inline constexpr Point kOmegaWord{239, 144}, kTextFrom{40, 40}, kTextTo{600, 200};
/// The grab of the slider from fast to accurate, at its end: it is blue.
inline constexpr Point kFrontEnd{1241, 101};
/// In the panel Save.
inline constexpr Point kSaveFigure{1114, 201}, kSaveLesson{1114, 421}, kSaveSlides{1114, 523};

}  // namespace polhode::window_test
