// SPDX-License-Identifier: MIT
#include "app/page/plot_words.h"

#include "app/narration/number_text.h"
#include "app/page/figure_place.h"
#include "base/words/formula_words.h"
#include "base/words/page_words.h"
#include "base/words/speech_words.h"
#include "render/drawing/plots/meter_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

namespace {

constexpr int kDigits = 3;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return !(low <= high); }
  double height() const { return high - low; }
};

Range range_of(const std::vector<double>& values) {
  Range range;
  for (const double value : values) range.add(value);
  return range;
}

/// A curve on its axis: of a logarithmic one the heights are powers of ten.
class Course {
 public:
  Course(const TimePlot& plot, const TimeSeries& curve) : plot_(plot), language_(plot.language) {
    for (const double value : curve.y) {
      leaves_ =
          plot.range && std::isfinite(value) && !(plot.range->first <= value && value <= plot.range->second);
      is_outside_ = is_outside_ || leaves_;
      if (!std::isfinite(value) || leaves_) continue;  // what lies outside is not drawn
      is_cut_ = is_cut_ || (plot.log_floor && value < *plot.log_floor);
      y_.push_back(height_of(value));
      is_zero_ = is_zero_ && value == 0.0;
    }
    range_ = range_of(y_);
  }

  std::string words() const {
    if (y_.empty())
      return std::string((is_outside_ ? words::kOutsideThePlot : words::kNotDefined).in(language_));
    if (is_zero_) return words::kStaysAt.with(language_, {with_unit("0")});
    constexpr double kLeastChange = 1e-3;
    if (range_.height() <= kLeastChange * height_of_plot())
      return words::kStaysAt.with(language_, {with_unit(number(0.5 * (range_.low + range_.high)))});
    const std::vector<double> turns = turning_points();
    constexpr std::size_t kMostTold = 4;
    return (turns.size() > kMostTold ? oscillation(turns) : in_turn(turns)) +
           std::string(leaves_ ? words::kThenLeaves.in(language_) : "");
  }

 private:
  double height_of(double value) const {
    return plot_.log_floor ? std::log10(std::max(value, *plot_.log_floor)) : value;
  }
  std::string number(double height) const {
    const double value = plot_.log_floor ? std::pow(10.0, height) : height;
    const double last = 1e-3 * std::max(std::abs(range_.low), std::abs(range_.high));
    if (is_cut_ && value <= *plot_.log_floor * (1.0 + 1e-9))  // what lies below is drawn there
      return words::kAtMost.with(language_, {short_number_words(*plot_.log_floor, kDigits, language_)});
    return short_number_words(!plot_.log_floor && std::abs(value) < last ? 0.0 : value, kDigits, language_);
  }
  std::string with_unit(const std::string& number) const {
    return polhode::with_unit(number, plot_.unit, language_);
  }

  /// Of what is drawn: an axis that need not show 0 is as high as its curves.
  double height_of_plot() const {
    Range all;
    if (!plot_.is_tight && !plot_.is_path && !plot_.log_floor) all.add(0.0);
    for (const TimeSeries& series : plot_.series)
      for (const double value : series.y)
        if (std::isfinite(value)) all.add(height_of(value));
    if (plot_.range) all = {height_of(plot_.range->first), height_of(plot_.range->second)};
    // What rounding leaves of a curve that alone is drawn is no height.
    return std::max(all.height(), 1e-6 * std::max(std::abs(all.low), std::abs(all.high)));
  }

  /// Where it begins, each top and bottom, where it ends.
  std::vector<double> turning_points() const {
    constexpr double kLeastTurn = 0.05;
    const double least = kLeastTurn * range_.height();
    std::vector<double> turns = {y_.front()};
    double top = y_.front(), bottom = y_.front();
    int direction = 0;
    for (const double y : y_) {
      top = std::max(top, y);
      bottom = std::min(bottom, y);
      if (direction <= 0 && y - bottom > least) {
        if (direction < 0) turns.push_back(bottom);
        direction = 1;
        top = y;
      } else if (direction >= 0 && top - y > least) {
        if (direction > 0) turns.push_back(top);
        direction = -1;
        bottom = y;
      }
    }
    turns.push_back(y_.back());
    return turns;
  }

  std::string in_turn(const std::vector<double>& turns) const {
    std::string text;
    for (std::size_t i = 1; i < turns.size(); ++i) {
      const bool rises = turns[i] > turns[i - 1];
      const std::string to = i + 1 == turns.size() ? with_unit(number(turns[i])) : number(turns[i]);
      text += i == 1 ? (rises ? words::kRises : words::kFalls).with(language_, {number(turns[0]), to})
                     : (rises ? words::kThenRises : words::kThenFalls).with(language_, {to});
    }
    return text;
  }

  std::string oscillation(const std::vector<double>& turns) const {
    constexpr double kAlike = 0.1;
    Range tops, bottoms;
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < turns.size(); ++i) {
      const bool is_top = turns[i] > turns[i - 1];
      (is_top ? tops : bottoms).add(turns[i]);
      count += is_top ? 1 : 0;
    }
    const double most = kAlike * range_.height();
    const bool is_even = tops.height() <= most && bottoms.height() <= most;
    return (is_even ? words::kOscillates : words::kGoesUpAndDown)
        .with(language_, {number(range_.low), with_unit(number(range_.high)),
                          count == 1 ? std::string(words::kAMaximum.in(language_))
                                     : words::kMaxima.with(language_, {std::to_string(count)})});
  }

  const TimePlot& plot_;
  Language language_;
  std::vector<double> y_;
  bool is_zero_ = true;
  bool is_cut_ = false;      ///< something lies below the axis of a logarithmic plot
  bool is_outside_ = false;  ///< something lies outside of what is drawn
  bool leaves_ = false;      ///< its end lies outside of what is drawn
  Range range_;
};

/// Of a path, on which x goes back and forth.
std::string path_in_words(const TimePlot& plot, const TimeSeries& curve) {
  const Range y = range_of(curve.y), x = range_of(plot.t);
  if (y.empty() || x.empty()) return std::string(words::kNotDefined.in(plot.language));
  const double last = 1e-3 * y.height();
  const auto number = [&](double value) {
    return short_number_words(std::abs(value) < last ? 0.0 : value, kDigits, plot.language);
  };
  constexpr double kNear = 0.03;
  const bool closes = std::abs(curve.y.back() - curve.y.front()) <= kNear * y.height() &&
                      std::abs(plot.t.back() - plot.t.front()) <= kNear * x.height();
  return words::kPathBetween.with(plot.language,
                                  {number(y.low), with_unit(number(y.high), plot.unit, plot.language)}) +
         std::string(closes ? words::kPathCloses.in(plot.language) : "");
}

std::string plot_in_words(const TimePlot& plot, const SpeechText& names) {
  const Language language = plot.language;
  const Range x = range_of(plot.t);
  const auto number = [&](double value) { return short_number_words(value, kDigits, language); };
  const std::string of =
      plot.x_label.empty() ? std::string(words::kTime.in(language)) : names.words_of_line(plot.x_label);
  std::string text = plot.title.empty() ? "" : names.words_of_line(plot.title) + ", ";
  const std::string low = number(x.low), high = with_unit(number(x.high), plot.x_unit, language);
  const bool says_of = !plot.x_label.empty() && plot.title.ends_with(plot.x_label);  // "T against omega 1"
  if (!x.empty())
    text += says_of ? words::kFromTo.with(language, {low, high})
                    : words::kAgainstFromTo.with(language, {of, low, high});
  for (const TimeSeries& curve : plot.series)
    text += (&curve == plot.series.data() ? "" : "; ") + names.words_of_line(curve.label) + ": " +
            course_in_words(plot, curve);
  return text + '.';
}

}  // namespace

std::string course_in_words(const TimePlot& plot, const TimeSeries& curve) {
  const bool goes_on = std::is_sorted(plot.t.begin(), plot.t.end());
  return plot.is_path && !goes_on ? path_in_words(plot, curve) : Course(plot, curve).words();
}

std::string words_of_plots(const SceneModel& model, double t_s, const SpeechText& names, bool is_asked) {
  if (is_asked) return names.words_of_plots(model.scene);
  const std::vector<const SceneModel*> shown = shown_models(model);
  const bool has_each = shown.size() > 1 && (each_has_meters(model) || is_plots_alone(model));
  std::string text;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!has_each && shown[i] != &model) continue;
    const std::vector<TimePlot> plots = meter_plots(*shown[i], t_s);
    if (plots.empty()) continue;
    if (!text.empty()) text += ' ';
    if (has_each) text += words::kScene.with(model.scene.language, {std::to_string(i + 1)});
    for (const TimePlot& plot : plots)
      text += (&plot == plots.data() ? "" : " ") + plot_in_words(plot, names);
  }
  return text;
}

}  // namespace polhode
