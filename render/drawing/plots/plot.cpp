// SPDX-License-Identifier: MIT
#include "render/drawing/plots/plot.h"

#include "render/drawing/label_layout.h"
#include "render/drawing/log_axis.h"
#include "render/drawing/plots/plot_style.h"
#include "render/palette.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr Color kGood = color_from_hex(0xF3EEDF);  // where the tolerance is met

// Lengths in px of a picture 1080 px high.
constexpr double kMargin = 72, kMarginBesideNames = 24;
constexpr double kMostOfNames = 0.38;  // of the width, in a column
constexpr double kNameSpacing = 1.3,
                 kNameLeading = 1.15;  // between names there, and their lines; sizes of type
constexpr double kTitleSize = 44, kNoteSize = 26, kAxisTitleSize = 27, kTickSize = 26;
constexpr double kNameSize = 27, kQuietNameSize = 25, kExactNameSize = 32, kCalloutSize = 29;
constexpr double kNameAir = 0.12;  // of the size of type, around a name
constexpr double kTitleHeight = 100;
constexpr double kEndGap = 40;  // from the frame to a column of names
constexpr double kAirInDiagram =
    30;  // that a diagram has around a plot, so that this has less above and below
constexpr double kDecadeSpacing = 56;
constexpr double kRingRadius = 27;
constexpr LabelRules kNameRules{.starts = 8, .rounds = 3, .cost_covered = 0.5, .cost_crossed = 1.8};

std::vector<double> works_of(const WorkPrecisionPlot& plot) {
  std::vector<double> values;
  for (const PlotSeries& s : plot.series)
    for (const auto& p : s.points)
      if (std::isfinite(p.second) && p.second >= 0.0) values.push_back(p.first);
  return values;
}

std::vector<double> errors_of(const WorkPrecisionPlot& plot) {
  std::vector<double> values;
  for (const PlotSeries& s : plot.series)
    for (const auto& p : s.points)
      if (std::isfinite(p.first) && p.first > 0.0) values.push_back(p.second);
  if (plot.tolerance) values.push_back(*plot.tolerance);
  return values;
}

bool is_star(const PlotSeries& s) { return s.look == PlotLook::star; }

std::vector<CurveStyle> on_paper(std::vector<CurveStyle> styles, const Color& paper) {
  if (!is_dark(paper)) return styles;
  for (CurveStyle& style : styles) {
    style.ink = on_dark(style.ink);
    style.paint = on_dark(style.paint);
  }
  return styles;
}

/// Whether no other curve has a point that is as cheap and as good, and better in one of the two.
bool has_a_front_point(const PlotSeries& series, const std::vector<PlotSeries>& all) {
  const auto beaten = [&](const std::pair<double, double>& p) {
    for (const PlotSeries& other : all)
      for (const auto& q : other.points)
        if (!is_star(other) && q.first <= p.first && q.second <= p.second && q != p) return true;
    return !(std::isfinite(p.first) && std::isfinite(p.second));
  };
  return !std::all_of(series.points.begin(), series.points.end(), beaten);
}

/// Stars and what is emphasized; if that is no curve but stars, the Pareto front of the others.
std::vector<bool> strong_ones_of(const std::vector<PlotSeries>& all) {
  const bool told =
      std::any_of(all.begin(), all.end(), [](const PlotSeries& s) { return s.emphasized && !is_star(s); });
  std::vector<bool> strong;
  for (const PlotSeries& s : all)
    strong.push_back(is_star(s) || (told ? s.emphasized : has_a_front_point(s, all)));
  return strong;
}

/// Makes the sheet of one plot, part after part.
class PlotLayout {
 public:
  PlotLayout(const WorkPrecisionPlot& plot, double width, double height, const Fonts& fonts)
      : plot_(plot),
        fonts_(fonts),
        width_(width),
        unit_(plot.scale * std::min(height, width * 9.0 / 16.0) / 1080.0),
        x_(LogAxis::covering(works_of(plot), false, true)),
        y_(LogAxis::covering(errors_of(plot), true, false)),
        styles_(on_paper(styles_of(plot.series), plot.paper)),
        strong_(strong_ones_of(plot.series)) {
    place_axes(width, height);
    for (const PlotSeries& s : plot.series) curves_.push_back(curve_of(s));
  }

  Sheet make() {
    add_tolerance();
    add_grid();
    add_axes();
    add_titles();
    add_curves();
    add_names();
    return std::move(sheet_);
  }

 private:
  struct Name {
    const std::string* text;
    double size;
    Color ink;
    const CurveStyle* mark;  ///< stands before the text; null: none
    double mark_room() const { return mark ? 0.95 * size : 0.0; }
  };
  struct Curve {
    std::vector<Vec2> points;
    std::size_t best = 0;  ///< the point it is named at: after it more work gains nothing
  };

  DisplayList line_of(const std::string& text, double size, const Color& color) const {
    TextStyle style;
    style.size = size;
    style.color = color;
    style.sans = true;
    return set_line(text, style, fonts_);
  }
  double width_of(const std::string& text, double size) const { return line_of(text, size, plot_.ink).width; }

  double px(double length) const { return unit_ * length; }
  Color towards_paper(const Color& color, float f) const { return between(color, plot_.paper, f); }
  Color paper_halo() const { return {plot_.paper.r, plot_.paper.g, plot_.paper.b, 0.92F}; }
  /// Embedded in a diagram, which has its own.
  double margin() const { return plot_.names_at_end ? kMarginBesideNames : kMargin; }
  /// Of what stands above the frame, in a plot without a title.
  double raised() const { return plot_.title.empty() ? kTitleHeight : 0.0; }
  bool shows(const std::pair<double, double>& p) const { return x_.shows(p.first) && y_.shows(p.second); }
  Vec2 at(const std::pair<double, double>& p) const { return {x_.px(p.first), y_.px(p.second)}; }

  /// In a diagram the note has its place above the column of names, if that is wide enough.
  bool has_note_beside(double width) const {
    return plot_.names_at_end && plot_.title.empty() &&
           width_of(plot_.y_label, px(kAxisTitleSize)) + width_of(plot_.note, px(kNoteSize)) <
               width - px(2 * margin() + kEndGap);
  }

  /// The lines of a curve's name.
  std::vector<std::string> name_of(const PlotSeries& s) const {
    if (!plot_.names_at_end || s.detail.empty()) return {s.label};
    if (has_two_lines_) return {s.label, s.detail};
    return {s.label + ", " + s.detail};
  }
  double widest_of_names() const {
    double widest = 0.0;
    for (const PlotSeries& s : plot_.series)
      for (const std::string& line : name_of(s)) widest = std::max(widest, width_of(line, px(kNameSize)));
    return widest;
  }

  void place_axes(double width, double height) {
    const bool has_line_of_note = !plot_.note.empty() && !has_note_beside(width);
    const double above = (has_line_of_note ? 250 : 212) - raised();
    frame_ = {px(margin()), px(plot_.names_at_end ? above - kAirInDiagram : above), width - px(margin()),
              height - px(plot_.names_at_end ? 142 - kAirInDiagram : 142)};
    // Bottom first: the labels of the y axis depend on it, and its left end on them.
    for (LogAxis* axis : {&x_, &y_}) axis->gap_px = px(54);
    y_.start_px = frame_.y1;
    y_.end_px = frame_.y0;
    double widest = 0.0;
    for (int n : y_.marks(px(kDecadeSpacing)).labelled)
      widest = std::max(widest, width_of(power_of_ten(n), px(kTickSize)));
    frame_.x0 += widest + px(20);
    double widest_name = widest_of_names();
    if (plot_.names_at_end && widest_name > kMostOfNames * width) {
      const double sizes = static_cast<double>(plot_.series.size()) * (kNameSpacing + kNameLeading);
      has_two_lines_ = px(kNameSize) * sizes <= frame_.y1 - frame_.y0;
      widest_name = widest_of_names();
    }
    if (plot_.names_at_end && widest_name > kMostOfNames * width) {
      name_scale_ = kMostOfNames * width / widest_name;
      widest_name *= name_scale_;
    }
    frame_.x1 -= plot_.names_at_end ? widest_name + px(kEndGap + kNameSize)
                                    : std::min(0.75 * widest_name, 0.2 * width);
    if (shows_tolerance())
      frame_.x1 = std::min(frame_.x1, width - px(52) - width_of(tolerance_text(), px(kNameSize)));
    x_.start_px = frame_.x0;
    x_.end_px = frame_.x1;
    room_ = {frame_.x0 + px(8), frame_.y0 - px(8), width - px(28), frame_.y1 - px(6)};
  }

  Curve curve_of(const PlotSeries& s) const {
    Curve curve;
    std::vector<double> errors;
    for (const auto& p : s.points)
      if (shows(p)) curve.points.push_back(at(p)), errors.push_back(p.second);
    if (errors.empty()) return curve;
    constexpr double kAsGood = 3.0;  // rounding errors scatter by as much
    const double least = *std::min_element(errors.begin(), errors.end());
    const double limit =
        *std::max_element(errors.begin(), errors.end()) > 10.0 * least ? kAsGood * least : least;
    const auto first = std::find_if(errors.begin(), errors.end(), [&](double e) { return e <= limit; });
    curve.best = static_cast<std::size_t>(first - errors.begin());
    return curve;
  }

  void add_line(const Vec2& from, const Vec2& to, double width, const Color& color, double dash = 0.0) {
    sheet_.shapes.push_back(Stroke{{from, to}, width, color, dash});
  }

  void add_text(std::string text, const Vec2& where, double size, double align, const Color& color,
                const Color& halo = {0, 0, 0, 0}) {
    DisplayList line = line_of(text, size, color);
    const double left = where.x() - align * line.width;
    taken_.push_back({left, where.y() - 0.8 * size, left + line.width, where.y() + 0.25 * size});
    sheet_.texts.push_back(
        {.list = std::move(line), .at = {left, where.y()}, .halo = halo, .text = std::move(text)});
  }

  bool shows_tolerance() const { return plot_.tolerance && y_.shows(*plot_.tolerance); }
  std::string tolerance_text() const { return "tolerance " + short_number(*plot_.tolerance); }

  void add_tolerance() {
    if (!shows_tolerance()) return;
    const double y = std::round(y_.px(*plot_.tolerance));
    sheet_.shapes.push_back(
        Area{{{frame_.x0, y}, {frame_.x1, y}, {frame_.x1, frame_.y1}, {frame_.x0, frame_.y1}}, kGood});
  }

  void add_tolerance_line() {
    if (!shows_tolerance()) return;
    const double y = std::round(y_.px(*plot_.tolerance)) + 0.5;
    add_line({frame_.x0, y}, {frame_.x1, y}, px(2.2), plot_.ink, px(9));
    for (double x = frame_.x0; x <= frame_.x1; x += px(24)) obstacles_.emplace_back(x, y);
    add_text(tolerance_text(), {frame_.x1 + px(12), y + px(9)}, px(kNameSize), 0.0, plot_.ink);
  }

  void add_grid() {
    for (int n : x_.marks(px(1.6 * kDecadeSpacing)).labelled) {
      const double x = std::round(x_.px_of_log(n)) + 0.5;
      add_line({x, frame_.y0}, {x, frame_.y1}, px(1.2), plot_.grid);
    }
    for (int n : y_.marks(px(kDecadeSpacing)).labelled) {
      const double y = std::round(y_.px_of_log(n)) + 0.5;
      add_line({frame_.x0, y}, {frame_.x1, y}, px(1.2), plot_.grid);
    }
    add_tolerance_line();
  }

  void add_axes() {
    const Color line = towards_paper(plot_.muted, 0.25F), minor = towards_paper(plot_.muted, 0.5F);
    const double x0 = std::round(frame_.x0) + 0.5, y1 = std::round(frame_.y1) + 0.5;
    add_line({x0, y1}, {frame_.x1, y1}, px(1.6), line);
    add_line({x0, frame_.y0}, {x0, y1}, px(1.6), line);

    const LogAxis::Marks x_marks = x_.marks(px(1.6 * kDecadeSpacing)), y_marks = y_.marks(px(kDecadeSpacing));
    for (double mark : x_marks.minor)
      add_line({x_.px_of_log(mark), y1}, {x_.px_of_log(mark), y1 + px(5)}, px(1.1), minor);
    for (double mark : y_marks.minor)
      add_line({x0 - px(5), y_.px_of_log(mark)}, {x0, y_.px_of_log(mark)}, px(1.1), minor);
    for (int n : x_marks.labelled) {
      const double x = std::round(x_.px_of_log(n)) + 0.5;
      add_line({x, y1}, {x, y1 + px(9)}, px(1.5), line);
      add_text(power_of_ten(n), {x, y1 + px(42)}, px(kTickSize), 0.5, plot_.muted);
    }
    for (int n : y_marks.labelled) add_y_label(power_of_ten(n), y_.px_of_log(n), line);
    if (y_.has_zero) {
      add_line({frame_.x0, y_.px(0.0)}, {frame_.x1, y_.px(0.0)}, px(1.2), plot_.grid);
      add_y_label("0", y_.px(0.0), line);
    }
    for (double y : y_.gaps_px()) add_gap_mark({x0, y}, {0.0, 1.0});
    for (double x : x_.gaps_px()) add_gap_mark({x, y1}, {1.0, 0.0});
  }

  void add_y_label(const std::string& text, double y, const Color& line) {
    const double middle = std::round(y) + 0.5, x0 = std::round(frame_.x0) + 0.5;
    add_line({x0 - px(9), middle}, {x0, middle}, px(1.5), line);
    add_text(text, {x0 - px(18), middle + 0.35 * px(kTickSize)}, px(kTickSize), 1.0, plot_.muted);
  }

  /// Two slanted strokes across an axis that runs along `direction`, with nothing of it between them.
  void add_gap_mark(const Vec2& middle, const Vec2& direction) {
    const Vec2 across(direction.y(), direction.x());
    const Vec2 along = px(5) * direction, slant = px(10) * across - px(4) * direction;
    sheet_.shapes.push_back(Stroke{{middle - along, middle + along}, px(5), plot_.paper});
    for (const Vec2& foot : {Vec2(middle - along), Vec2(middle + along)})
      add_line(foot - slant, foot + slant, px(1.6), towards_paper(plot_.muted, 0.25F));
  }

  void add_titles() {
    const double left = px(margin());
    if (!plot_.title.empty()) add_text(plot_.title, {left, px(106)}, px(kTitleSize), 0.0, plot_.ink);
    const double y_of_label = frame_.y0 - px(30);
    if (!plot_.note.empty() && has_note_beside(width_))
      add_text(plot_.note, {width_ - left, y_of_label}, px(kNoteSize), 1.0, plot_.muted);
    else if (!plot_.note.empty())
      add_text(plot_.note, {left, px(152 - raised())}, px(kNoteSize), 0.0, plot_.muted);
    add_text(plot_.y_label, {left, y_of_label}, px(kAxisTitleSize), 0.0, plot_.ink);
    add_text(plot_.x_label, {0.5 * (frame_.x0 + frame_.x1), frame_.y1 + px(98)}, px(kAxisTitleSize), 0.5,
             plot_.ink);
  }

  bool strong(std::size_t i) const { return strong_[i]; }

  /// The quiet ones first, so that the others lie over them.
  void add_curves() {
    for (const bool strong_turn : {false, true})
      for (std::size_t i = 0; i < curves_.size(); ++i)
        if (strong(i) == strong_turn) add_curve(i);
    if (plot_.recommended && shows(*plot_.recommended)) add_ring(at(*plot_.recommended));
  }

  void add_curve(std::size_t i) {
    const Curve& curve = curves_[i];
    if (curve.points.empty()) return;
    const auto best = curve.points.begin() + static_cast<std::ptrdiff_t>(curve.best);
    CurveStyle quiet = styles_[i];
    quiet.paint = towards_paper(quiet.paint, strong(i) ? 0.55F : 0.42F);
    add_part({best, curve.points.end()}, px(2.4), px(5), quiet);
    if (strong(i))
      add_part({curve.points.begin(), best + 1}, px(4.6), mark_radius(i), styles_[i]);
    else
      add_part({curve.points.begin(), best + 1}, px(2.4), mark_radius(i), quiet);
    add_obstacles(curve.points);
  }

  double mark_radius(std::size_t i) const {
    return is_star(plot_.series[i]) ? px(15) : strong(i) ? px(8.5) : px(6.5);
  }

  void add_part(const std::vector<Vec2>& points, double width, double radius, const CurveStyle& style) {
    if (points.size() > 1) sheet_.shapes.push_back(Stroke{points, width, style.paint});
    for (const Vec2& p : points) add_mark(sheet_, p, radius, style, plot_.paper);
  }

  void add_obstacles(const std::vector<Vec2>& points) {
    for (const Vec2& p : points)
      for (const Vec2& d : {Vec2(0, 0), Vec2(7, 0), Vec2(-7, 0), Vec2(0, 7), Vec2(0, -7)})
        obstacles_.push_back(p + unit_ * d);
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vec2 d = points[k] - points[k - 1];
      const int n = std::max(1, static_cast<int>(d.norm() / px(16)));
      for (int j = 1; j < n; ++j) obstacles_.push_back(points[k - 1] + d * (static_cast<double>(j) / n));
    }
  }

  void add_ring(const Vec2& where) {
    std::vector<Vec2> circle;
    constexpr int kPieces = 64;
    for (int k = 0; k <= kPieces; ++k) {
      const double angle = 2.0 * 3.14159265358979323846 * k / kPieces;
      circle.push_back(where + px(kRingRadius) * Vec2(std::cos(angle), std::sin(angle)));
    }
    sheet_.shapes.push_back(Stroke{circle, px(3.2), plot_.ink});
    for (std::size_t k = 0; k < circle.size(); k += 8) obstacles_.push_back(circle[k]);
  }

  /// What is named, and where: the recommended point first, then the curves at their ends, from the ones that
  /// matter most.
  void add_names() {
    if (plot_.names_at_end) return add_names_at_end();
    std::vector<Name> names;
    std::vector<LabelRequest> requests;
    const auto request = [&](const Name& name, const Vec2& anchor, const Vec2& outward, double clear) {
      names.push_back(name);
      requests.push_back(
          {.anchor = anchor,
           .width = width_of(*name.text, name.size) + name.mark_room() + 2.0 * kNameAir * name.size,
           .height = (0.95 + 2.0 * kNameAir) * name.size,
           .outward = outward,
           .leader = true,
           .clear = clear,
           .close = true});
    };
    if (plot_.recommended && shows(*plot_.recommended) && !plot_.recommended_label.empty())
      request({&plot_.recommended_label, px(kCalloutSize), plot_.ink, nullptr}, at(*plot_.recommended),
              {0, 0}, px(kRingRadius));
    for (const bool exact_ones : {true, false})
      for (const bool strong_turn : {true, false})
        for (std::size_t i = 0; i < curves_.size(); ++i) {
          const bool is_exact = is_star(plot_.series[i]);
          if (is_exact != exact_ones || strong(i) != strong_turn || curves_[i].points.empty()) continue;
          const double size = is_exact ? kExactNameSize : strong(i) ? kNameSize : kQuietNameSize;
          request({&plot_.series[i].label, px(size), styles_[i].ink,
                   curves_[i].points.size() > 1 ? &styles_[i] : nullptr},
                  curves_[i].points[curves_[i].best], end_direction(curves_[i]), clear_of(i));
        }
    place_names(names, place_labels(requests, obstacles_, taken_, room_, kNameRules), requests);
  }

  void add_names_at_end() {
    const double size = name_scale_ * px(kNameSize), left = frame_.x1 + px(kEndGap);
    const double below = has_two_lines_ ? kNameLeading * size : 0.0;
    std::vector<std::size_t> named;
    std::vector<double> wanted;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (curves_[i].points.empty()) continue;
      named.push_back(i);
      wanted.push_back(curves_[i].points.back().y());
    }
    const std::vector<double> placed =
        spread_apart(wanted, kNameSpacing * size + below, frame_.y0, frame_.y1);
    for (std::size_t k = 0; k < named.size(); ++k) {
      const std::size_t i = named[k];
      const std::vector<std::string> lines = name_of(plot_.series[i]);
      const Vec2 end = curves_[i].points.back() + Vec2(1.6 * mark_radius(i), 0.0);
      const Vec2 name(left, placed[k] - (lines.size() > 1 ? 0.5 * below : 0.0));
      if (end.x() < name.x() - px(12))
        add_line(end, name - Vec2(px(6), 0.0), px(1.4), towards_paper(styles_[i].ink, 0.4F));
      add_mark(sheet_, name + Vec2(0.4 * size, 0.0), px(7.5), styles_[i], plot_.paper);
      for (std::size_t line = 0; line < lines.size(); ++line)
        sheet_.texts.push_back(
            {.list = line_of(lines[line], size, styles_[i].ink),
             .at = name + Vec2(0.95 * size, 0.35 * size + static_cast<double>(line) * below),
             .halo = paper_halo(),
             .text = lines[line]});
    }
  }

  /// What lies around the point a curve is named at.
  double clear_of(std::size_t i) const {
    const bool ringed =
        plot_.recommended && shows(*plot_.recommended) &&
        (at(*plot_.recommended) - curves_[i].points[curves_[i].best]).norm() < px(kRingRadius);
    return ringed ? px(kRingRadius) : 1.3 * mark_radius(i);
  }

  static Vec2 end_direction(const Curve& curve) {
    const Vec2& end = curve.points[curve.best];
    for (std::size_t k = curve.best; k-- > 0;)
      if (const Vec2 d = end - curve.points[k]; d.norm() > 1.0) return d.normalized();
    return {1.0, 0.0};
  }

  void place_names(const std::vector<Name>& names, const std::vector<PlacedLabel>& placed,
                   const std::vector<LabelRequest>& requests) {
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Name& name = names[i];
      const PixelBox box = placed[i].box.grown(-kNameAir * name.size);
      if (placed[i].has_leader) {
        const Vec2 way = (placed[i].leader_end - requests[i].anchor).normalized();
        add_line(requests[i].anchor + requests[i].clear * way, placed[i].leader_end, px(1.4), name.ink);
      }
      const double baseline = box.y1 - 0.22 * name.size;
      if (name.mark)
        add_mark(sheet_, {box.x0 + 0.32 * name.size, baseline - 0.35 * name.size}, px(7.5), *name.mark,
                 plot_.paper);
      sheet_.texts.push_back({.list = line_of(*name.text, name.size, name.ink),
                              .at = {box.x0 + name.mark_room(), baseline},
                              .halo = paper_halo(),
                              .text = *name.text});
    }
  }

  const WorkPrecisionPlot& plot_;
  const Fonts& fonts_;
  double width_;
  bool has_two_lines_ = false;  ///< names in a column that would leave no room for the curves; and their size
  double name_scale_ = 1;
  double unit_;  ///< px of this picture for one of a picture 1080 px high
  LogAxis x_, y_;
  std::vector<CurveStyle> styles_;
  std::vector<bool> strong_;
  PixelBox frame_;  ///< the axes' rectangle
  PixelBox room_;   ///< where names may stand
  std::vector<Curve> curves_;
  std::vector<Vec2> obstacles_;
  std::vector<PixelBox> taken_;
  Sheet sheet_;
};

}  // namespace

Sheet lay_out(const WorkPrecisionPlot& plot, double width_px, double height_px, const Fonts& fonts) {
  return PlotLayout(plot, width_px, height_px, fonts).make();
}

}  // namespace polhode
