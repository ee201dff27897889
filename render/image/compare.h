// SPDX-License-Identifier: MIT
// Comparison of two images by the golden rule.
#pragma once

#include "render/image/image.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace polhode {

/// The golden rule: equal size, at most 0.02 % of the pixels off by more than 3 levels in any channel, none
/// by more than 48. Counting pixels catches what averages (RMS, SSIM) hide.
inline constexpr int kGoldenLevels = 3;
inline constexpr double kGoldenFraction = 2e-4;
inline constexpr int kGoldenMax = 48;

struct Comparison {
  bool same_size = false;
  std::int64_t pixels = 0;
  /// Pixels with a channel (alpha included, values as stored) off by more than 3 levels.
  std::int64_t over_3 = 0;
  int max = 0;  ///< largest difference of any channel, levels
  double over_fraction() const {
    return pixels ? static_cast<double>(over_3) / static_cast<double>(pixels) : 0.0;
  }
  bool equal() const { return same_size && over_fraction() <= kGoldenFraction && max <= kGoldenMax; }
};

/// Counts pixels of both, as many as there are, into what was found so far.
void add_differences(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, Comparison& found);

/// All counts are zero if the sizes differ.
Comparison compare_images(const Image& a, const Image& b);

/// Where and how much they differ: `a` in pale grey, differing pixels in red, stronger where larger. Sizes
/// may differ.
Image difference_image(const Image& a, const Image& b);

/// Guard against comparing nothing with nothing: fewer than 3 colours, or more than 98 % of one colour.
inline constexpr std::size_t kMinColors = 3;
inline constexpr double kMinDrawn = 0.02;
bool is_blank(const Image& image);

}  // namespace polhode
