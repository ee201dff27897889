// SPDX-License-Identifier: MIT
// What a reader chooses of a page's look, and its colours. Text has at least 5.2:1 on the paper, 4.5:1 on the
// panel behind an equation, and 3:1 on a marked term, whose type is large; bars have at least 3:1. Panels,
// marks and lines say nothing that text does not say, and are faint.
#pragma once

#include "lessons/reader/lesson.h"
#include "render/palette.h"
#include "render/typeset/math/math.h"

#include <string_view>
#include <vector>

namespace polhode {

enum class Theme { paper, dark };

/// What pages are made for.
enum class Profile {
  page,  ///< to be read at arm's length. Exports have all steps of a stage, each whole beside its own figure,
         ///< on the pages that page_division.h gives them; windows those up to the present one, and scroll. A
         ///< page of one step alone (`--each step`, `--each stage`) has of those before it what there is room
         ///< for
  slides  ///< to be projected: the step alone, in large type of one size throughout its stage
};

/// How large a reader may wish to have the text, relative to its normal size.
inline constexpr double kLeastTextScale = 0.7, kMostTextScale = 2.0;

struct PageColors {
  Color paper;
  Color ink;
  Color quiet;                  ///< stage numbers, tags, axes
  Color accent;                 ///< the bar beside the equation in focus
  Color panel;                  ///< behind it
  Color line;                   ///< between parts of a page
  Color said, meant, question;  ///< their names and bars
  Color marked;                 ///< behind a term that the scene highlights
  Color backdrop;               ///< of figures, where it is not the studio
};
const PageColors& colors_of(Theme theme);

/// `ink` as it is readable on the theme's paper.
Color on_paper(const Color& ink, Theme theme);

/// The symbols of a lesson with the colour of their role; those of role `axes` have the ink of the text.
std::vector<MathSymbol> symbols_of(const Lesson& lesson, Theme theme);

}  // namespace polhode
