// SPDX-License-Identifier: MIT
// Small plots of quantities against time or another quantity, named where their curves end. Layout only: the
// result is a sheet of lines and text.
#pragma once

#include "base/words/language.h"
#include "render/drawing/label_layout.h"
#include "render/palette.h"
#include "render/typeset/fonts.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

struct TimeSeries {
  std::string label;  ///< as all texts a line that set_line() of render/typeset/paragraph.h sets
  Role role{};
  std::vector<double> y{};  ///< at the plot's times
  double dash = 0;          ///< length of a dash and of a gap, in sizes of type; 0: solid
};

struct TimePlot {
  std::string title{};
  std::string unit{};       ///< of y
  std::vector<double> t{};  ///< s, in ascending order; or what x is instead
  std::vector<TimeSeries> series{};
  std::optional<double> now{};  ///< s: marked
  /// Of a plot of y ≥ 0 on a logarithmic axis: where it begins; what is less is drawn there, and the label of
  /// a curve of zeros alone says so. Absent: y is linear and its axis shows 0.
  std::optional<double> log_floor{};
  bool is_tight = false;                             ///< the axis of y need not show 0
  std::optional<std::pair<double, double>> range{};  ///< of that axis; what lies outside is not drawn
  std::string x_label{};                             ///< what `t` is; empty: time
  std::string x_unit = "s";
  /// A path in a plane: `t` goes back and forth, `now` is where the motion is on it, with y_now of each
  /// series. Neither axis need show 0.
  bool is_path = false;
  std::vector<double> y_now{};
  bool is_scaled_alike = false;      ///< of a path: the same length on both axes is the same
  Language language = Language::en;  ///< of the marks on its axes
};

/// Room for text beside the axes, px: marks on the left, names on the right.
struct PlotMargins {
  double left = 0, right = 0;
};

/// Sizes in px.
struct TimePlotStyle {
  double type_size = 16;        ///< of labels
  PlotMargins least_margins{};  ///< so that plots above each other begin and end at the same places
  Color ink = kInk, muted = kAxesRole.ink, grid = color_from_hex(0xE3DED2), paper = kPaper;
};

/// What a plot needs in `box`.
PlotMargins margins_of(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style,
                       const Fonts& fonts);

/// Where the points of a plot stand, for a hand that reads it.
struct PlotReading {
  PixelBox frame;          ///< the axes' rectangle
  bool is_of_time = true;  ///< of another quantity else
  std::string x_unit, unit;
  std::vector<double> x;  ///< of the samples, in ascending order, at the places x_px
  std::vector<double> x_px;
  struct Curve {
    Color ink;
    std::vector<double> y, y_px;  ///< at the samples; NaN in y_px: nothing is drawn there
  };
  std::vector<Curve> curves;

  /// What lies at the place, within the axes.
  double x_at(double px) const;
  /// The sample nearest to the place. Precondition: there are samples
  std::size_t nearest(double px) const;
};

/// Of the plot that lay_out draws of the same arguments; nothing of a path.
std::optional<PlotReading> reading_of(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style,
                                      const Fonts& fonts);

/// In `box`; where that is smaller than 14 sizes of type by 7.5, the type is smaller. Values that are not
/// finite leave gaps. Pure.
Sheet lay_out(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style, const Fonts& fonts);

}  // namespace polhode
