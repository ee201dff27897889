// SPDX-License-Identifier: MIT
#include "render/drawing/linear_axis.h"

#include "base/numbers.h"
#include "render/drawing/log_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {
namespace {

constexpr int kFewestDigits = -2, kMostDigits = 4;  // exponents of values that are written as they are
constexpr double kRounding = 1e-9;                  // of a step: a mark at an end of the axis counts as on it
constexpr int kMostMarks = 100;

/// Two factors, because 10^n alone may overflow or be subnormal where the product is neither.
double times_power_of_ten(double value, int n) {
  return value * std::pow(10.0, n / 2) * std::pow(10.0, n - n / 2);
}

/// Of the values up to `size` > 0, the power of ten that is taken out.
int exponent_for(double size) {
  const int digits = static_cast<int>(std::floor(std::log10(size)));
  if (digits >= kFewestDigits && digits <= kMostDigits) return 0;
  return 3 * static_cast<int>(std::floor(digits / 3.0));
}

struct Step {
  double length;
  int decimals;  ///< that tell its multiples apart
};

Step step_number(int n) {
  constexpr std::array<double, 3> kParts = {1.0, 2.0, 5.0};
  const int power = static_cast<int>(std::floor(n / 3.0));
  return {kParts[static_cast<std::size_t>(n - 3 * power)] * std::pow(10.0, power), std::max(0, -power)};
}

/// The smallest of 1, 2, 5, 10, … (and of their parts) that is at least `length` > 0.
int step_at_least(double length) {
  int n = 3 * static_cast<int>(std::floor(std::log10(length))) - 1;
  while (step_number(n).length < length * (1.0 - kRounding)) ++n;
  return n;
}

std::string written(double value, int decimals) {
  constexpr std::size_t kMostSigns = 64;
  const std::string text = fixed(std::abs(value), decimals);
  if (text.size() > kMostSigns) return short_number(value);
  const bool negative = value < 0.0 && text.find_first_of("123456789") != text.npos;
  return (negative ? "−" : "") + text;
}

}  // namespace

LinearAxis LinearAxis::between(double low, double high) {
  LinearAxis axis;
  double size = std::max(std::abs(low), std::abs(high));
  if (size == 0.0) size = 1.0;
  axis.exponent = exponent_for(size);
  axis.low = times_power_of_ten(low, -axis.exponent);
  axis.high = times_power_of_ten(high, -axis.exponent);
  const double least = 1e-12 * times_power_of_ten(size, -axis.exponent);  // fewer digits than a label shows
  if (!(axis.high - axis.low > least)) {
    axis.low -= 1e6 * least;
    axis.high += 1e6 * least;
  }
  return axis;
}

LinearAxis LinearAxis::covering(const std::vector<double>& values) {
  double low = 0.0, high = 0.0;
  for (double value : values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return between(low, low == high ? 1.0 : high);
}

LinearAxis LinearAxis::around(const std::vector<double>& values) {
  constexpr double kSame = 1e-6, kBeside = 0.05;  // of the largest
  double low = 0.0, high = 0.0, size = 0.0;
  bool is_first = true;
  for (double value : values) {
    if (!std::isfinite(value)) continue;
    low = is_first ? value : std::min(low, value);
    high = is_first ? value : std::max(high, value);
    size = std::max(size, std::abs(value));
    is_first = false;
  }
  if (high - low > kSame * size) return between(low, high);
  const double beside = size > 0.0 ? kBeside * size : 1.0;
  return between(low - beside, high + beside);
}

bool LinearAxis::shows(double value) const { return std::isfinite(value); }

double LinearAxis::px(double value) const {
  return std::lerp(start_px, end_px, (times_power_of_ten(value, -exponent) - low) / (high - low));
}

void LinearAxis::round_out(int intervals) {
  const auto lower = [this](double step) { return std::floor(low / step + kRounding); };
  const auto upper = [this](double step) { return std::ceil(high / step - kRounding); };
  int n = step_at_least((high - low) / intervals);
  while (upper(step_number(n).length) - lower(step_number(n).length) > intervals) ++n;
  rounded_to_ = n;
  const double step = step_number(n).length, first = lower(step), last = upper(step);
  low = first * step;
  high = last * step;
}

std::vector<LinearAxis::Mark> LinearAxis::marks(double min_spacing_px) const {
  const double length_px = std::max(1.0, std::abs(end_px - start_px));
  const double part = std::clamp(min_spacing_px / length_px, 1.0 / kMostMarks, 1.0);
  const Step step = step_number(rounded_to_.value_or(step_at_least((high - low) * part)));
  std::vector<Mark> marks;
  const double first = std::ceil(low / step.length - kRounding);
  for (int i = 0; i <= kMostMarks; ++i) {
    const double at = (first + i) * step.length;
    if (at > high + kRounding * step.length) break;
    marks.push_back({std::lerp(start_px, end_px, (at - low) / (high - low)), written(at, step.decimals)});
  }
  return marks;
}

std::string LinearAxis::unit_of(const std::string& unit) const {
  if (exponent == 0) return unit;
  return power_of_ten(exponent) + (unit.empty() ? "" : " " + unit);
}

}  // namespace polhode
