// SPDX-License-Identifier: MIT
// With how many pixels figures are drawn while something moves: all of them, unless the machine is measured
// to be too slow.
#pragma once

#include <array>
#include <cstddef>

namespace polhode {

class Pace {
 public:
  /// A moving frame may take so long, s: 30 of them a second, with room for what else there is.
  static constexpr double kMostSeconds = 0.028;

  /// Part of the pixels each way for moving figures.
  double resolution() const { return kLevels[level_]; }
  /// A moving frame was drawn at resolution(), and took so long.
  void drew(double seconds);

 private:
  static constexpr std::array<double, 4> kLevels = {1.0, 0.75, 0.5, 0.35};
  static constexpr double kMemory = 0.2;  ///< of the running mean, of each new frame
  std::size_t level_ = 0;
  double mean_s_ = 0;
  int frames_ = 0;  ///< at this level
};

}  // namespace polhode
