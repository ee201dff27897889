// SPDX-License-Identifier: MIT
// How the curves of a plot look: colours and marks, given out in the order of the series where they have no
// places of their own. Internal to render/drawing/.
#pragma once

#include "render/drawing/plots/plot.h"

#include <vector>

namespace polhode {

enum class MarkShape { disc, square, diamond, triangle_up, triangle_down, hexagon, plus, cross, star };

struct CurveStyle {
  Color ink;    ///< of its label
  Color paint;  ///< of its line and marks
  MarkShape shape = MarkShape::disc;
  bool hollow = false;
};

std::vector<CurveStyle> styles_of(const std::vector<PlotSeries>& series);

/// `radius` is that of a disc of the same weight, px; `paper` fills hollow marks.
void add_mark(Sheet& sheet, const Vec2& at, double radius, const CurveStyle& style, const Color& paper);

}  // namespace polhode
