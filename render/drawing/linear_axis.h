// SPDX-License-Identifier: MIT
// A linear axis: which values it covers, where a value lies on it, where its marks stand: at multiples of 1,
// 2 or 5 times a power of ten. Values of any size are written with few digits, as multiples of a power of
// ten that the axis' unit then names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace polhode {

struct LinearAxis {
  double low = 0, high = 1;         ///< its ends, in units of 10^exponent
  int exponent = 0;                 ///< a multiple of 3
  double start_px = 0, end_px = 1;  ///< end may be the smaller

  /// From `low` to `high`, both finite; where `high` is not above `low`, a little to both sides.
  static LinearAxis between(double low, double high);
  /// Covers all finite values and 0, so that lengths on it compare as the values do.
  static LinearAxis covering(const std::vector<double>& values);

  /// From the least to the largest finite value. Where they are the same but for what a computed motion's
  /// errors leave, a part of that value to both sides: what does not change is drawn flat.
  static LinearAxis around(const std::vector<double>& values);

  bool shows(double value) const;  ///< whether it has a place: finite
  double px(double value) const;   ///< of a value that it shows

  /// Moves both ends outwards to marks, with at most `intervals` ≥ 2 between them: the marks from then on.
  void round_out(int intervals);

  struct Mark {
    double px;
    std::string text;  ///< "−0.5": all marks of an axis have the same number of decimals
  };
  /// Those of round_out, else marks at least `min_spacing_px` apart.
  std::vector<Mark> marks(double min_spacing_px = 0) const;

  /// "s"; "10⁻⁶ s"
  std::string unit_of(const std::string& unit) const;

 private:
  std::optional<int> rounded_to_;  ///< number of the step between the marks at the ends
};

}  // namespace polhode
