// SPDX-License-Identifier: MIT
// Work-precision diagrams: what a result cost against how wrong it is, both on logarithmic axes, one curve
// for each method, named where it ends. Layout only: the result is a sheet of lines, areas and text.
#pragma once

#include "render/drawing/sheet.h"
#include "render/palette.h"
#include "render/typeset/fonts.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

/// Curves that belong together share a hue; within it they differ in shade and in the shape of their marks.
/// Of integrators: explicit Runge-Kutta methods, geometric ones, adaptive ones, the exact motion.
enum class PlotLook {
  grey,
  orange,  ///< filled marks
  blue,    ///< hollow marks
  purple,  ///< crosses
  star     ///< a large green star, never quiet
};

/// Which of so many of a look a curve is; it has the same shade and mark in every plot then.
struct PlaceInLook {
  int place = 0, members = 1;
};

struct PlotSeries {
  std::string label;
  std::string detail{};  ///< behind the label where names stand at the end, or below it in a narrow column
  std::vector<std::pair<double, double>> points{};  ///< (work, error) in the order of the curve
  /// Drawn heavier, the rest quieter. If none but stars are: the Pareto front of the others is.
  bool emphasized = false;
  PlotLook look = PlotLook::grey;
  std::optional<PlaceInLook> place{};  ///< none: by its place among the plot's own of that look
};

/// Texts are lines as set_line() of render/typeset/paragraph.h sets them. Points whose work is not finite and
/// > 0, or whose error is not finite and >= 0, are not drawn; an error of 0 has a row of its own below the
/// decades.
struct WorkPrecisionPlot {
  std::string title{};
  std::string x_label{}, y_label{};  ///< with units
  std::vector<PlotSeries> series{};
  std::optional<double> tolerance{};                       ///< the error that was asked for
  std::optional<std::pair<double, double>> recommended{};  ///< the point to mark
  std::string recommended_label{};                         ///< what is said of it
  std::string note{};                                      ///< one line under the title
  /// Names stand in a column at the right, each at the height where its curve ends: where all curves end
  /// there.
  bool names_at_end = false;
  double scale = 1;  ///< of type, lines and marks, from what suits a picture of that size seen alone
  Color paper = kPaper, ink = kInk, muted = kAxesRole.ink,
        grid = color_from_hex(0xE3DED2);  ///< on a dark paper the curves' colours are lighter
};

/// Pure: depends on its arguments alone. About 0.2 s for fifteen curves, nearly all of it for where their
/// names go.
Sheet lay_out(const WorkPrecisionPlot& plot, double width_px, double height_px, const Fonts& fonts);

}  // namespace polhode
