// SPDX-License-Identifier: MIT
// A logarithmic axis: which decades it covers, where a value lies on it, where its marks stand. It has a
// place for 0, which has no logarithm, and can leave out decades in which nothing lies; both are told apart
// from the rest by a gap.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

/// "10⁻⁶"
std::string power_of_ten(int exponent);
/// "10⁻⁶", "3 × 10⁻⁷", "0.05", "20"; two significant digits of a finite value.
std::string short_number(double value);

struct LogAxis {
  double low = 0, high = 1;                        ///< log₁₀ of the values at its ends
  std::optional<std::pair<double, double>> cut{};  ///< log₁₀ of what is left out between them
  bool has_zero = false;                           ///< 0 lies half a gap from the start, `low` a gap further
  double start_px = 0, end_px = 1;                 ///< end may be the smaller
  double gap_px = 40;                              ///< between what is not continuous

  /// Covers all finite values > 0 with some air and at least two decades; 0 gets its place if it occurs and
  /// `zero_allowed`. A stretch of more than four empty decades, more than a third of all, is cut if
  /// `cut_allowed`; a decade is left before it, and two after it. Values that are negative or not finite do
  /// not count.
  static LogAxis covering(const std::vector<double>& values, bool zero_allowed, bool cut_allowed);

  bool shows(double value) const;  ///< whether it has a place: finite and > 0, or 0 where that is shown
  double px(double value) const;   ///< of a value that it shows
  double px_of_log(double log10_value) const;
  /// Middle of the gap above 0, and of the one at the cut, px.
  std::vector<double> gaps_px() const;

  struct Marks {
    std::vector<int> labelled;  ///< exponents of the decades with a grid line and a label
    std::vector<double> minor;  ///< log₁₀ of the marks between them
  };
  /// Labelled decades are multiples of 1, 2, 5, 10, … so that they stand at least `min_spacing_px` apart.
  /// Between labelled decades there are marks: at the other decades, or at 2…9 where there are none and a
  /// decade is long enough.
  Marks marks(double min_spacing_px) const;

 private:
  double decade_px() const;  ///< length of a decade
  double along(double length_px) const;
};

}  // namespace polhode
