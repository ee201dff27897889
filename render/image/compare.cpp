// SPDX-License-Identifier: MIT
#include "render/image/compare.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace polhode {
namespace {

// Difference of the worst channel, levels.
int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int worst = 0;
  for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(int{a[c]} - int{b[c]}));
  return worst;
}

bool inside(const Image& image, int x, int y) { return x < image.size.width && y < image.size.height; }

// NOLINTNEXTLINE(bugprone-incorrect-roundings): nothing negative is left to round.
std::uint8_t level(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5); }

// The picture recedes to the palest quarter of the greys, so that red stands out.
void paint_pale(const std::uint8_t* from, std::uint8_t* to) {
  const double grey = 0.299 * from[0] + 0.587 * from[1] + 0.114 * from[2];
  const std::uint8_t pale = level(191.0 + 0.25 * grey);
  to[0] = to[1] = to[2] = pale;
}

// One level already shows; what the golden rule never allows is full red.
void paint_red(int difference, std::uint8_t* to) {
  const double strength = 0.3 + 0.7 * std::min(1.0, static_cast<double>(difference) / kGoldenMax);
  to[0] = 255;
  to[1] = to[2] = level(255.0 * (1.0 - strength));
}

}  // namespace

void add_differences(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, Comparison& found) {
  found.pixels += static_cast<std::int64_t>(a.size() / 4);
  for (std::size_t i = 0; i < a.size(); i += 4) {
    const int difference = pixel_difference(&a[i], &b[i]);
    found.over_3 += difference > kGoldenLevels;
    found.max = std::max(found.max, difference);
  }
}

Comparison compare_images(const Image& a, const Image& b) {
  Comparison found;
  found.same_size = a.size == b.size;
  if (found.same_size) add_differences(a.rgba, b.rgba, found);
  return found;
}

Image difference_image(const Image& a, const Image& b) {
  Image out = Image::blank({std::max(a.size.width, b.size.width), std::max(a.size.height, b.size.height)});
  std::uint8_t* to = out.rgba.data();
  for (int y = 0; y < out.size.height; ++y) {
    for (int x = 0; x < out.size.width; ++x, to += 4) {
      const bool both = inside(a, x, y) && inside(b, x, y);
      const int difference = both ? pixel_difference(a.pixel(x, y), b.pixel(x, y)) : kGoldenMax;
      if (difference == 0)
        paint_pale(a.pixel(x, y), to);
      else
        paint_red(difference, to);
      to[3] = 255;
    }
  }
  return out;
}

bool is_blank(const Image& image) {
  std::vector<std::uint32_t> colors(image.rgba.size() / 4);
  std::memcpy(colors.data(), image.rgba.data(), 4 * colors.size());
  std::sort(colors.begin(), colors.end());
  std::size_t distinct = 0;
  std::size_t commonest = 0;
  for (auto at = colors.begin(); at != colors.end(); ++distinct) {
    const auto next = std::upper_bound(at, colors.end(), *at);
    commonest = std::max(commonest, static_cast<std::size_t>(next - at));
    at = next;
  }
  const double drawn = static_cast<double>(colors.size() - commonest);
  return distinct < kMinColors || drawn < kMinDrawn * static_cast<double>(colors.size());
}

}  // namespace polhode
