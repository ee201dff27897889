// SPDX-License-Identifier: MIT
#include "app/page/plot_words.h"

#include "app/narration/number_text.h"
#include "app/page/figure_place.h"
#include "base/words/formula_words.h"
#include "base/words/page_words.h"
#include "base/words/speech_words.h"
#include "render/drawing/diagrams/diagrams.h"
#include "render/drawing/plots/meter_plots.h"
#include "render/scene/model/scene_needs.h"

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
    for (std::size_t i = 0; i < curve.y.size(); ++i) {
      const double value = curve.y[i];
      leaves_ =
          plot.range && std::isfinite(value) && !(plot.range->first <= value && value <= plot.range->second);
      is_outside_ = is_outside_ || leaves_;
      if (!std::isfinite(value) || leaves_) continue;  // what lies outside is not drawn
      is_cut_ = is_cut_ || (plot.log_floor && value < *plot.log_floor);
      x_.push_back(plot.t[i]);
      y_.push_back(height_of(value));
      is_zero_ = is_zero_ && value == 0.0;
    }
    range_ = range_of(y_);
  }

  /// How it goes.
  std::string words() const {
    if (y_.empty()) return nothing();
    if (is_flat()) return words::kStaysAt.with(language_, {with_unit(number(middle()))});
    const std::vector<std::size_t> turns = turning_points();
    constexpr std::size_t kMostTold = 4;
    return (turns.size() > kMostTold ? oscillation(turns) : in_turn(turns)) + end();
  }

  /// What is read from it at both ends, at each top and bottom and halfway between them; without what is
  /// halfway where those are many, and evenly where they are too many.
  std::string readings() const {
    if (y_.empty()) return nothing();
    const bool flat = is_flat();
    const std::vector<std::size_t> turns =
        flat ? std::vector<std::size_t>{0, y_.size() - 1} : turning_points();
    constexpr std::size_t kMostHalved = 13, kEven = 24;
    std::vector<std::size_t> read = {0};
    if (turns.size() <= kEven + 1)
      for (std::size_t i = 1; i < turns.size(); ++i) {
        if (turns.size() <= kMostHalved) read.push_back((turns[i - 1] + turns[i]) / 2);
        read.push_back(turns[i]);
      }
    else
      for (std::size_t i = 1; i <= kEven; ++i) read.push_back(i * (y_.size() - 1) / kEven);
    std::string text;
    for (const std::size_t& i : read) {
      const std::string value = number(flat ? middle() : y_[i]);
      if (!text.empty()) text += ", ";
      text += words::kReadAt.with(language_, {&i == &read.back() ? with_unit(value) : value,
                                              short_number_words(x_[i], kDigits, language_)});
    }
    return text + end();
  }

 private:
  std::string nothing() const {
    return std::string((is_outside_ ? words::kOutsideThePlot : words::kNotDefined).in(language_));
  }
  /// No change of it can be seen in the plot.
  bool is_flat() const {
    constexpr double kLeastChange = 1e-3;
    return is_zero_ || range_.height() <= kLeastChange * height_of_plot();
  }
  double middle() const { return 0.5 * (range_.low + range_.high); }
  std::string end() const { return std::string(leaves_ ? words::kThenLeaves.in(language_) : ""); }
  double height_of(double value) const {
    return plot_.log_floor ? std::log10(std::max(value, *plot_.log_floor)) : value;
  }
  std::string number(double height) const {
    if (is_zero_) return "0";
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
  std::vector<std::size_t> turning_points() const {
    constexpr double kLeastTurn = 0.05;
    const double least = kLeastTurn * range_.height();
    std::vector<std::size_t> turns = {0};
    std::size_t top = 0, bottom = 0;
    int direction = 0;
    for (std::size_t i = 0; i < y_.size(); ++i) {
      if (y_[i] > y_[top]) top = i;
      if (y_[i] < y_[bottom]) bottom = i;
      if (direction <= 0 && y_[i] - y_[bottom] > least) {
        if (direction < 0) turns.push_back(bottom);
        direction = 1;
        top = i;
      } else if (direction >= 0 && y_[top] - y_[i] > least) {
        if (direction > 0) turns.push_back(top);
        direction = -1;
        bottom = i;
      }
    }
    turns.push_back(y_.size() - 1);
    return turns;
  }

  std::string in_turn(const std::vector<std::size_t>& turns) const {
    std::string text;
    for (std::size_t i = 1; i < turns.size(); ++i) {
      const double from = y_[turns[i - 1]], y = y_[turns[i]];
      const bool rises = y > from;
      const std::string to = i + 1 == turns.size() ? with_unit(number(y)) : number(y);
      text += i == 1 ? (rises ? words::kRises : words::kFalls).with(language_, {number(from), to})
                     : (rises ? words::kThenRises : words::kThenFalls).with(language_, {to});
    }
    return text;
  }

  std::string oscillation(const std::vector<std::size_t>& turns) const {
    constexpr double kAlike = 0.1;
    Range tops, bottoms;
    int count = 0;
    for (std::size_t i = 1; i + 1 < turns.size(); ++i) {
      const bool is_top = y_[turns[i]] > y_[turns[i - 1]];
      (is_top ? tops : bottoms).add(y_[turns[i]]);
      count += is_top ? 1 : 0;
    }
    const double most = kAlike * range_.height();
    // A curve that begins or ends at its top has one there.
    const bool at_start = y_.front() >= tops.low - most, at_end = y_.back() >= tops.low - most;
    count += (at_start ? 1 : 0) + (at_end ? 1 : 0);
    const Phrase& where = at_start && at_end ? words::kOneAtEachEnd
                          : at_start         ? words::kOneAtTheStart
                                             : words::kOneAtTheEnd;
    const bool is_even = tops.height() <= most && bottoms.height() <= most;
    return (is_even ? words::kOscillates : words::kGoesUpAndDown)
               .with(language_, {number(range_.low), with_unit(number(range_.high)),
                                 count == 1 ? std::string(words::kAMaximum.in(language_))
                                            : words::kMaxima.with(language_, {std::to_string(count)})}) +
           std::string(at_start || at_end ? where.in(language_) : "");
  }

  const TimePlot& plot_;
  Language language_;
  std::vector<double> x_, y_;
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

std::string plot_in_words(const TimePlot& plot, const SpeechText& names, bool is_asked) {
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
            (is_asked ? Course(plot, curve).readings() : course_in_words(plot, curve));
  return text + '.';
}

}  // namespace

std::string course_in_words(const TimePlot& plot, const TimeSeries& curve) {
  const bool goes_on = std::is_sorted(plot.t.begin(), plot.t.end());
  return plot.is_path && !goes_on ? path_in_words(plot, curve) : Course(plot, curve).words();
}

std::string words_of_plots(const SceneModel& model, double t_s, const SpeechText& names, bool is_asked) {
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
      text += (&plot == plots.data() ? "" : " ") + plot_in_words(plot, names, is_asked);
  }
  return text;
}

std::string words_of_diagrams(const SceneModel& model, double t_s, const SpeechText& names,
                              const Fonts& fonts) {
  const PixelBox box{0, 0, 1280, 800};  // decides how the parts of a diagram are arranged
  std::string text;
  for (const SceneModel* shown : shown_models(model)) {
    for (const Overlay diagram : diagrams_in(drawn_overlays(shown->scene))) {
      if (diagram == Overlay::order_plot) continue;
      std::string told;
      for (const PlacedType& type : lay_out_diagram(diagram, *shown, t_s, box, {}, fonts).texts)
        if (!type.text.empty()) told += (told.empty() ? "" : "; ") + names.words_of_line(type.text);
      if (!told.empty()) text += (text.empty() ? "" : " ") + told + '.';
    }
  }
  return text;
}

std::string figure_in_words(const SceneModel& model, const std::vector<SceneInWords>& said, double t_s,
                            const SpeechText& names, const Fonts* fonts) {
  std::string text = alt_text(model, said, t_s);
  if (fonts != nullptr)
    if (const std::string diagrams = words_of_diagrams(model, t_s, names, *fonts); !diagrams.empty())
      text += ' ' + names.opening(words::kInTheDiagram) + diagrams;
  const bool is_asked = !said.empty() && said.front().is_asked;
  if (const std::string plots = words_of_plots(model, t_s, names, is_asked); !plots.empty())
    text += ' ' + names.opening(words::kPlotted) + plots;
  return text;
}

}  // namespace polhode
