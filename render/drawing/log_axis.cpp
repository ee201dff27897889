// SPDX-License-Identifier: MIT
#include "render/drawing/log_axis.h"

#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {
namespace {

constexpr double kAir = 0.05;          // of the covered decades, at either end
constexpr double kLeastAir = 0.12;     // decades
constexpr double kLongestEmpty = 4.0;  // decades that are not cut
constexpr double kEmptyShare = 1.0 / 3.0;
constexpr double kLeastDecades = 2.0;
constexpr double kAirAtCut = 0.5;  // decades
constexpr double kMinorDecadePx = 60;

/// The widest stretch without a value.
std::pair<double, double> widest_gap(const std::vector<double>& sorted) {
  std::pair<double, double> widest{sorted.front(), sorted.front()};
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] - sorted[i - 1] > widest.second - widest.first) widest = {sorted[i - 1], sorted[i]};
  return widest;
}

std::string superscript(int n) {
  static constexpr std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = n < 0 ? "⁻" : "";
  for (char digit : std::to_string(std::abs(n))) text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string without_trailing_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string power_of_ten(int exponent) { return "10" + superscript(exponent); }

std::string short_number(double value) {
  if (value == 0.0) return "0";
  const std::string text = scientific(value, 1);  // d.de±dd
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  const std::string mantissa = without_trailing_zeros(text.substr(0, e));
  if (exponent >= -2 && exponent <= 3)
    return without_trailing_zeros(fixed(parse_number(text).value_or(value), std::max(0, 1 - exponent)));
  return (mantissa == "1" ? "" : mantissa + " × ") + power_of_ten(exponent);
}

LogAxis LogAxis::covering(const std::vector<double>& values, bool zero_allowed, bool cut_allowed) {
  LogAxis axis;
  std::vector<double> logs;
  for (double value : values) {
    if (value == 0.0 && zero_allowed) axis.has_zero = true;
    if (value > 0.0 && std::isfinite(value)) logs.push_back(std::log10(value));
  }
  if (logs.empty()) logs = {0.0};
  std::sort(logs.begin(), logs.end());

  const double span = logs.back() - logs.front();
  const double air = std::max({kAir * span, kLeastAir, 0.5 * (kLeastDecades - span)});
  axis.low = logs.front() - air;
  axis.high = logs.back() + air;
  const auto [below, above] = widest_gap(logs);
  if (cut_allowed && above - below > std::max(kLongestEmpty, kEmptyShare * span))
    axis.cut = {std::max(below + kAirAtCut, std::ceil(axis.low) + kLeastAir),
                std::min(above - kAirAtCut, std::floor(axis.high) - 1.0 - kLeastAir)};
  return axis;
}

bool LogAxis::shows(double value) const {
  return std::isfinite(value) && (value > 0.0 || (value == 0.0 && has_zero));
}

double LogAxis::decade_px() const {
  const double gaps = gap_px * ((has_zero ? 1.5 : 0.0) + (cut ? 1.0 : 0.0));
  const double decades = high - low - (cut ? cut->second - cut->first : 0.0);
  return std::max(0.0, std::abs(end_px - start_px) - gaps) / decades;
}

double LogAxis::px(double value) const {
  return value > 0.0 ? px_of_log(std::log10(value)) : along(0.5 * gap_px);
}

double LogAxis::px_of_log(double log10_value) const {
  double decades = log10_value - low, gaps = has_zero ? 1.5 * gap_px : 0.0;
  if (cut && log10_value > cut->first) {
    const double in_cut = std::min(log10_value, cut->second) - cut->first;
    decades -= in_cut;
    gaps += gap_px * in_cut / (cut->second - cut->first);
  }
  return along(gaps + decades * decade_px());
}

double LogAxis::along(double length_px) const {
  return end_px < start_px ? start_px - length_px : start_px + length_px;
}

std::vector<double> LogAxis::gaps_px() const {
  std::vector<double> places;
  if (has_zero) places.push_back(along(gap_px));
  if (cut) places.push_back(px_of_log(0.5 * (cut->first + cut->second)));
  return places;
}

LogAxis::Marks LogAxis::marks(double min_spacing_px) const {
  constexpr std::array<int, 9> kSteps = {1, 2, 5, 10, 20, 50, 100, 200, 500};
  const double decade = decade_px();
  const auto enough =
      std::find_if(kSteps.begin(), kSteps.end(), [&](int n) { return n * decade >= min_spacing_px; });
  const int step = enough == kSteps.end() ? kSteps.back() : *enough;
  const auto hidden = [&](double log10_value) {
    return log10_value < low || log10_value > high ||
           (cut && log10_value > cut->first && log10_value < cut->second);
  };

  Marks marks;
  for (int n = static_cast<int>(std::floor(low)); n <= static_cast<int>(std::ceil(high)); ++n) {
    if (!hidden(n) && n % step == 0)
      marks.labelled.push_back(n);
    else if (!hidden(n))
      marks.minor.push_back(n);
    for (int k = 2; k <= 9 && step == 1 && decade >= kMinorDecadePx; ++k)
      if (const double at = n + std::log10(k); !hidden(at)) marks.minor.push_back(at);
  }
  return marks;
}

}  // namespace polhode
