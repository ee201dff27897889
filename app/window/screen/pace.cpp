// SPDX-License-Identifier: MIT
#include "app/window/screen/pace.h"

namespace polhode {

/// Down as soon as the mean says so; up only if even twice the cost of the finer level's pixels would do, so
/// that it does not swing between two.
void Pace::drew(double seconds) {
  constexpr int kFirst = 3, kLong = 60;
  mean_s_ = frames_ == 0 ? seconds : mean_s_ + kMemory * (seconds - mean_s_);
  ++frames_;
  const auto change_to = [&](std::size_t level) {
    level_ = level;
    frames_ = 0;
  };
  if (frames_ >= kFirst && mean_s_ > kMostSeconds && level_ + 1 < kLevels.size())
    return change_to(level_ + 1);
  if (frames_ < kLong || level_ == 0) return;
  const double ratio = kLevels[level_ - 1] / kLevels[level_];
  if (mean_s_ * ratio * ratio < 0.8 * kMostSeconds) change_to(level_ - 1);
}

}  // namespace polhode
