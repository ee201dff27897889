// SPDX-License-Identifier: MIT
#include "render/drawing/plots/time_plot.h"

#include "render/drawing/linear_axis.h"
#include "render/drawing/log_axis.h"
#include "render/drawing/polyline.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

// Lengths in sizes of type.
constexpr double kTitleRoom = 2.1, kTimeRoom = 1.7;       // above and below the axes
constexpr double kLeastWidth = 12.4, kLeastHeight = 7.5;  // of a plot
constexpr double kTitleGap = 0.6;                         // between title and unit
constexpr double kMarkGap = 0.45, kNameGap = 0.55, kTick = 0.22, kUnitGap = 0.35;
constexpr double kLeastMarkRoom = 2.3, kLeastNameRoom = 2.0;  // so that most plots look alike
constexpr double kMostNameRoom = 0.34;                        // of a plot's width
constexpr double kCapHeight = 0.72;
constexpr double kNameSpacing = 1.35;
constexpr double kMarkSpacing = 1.9, kTimeMarkSpacing = 3.2;
constexpr double kHairline = 0.06, kAxisLine = 0.075, kCurve = 0.12, kPath = 0.09, kLeader = 0.07;
constexpr double kDot = 0.24, kDotRim = 0.1;
constexpr double kLeaderFrom = 0.3;  // of displacement of a name
constexpr int kMostIntervals = 4;
constexpr int kLeastDecades = 2;
constexpr double kSimplification = 0.1;  // px

struct Tick {
  double px;
  std::string text;
};

/// Where a value lies from bottom to top, on either kind of axis, with its marks.
class ValueAxis {
 public:
  /// Marks of a range that is not rounded stand `spacing` px apart.
  ValueAxis(const TimePlot& plot, double bottom, double top, int intervals, double spacing)
      : language_(plot.language), floor_(plot.log_floor) {
    std::vector<double> values;
    for (const TimeSeries& series : plot.series)
      values.insert(values.end(), series.y.begin(), series.y.end());
    if (floor_)
      make_log(plot, values, bottom, top, intervals);
    else
      make_linear(plot, values, intervals);
    place(bottom, top, spacing);
  }

  /// Between other ends.
  void place(double bottom, double top, double spacing) {
    if (floor_) return;
    linear_.start_px = bottom;
    linear_.end_px = top;
    ticks_.clear();
    for (LinearAxis::Mark& mark : linear_.marks(spacing))
      ticks_.push_back({mark.px, with_decimals(std::move(mark.text), language_)});
  }

  /// What a px is, of a linear axis between its ends.
  double length() const { return (linear_.high - linear_.low) * std::pow(10.0, linear_.exponent); }

  bool shows(double value) const { return std::isfinite(value) && (!floor_ || value >= 0.0); }
  double px(double value) const { return floor_ ? log_.px(std::max(value, *floor_)) : linear_.px(value); }
  const std::vector<Tick>& ticks() const { return ticks_; }
  std::string unit_of(const std::string& unit) const { return floor_ ? unit : linear_.unit_of(unit); }
  /// Of the heavier line.
  double base_px() const { return px(floor_.value_or(0.0)); }

 private:
  void make_log(const TimePlot& plot, const std::vector<double>& values, double bottom, double top,
                int intervals) {
    constexpr double kRounding = 1e-9;  // of a logarithm, so that the range 1e-6 begins at its decade
    double largest = *floor_;
    for (double value : values)
      if (std::isfinite(value)) largest = std::max(largest, value);
    if (plot.range) largest = plot.range->second;
    const int low = static_cast<int>(std::floor(std::log10(*floor_) + kRounding));
    const int decades =
        std::max(kLeastDecades, static_cast<int>(std::ceil(std::log10(largest) - kRounding)) - low);
    const int step = (decades + intervals - 1) / intervals;
    const int parts = (decades + step - 1) / step;
    log_.low = low;
    log_.high = low + parts * step;
    log_.start_px = bottom;
    log_.end_px = top;
    for (int i = 0; i <= parts; ++i)
      ticks_.push_back({log_.px_of_log(low + i * step), power_of_ten(low + i * step)});
  }

  void make_linear(const TimePlot& plot, const std::vector<double>& values, int intervals) {
    if (plot.range) {
      linear_ = LinearAxis::between(plot.range->first, plot.range->second);
      return;
    }
    linear_ = plot.is_tight || plot.is_path ? LinearAxis::around(values) : LinearAxis::covering(values);
    linear_.round_out(intervals);
  }

  Language language_;
  std::optional<double> floor_;
  LogAxis log_;
  LinearAxis linear_;
  std::vector<Tick> ticks_;
};

/// With type small enough for the box, and for title and unit in one line of it.
TimePlotStyle fitting(const TimePlot& plot, const TimePlotStyle& style, const PixelBox& box,
                      const Fonts& fonts) {
  constexpr double kOfPrefix = 1.0;  // a prefix that the axis may put before the unit
  TextStyle text;
  text.size = 1.0;
  text.sans = true;
  const double unit =
      plot.unit.empty() ? 0.0 : kTitleGap + kOfPrefix + set_line(plot.unit, text, fonts).width;
  const double head = set_line(plot.title, text, fonts).width + unit;
  TimePlotStyle fitted = style;
  fitted.type_size =
      std::min({style.type_size, box.width() / std::max(kLeastWidth, head), box.height() / kLeastHeight});
  return fitted;
}

/// A stretch of a curve without gaps.
using Stretch = std::vector<Vec2>;

/// Makes the sheet of one plot, part after part.
class TimePlotLayout {
 public:
  TimePlotLayout(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style, const Fonts& fonts)
      : plot_(plot),
        box_(box),
        style_(fitting(plot, style, box, fonts)),
        fonts_(fonts),
        axis_(plot, box.y1 - px(kTimeRoom), box.y0 + px(kTitleRoom), intervals(), px(kMarkSpacing)) {
    place_axes();
  }

  Sheet make() {
    add_title();
    add_value_axis();
    add_time_axis();
    for (const TimeSeries& series : plot_.series) add_curve(series);
    add_names();
    add_now();
    return std::move(sheet_);
  }

  const PlotMargins& margins() const { return margins_; }

  PlotReading reading() const {
    PlotReading reading{.frame = frame_,
                        .is_of_time = plot_.x_label.empty(),
                        .x_unit = plot_.x_unit,
                        .unit = plot_.unit,
                        .x = plot_.t,
                        .x_px = {},
                        .curves = {}};
    for (const double x : plot_.t) reading.x_px.push_back(time_.px(x));
    for (const TimeSeries& series : plot_.series) {
      PlotReading::Curve curve{.ink = name_color(series), .y = series.y, .y_px = {}};
      for (const double y : series.y)
        curve.y_px.push_back(axis_.shows(y) && is_in_range(y) ? axis_.px(y)
                                                              : std::numeric_limits<double>::quiet_NaN());
      reading.curves.push_back(std::move(curve));
    }
    return reading;
  }

 private:
  double px(double sizes) const { return sizes * style_.type_size; }
  DisplayList line_of(const std::string& text, const Color& color, double scale = 1.0) const {
    TextStyle style;
    style.size = scale * style_.type_size;
    style.color = color;
    style.sans = true;
    return set_line(text, style, fonts_);
  }
  double width_of(const std::string& text) const { return line_of(text, style_.ink).width; }

  int intervals() const {
    const double height = box_.height() - px(kTitleRoom + kTimeRoom);
    return std::clamp(static_cast<int>(height / px(kMarkSpacing)), 2, kMostIntervals);
  }

  /// Text decides where the axes end on the left and on the right.
  void place_axes() {
    double marks = px(kLeastMarkRoom), names = px(kLeastNameRoom);
    for (const Tick& tick : axis_.ticks()) marks = std::max(marks, width_of(tick.text));
    if (has_names())
      for (const TimeSeries& series : plot_.series) names = std::max(names, width_of(name_of(series)));
    names = std::min(names, kMostNameRoom * box_.width());
    time_ = x_axis();
    names = std::max(names, width_of(time_unit()) + px(0.5));
    margins_ = {std::max(marks + px(kMarkGap), style_.least_margins.left),
                std::max(names + px(kNameGap), style_.least_margins.right)};
    frame_ = {box_.x0 + margins_.left, box_.y0 + px(kTitleRoom), box_.x1 - margins_.right,
              box_.y1 - px(kTimeRoom)};
    if (plot_.is_path && plot_.is_scaled_alike) scale_alike();
    time_.start_px = frame_.x0;
    time_.end_px = frame_.x1;
  }

  LinearAxis x_axis() const {
    if (plot_.is_path) {
      LinearAxis rounded = LinearAxis::around(plot_.t);
      rounded.round_out(kMostIntervals);
      const double unit = std::pow(10.0, rounded.exponent);
      return LinearAxis::between(rounded.low * unit, rounded.high * unit);
    }
    return LinearAxis::between(plot_.t.empty() ? 0.0 : plot_.t.front(),
                               plot_.t.empty() ? 1.0 : plot_.t.back());
  }

  /// The frame becomes smaller, and stays on the axis below.
  void scale_alike() {
    const double x_length = (time_.high - time_.low) * std::pow(10.0, time_.exponent);
    const double px_per_unit = std::min(frame_.width() / x_length, frame_.height() / axis_.length());
    const double x_gap = 0.5 * (frame_.width() - px_per_unit * x_length),
                 y_gap = 0.5 * (frame_.height() - px_per_unit * axis_.length());
    frame_ = {frame_.x0 + x_gap, frame_.y0 + 2.0 * y_gap, frame_.x1 - x_gap, frame_.y1};
    axis_.place(frame_.y1, frame_.y0, px(kMarkSpacing));
  }

  /// A path alone has its name in the title.
  bool has_names() const { return !plot_.is_path || plot_.series.size() > 1; }

  /// "s", or what x is, with its unit.
  std::string time_unit() const {
    const std::string unit = time_.unit_of(plot_.x_unit);
    return plot_.x_label + (plot_.x_label.empty() || unit.empty() ? "" : " ") + unit;
  }

  /// A curve that lies on the floor of a logarithmic axis may be anything there: its name tells that it is 0
  /// ("T = 0" would speak of the quantity that drifts).
  std::string name_of(const TimeSeries& series) const {
    const bool zero = plot_.log_floor && !series.y.empty() &&
                      std::all_of(series.y.begin(), series.y.end(), [](double y) { return y == 0.0; });
    return zero ? series.label + ": 0" : series.label;
  }

  Color on_its_paper(const Color& color) const { return is_dark(style_.paper) ? on_dark(color) : color; }
  Color line_color(const TimeSeries& series) const { return on_its_paper(series.role.paint); }
  Color name_color(const TimeSeries& series) const { return on_its_paper(series.role.ink); }

  void add_line(std::vector<Vec2> points, double width, const Color& color, double dash = 0.0) {
    sheet_.shapes.push_back(Stroke{std::move(points), width, color, dash});
  }

  /// In smaller type, if it is wider than `most`.
  void add_text(std::string text, const Vec2& at, double align, const Color& color,
                double most = std::numeric_limits<double>::infinity(), const Color& halo = {0, 0, 0, 0}) {
    DisplayList line = line_of(text, color);
    if (line.width > most) line = line_of(text, color, most / line.width);
    const double left = at.x() - align * line.width;
    sheet_.texts.push_back(
        {.list = std::move(line), .at = {left, at.y()}, .halo = halo, .text = std::move(text)});
  }

  /// Names may lie over lines of the grid.
  Color paper_halo() const { return {style_.paper.r, style_.paper.g, style_.paper.b, 0.92F}; }

  void add_title() {
    const double baseline = std::round(box_.y0 + px(0.9));
    if (!plot_.title.empty()) add_text(plot_.title, {box_.x0, baseline}, 0.0, style_.ink);
    const std::string unit = axis_.unit_of(plot_.unit);
    const double gap = plot_.title.empty() ? 0.0 : width_of(plot_.title) + px(kTitleGap);
    if (!unit.empty()) add_text(unit, {box_.x0 + gap, baseline}, 0.0, style_.muted);
  }

  /// To the middle of a pixel, so that even lines are crisp.
  static double crisp(double at) { return std::floor(at) + 0.5; }

  void add_value_axis() {
    for (const Tick& tick : axis_.ticks()) {
      const double y = crisp(tick.px);
      const bool base = std::abs(tick.px - axis_.base_px()) < 0.5;
      add_line({{frame_.x0, y}, {frame_.x1, y}}, px(base ? kAxisLine : kHairline),
               base ? between(style_.muted, style_.paper, 0.35F) : style_.grid);
      add_text(tick.text, {frame_.x0 - px(kMarkGap), std::round(y + px(0.5 * kCapHeight))}, 1.0,
               style_.muted);
    }
  }

  /// Texts too long for where they stand are left out.
  void add_time_axis() {
    const std::vector<LinearAxis::Mark> marks = time_marks();
    const double baseline = std::round(box_.y1 - px(0.35));
    const double last_end = marks.empty() ? frame_.x1 : marks.back().px + 0.5 * width_of(marks.back().text);
    const double unit_x =
        std::min(std::max(frame_.x1, last_end) + px(kUnitGap), box_.x1 - width_of(time_unit()));
    add_text(time_unit(), {unit_x, baseline}, 0.0, style_.muted);
    for (const LinearAxis::Mark& mark : marks) {
      const double x = crisp(mark.px), half = 0.5 * width_of(mark.text);
      add_line({{x, frame_.y1}, {x, frame_.y1 + px(kTick)}}, px(kHairline), style_.muted);
      if (x - half >= box_.x0 && x + half <= unit_x - 0.5 * px(kUnitGap))
        add_text(mark.text, {x, baseline}, 0.5, style_.muted);
    }
  }

  /// As close as the width of their texts allows.
  std::vector<LinearAxis::Mark> time_marks() const {
    double spacing = px(plot_.is_path ? kMarkSpacing : kTimeMarkSpacing);
    for (;; spacing *= 1.5) {
      std::vector<LinearAxis::Mark> marks = time_.marks(spacing);
      for (LinearAxis::Mark& mark : marks) mark.text = with_decimals(std::move(mark.text), plot_.language);
      double widest = 0.0;
      for (const LinearAxis::Mark& mark : marks) widest = std::max(widest, width_of(mark.text));
      if (widest + px(0.6) <= spacing || marks.size() < 2) return marks;
    }
  }

  Vec2 at(double t, double y) const { return {time_.px(t), axis_.px(y)}; }

  std::vector<Stretch> stretches_of(const TimeSeries& series) const {
    std::vector<Stretch> stretches(1);
    const auto cut = [&] {
      if (!stretches.back().empty()) stretches.emplace_back();
    };
    const std::size_t count = std::min(plot_.t.size(), series.y.size());
    const auto shown = [&](std::size_t i) { return axis_.shows(series.y[i]) && std::isfinite(plot_.t[i]); };
    for (std::size_t i = 0; i < count; ++i) {
      if (!shown(i)) {
        cut();
        continue;
      }
      const bool is_inside = is_in_range(series.y[i]);
      if (i > 0 && shown(i - 1) && is_inside != is_in_range(series.y[i - 1])) {
        stretches.back().push_back(at_end_of_range(i, series));
        if (!is_inside) cut();
      }
      if (is_inside) stretches.back().push_back(at(plot_.t[i], series.y[i]));
    }
    if (stretches.back().empty()) stretches.pop_back();
    return stretches;
  }

  bool is_in_range(double y) const {
    return !plot_.range || (y >= plot_.range->first && y <= plot_.range->second);
  }

  /// Where the line to the ith point crosses the end of the range.
  Vec2 at_end_of_range(std::size_t i, const TimeSeries& series) const {
    const double a = series.y[i - 1], b = series.y[i];
    const double end = std::max(a, b) > plot_.range->second ? plot_.range->second : plot_.range->first;
    return at(std::lerp(plot_.t[i - 1], plot_.t[i], (end - a) / (b - a)), end);
  }

  void add_curve(const TimeSeries& series) {
    for (const Stretch& stretch : stretches_of(series)) {
      if (stretch.size() == 1)
        add_disc(stretch.front(), px(0.5 * kCurve), line_color(series));
      else
        add_line(simplified(stretch, kSimplification), px(plot_.is_path ? kPath : kCurve), line_color(series),
                 px(series.dash));
    }
  }

  void add_disc(const Vec2& middle, double radius, const Color& color) {
    sheet_.shapes.push_back(Stroke{{middle, middle}, 2.0 * radius, color, 0.0});
  }

  void add_names() {
    if (!has_names()) return;
    std::vector<const TimeSeries*> named;
    std::vector<Vec2> ends;
    std::vector<double> wanted;
    for (const TimeSeries& series : plot_.series) {
      const std::vector<Stretch> stretches = stretches_of(series);
      if (stretches.empty()) continue;
      named.push_back(&series);
      ends.push_back(plot_.is_path ? rightmost_of(stretches) : stretches.back().back());
      wanted.push_back(ends.back().y());
    }
    const std::vector<double> placed =
        spread_apart(wanted, px(kNameSpacing), frame_.y0 - px(0.3), frame_.y1 - px(0.2));
    for (std::size_t i = 0; i < named.size(); ++i) {
      // Of a curve that leaves the range the name stands where it does.
      const bool leaves = plot_.range && ends[i].x() < frame_.x1 - px(0.5);
      const Vec2 name((leaves ? ends[i].x() : frame_.x1) + px(kNameGap), placed[i]);
      if (!leaves && (std::abs(placed[i] - wanted[i]) > px(kLeaderFrom) || ends[i].x() < frame_.x1 - px(0.5)))
        add_line({ends[i], {name.x() - px(0.12), name.y()}}, px(kLeader), name_color(*named[i]));
      add_text(name_of(*named[i]), {name.x(), std::round(name.y() + px(0.5 * kCapHeight))}, 0.0,
               name_color(*named[i]), box_.x1 - name.x(), paper_halo());
    }
  }

  static Vec2 rightmost_of(const std::vector<Stretch>& stretches) {
    Vec2 rightmost = stretches.front().front();
    for (const Stretch& stretch : stretches)
      for (const Vec2& point : stretch)
        if (point.x() > rightmost.x()) rightmost = point;
    return rightmost;
  }

  void add_point(const Vec2& at, const TimeSeries& series) {
    add_disc(at, px(kDot + kDotRim), style_.paper);
    add_disc(at, px(kDot), line_color(series));
  }

  void add_now() {
    if (plot_.is_path) return add_now_on_path();
    if (!plot_.now || !std::isfinite(*plot_.now) || plot_.t.empty()) return;
    if (*plot_.now < plot_.t.front() || *plot_.now > plot_.t.back()) return;
    const double x = crisp(time_.px(*plot_.now));
    add_line({{x, frame_.y0}, {x, frame_.y1}}, px(kAxisLine), between(style_.muted, style_.paper, 0.2F));
    for (const TimeSeries& series : plot_.series)
      if (const std::optional<double> y = px_now(series)) add_point({x, *y}, series);
  }

  void add_now_on_path() {
    if (!plot_.now || !std::isfinite(*plot_.now)) return;
    for (std::size_t i = 0; i < std::min(plot_.series.size(), plot_.y_now.size()); ++i)
      if (axis_.shows(plot_.y_now[i]) && is_in_range(plot_.y_now[i]))
        add_point(at(*plot_.now, plot_.y_now[i]), plot_.series[i]);
  }

  /// On the drawn line.
  std::optional<double> px_now(const TimeSeries& series) const {
    const auto after = std::lower_bound(plot_.t.begin(), plot_.t.end(), *plot_.now);
    const auto i = static_cast<std::size_t>(after - plot_.t.begin());
    const std::size_t before = *after == *plot_.now || i == 0 ? i : i - 1;
    if (i >= series.y.size() || !axis_.shows(series.y[i]) || !axis_.shows(series.y[before]) ||
        !is_in_range(series.y[i]) || !is_in_range(series.y[before]))
      return std::nullopt;
    const double part = before == i ? 0.0 : (*plot_.now - plot_.t[before]) / (plot_.t[i] - plot_.t[before]);
    return std::lerp(axis_.px(series.y[before]), axis_.px(series.y[i]), part);
  }

  const TimePlot& plot_;
  PixelBox box_;
  TimePlotStyle style_;
  const Fonts& fonts_;
  ValueAxis axis_;
  LinearAxis time_;
  PlotMargins margins_;
  PixelBox frame_;  ///< the axes' rectangle
  Sheet sheet_;
};

}  // namespace

PlotMargins margins_of(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style,
                       const Fonts& fonts) {
  return TimePlotLayout(plot, box, style, fonts).margins();
}

double PlotReading::x_at(double px) const {
  const double part = (std::clamp(px, frame.x0, frame.x1) - frame.x0) / (frame.x1 - frame.x0);
  return x.empty() ? 0.0 : std::lerp(x.front(), x.back(), part);
}

std::size_t PlotReading::nearest(double px) const {
  const auto after = std::lower_bound(x_px.begin(), x_px.end(), px);
  if (after == x_px.begin()) return 0;
  const auto i = static_cast<std::size_t>(after - x_px.begin());
  return i < x_px.size() && x_px[i] - px < px - x_px[i - 1] ? i : i - 1;
}

std::optional<PlotReading> reading_of(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style,
                                      const Fonts& fonts) {
  if (plot.is_path || plot.t.empty()) return std::nullopt;
  return TimePlotLayout(plot, box, style, fonts).reading();
}

Sheet lay_out(const TimePlot& plot, const PixelBox& box, const TimePlotStyle& style, const Fonts& fonts) {
  return TimePlotLayout(plot, box, style, fonts).make();
}

}  // namespace polhode
