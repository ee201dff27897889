// SPDX-License-Identifier: MIT
// How alike two pictures of the same size are that two drivers of OpenGL drew.
#pragma once

#include "render/image/image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace polhode {

inline double luma(const Image& image, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                             static_cast<std::size_t>(x));
  return 0.299 * image.rgba[i] + 0.587 * image.rgba[i + 1] + 0.114 * image.rgba[i + 2];
}

/// Wang, Bovik, Sheikh, Simoncelli, IEEE Trans. Image Process. 13 (2004) 600, of luma, in windows of 8 x 8
/// pixels, each 4 further: the mean.
inline double ssim(const Image& a, const Image& b) {
  constexpr int kWindow = 8, kStep = 4, kCount = kWindow * kWindow;
  constexpr double kC1 = 0.01 * 255 * 0.01 * 255, kC2 = 0.03 * 255 * 0.03 * 255;
  double sum = 0;
  int windows = 0;
  for (int top = 0; top + kWindow <= a.size.height; top += kStep)
    for (int left = 0; left + kWindow <= a.size.width; left += kStep, ++windows) {
      double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
      for (int y = top; y < top + kWindow; ++y)
        for (int x = left; x < left + kWindow; ++x) {
          const double p = luma(a, x, y), q = luma(b, x, y);
          sa += p, sb += q, saa += p * p, sbb += q * q, sab += p * q;
        }
      const double ma = sa / kCount, mb = sb / kCount;
      const double va = saa / kCount - ma * ma, vb = sbb / kCount - mb * mb, vab = sab / kCount - ma * mb;
      sum += (2 * ma * mb + kC1) * (2 * vab + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
    }
  return sum / windows;
}

/// What is drawn in both beside what is drawn in either: pixels that differ from the paper of the corner, in
/// one of them by 12 levels of luma and in the other by half of that. (By 12 in both it is 0.9896 and more:
/// at the pale edges of thin lines the drivers differ by a few.)
inline double overlap(const Image& a, const Image& b) {
  constexpr double kDrawn = 12;
  const double paper = luma(a, 0, 0);
  int both = 0, either = 0;
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x) {
      const double p = std::abs(luma(a, x, y) - paper), q = std::abs(luma(b, x, y) - paper);
      if (std::max(p, q) <= kDrawn) continue;
      ++either;
      both += std::min(p, q) > kDrawn / 2;
    }
  return either == 0 ? 1 : static_cast<double>(both) / either;
}

}  // namespace polhode
