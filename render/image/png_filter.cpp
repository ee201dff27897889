// SPDX-License-Identifier: MIT
#include "render/image/png_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace polhode {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kNone = 0, kSub = 1, kUp = 2;  // as the standard numbers them
constexpr std::size_t kPixel = 4;

// Of the bits that another filter promises. Measured on scenes and pages: rows of one kind pack better
// together; "Average" and "Paeth" never paid, for they make noise of the fixed pattern that the backdrop is
// dithered with.
constexpr double kToStay = 0.8;

std::size_t width_of(const Image& image) { return static_cast<std::size_t>(image.size.width); }

// No early end and no branch inside: the compiler makes vector instructions of it.
bool opaque(const std::uint8_t* rgba, std::size_t pixels) {
  std::uint32_t all = ~std::uint32_t{0};
  for (std::size_t i = 0; i < pixels; ++i) {
    std::uint32_t pixel;
    std::memcpy(&pixel, rgba + kPixel * i, kPixel);
    all &= pixel;
  }
  std::array<std::uint8_t, kPixel> channels;
  std::memcpy(channels.data(), &all, kPixel);
  return channels[3] == 255;
}

// From 4 bytes a pixel to 3. Writes one byte beyond its end.
void drop_alpha(const std::uint8_t* rgba, std::size_t pixels, std::uint8_t* rgb) {
  for (std::size_t i = 0; i < pixels; ++i) std::memcpy(rgb + 3 * i, rgba + kPixel * i, kPixel);
}

void subtract_left(const std::uint8_t* row, std::size_t bytes, std::uint8_t* to) {
  std::memcpy(to, row, kPixel);
  for (std::size_t i = kPixel; i < bytes; ++i) to[i] = static_cast<std::uint8_t>(row[i] - row[i - kPixel]);
}

// False at the first row that is not opaque.
bool filter_rgb_fast(const Image& image, std::uint8_t* to) {
  const std::size_t width = width_of(image);
  Bytes difference(kPixel * width);
  for (int y = 0; y < image.size.height; ++y) {
    const std::uint8_t* row = image.pixel(0, y);
    if (!opaque(row, width)) return false;
    subtract_left(row, kPixel * width, difference.data());
    *to++ = kSub;
    drop_alpha(difference.data(), width, to);  // the byte beyond is the next row's first, or to spare
    to += 3 * width;
  }
  return true;
}

template <std::size_t count>
void keep_channels(const std::uint8_t* rgba, std::size_t pixels, std::uint8_t* to) {
  for (std::size_t i = 0; i < pixels; ++i) std::memcpy(to + count * i, rgba + kPixel * i, count);
}

// What the bytes take when each is packed by itself, in bits.
double entropy_bits(const Bytes& bytes) {
  std::array<std::uint32_t, 256> counts{};
  for (const std::uint8_t byte : bytes) ++counts[byte];
  double bits = 0;
  for (const std::uint32_t count : counts)
    if (count > 0) bits -= count * std::log2(static_cast<double>(count) / static_cast<double>(bytes.size()));
  return bits;
}

// The three filters of one row, tried against each other.
class RowFilter {
 public:
  RowFilter(std::size_t pixel, std::size_t bytes) : pixel_(pixel), above_(bytes), tried_{} {
    for (Bytes& row : tried_) row.resize(bytes);
  }

  // Room for the row as it is, kept until the next.
  Bytes& row() { return tried_[kNone]; }

  std::uint8_t* write(std::uint8_t* to) {
    filter();
    std::array<double, 3> bits;
    for (const std::uint8_t kind : {kNone, kSub, kUp}) bits[kind] = entropy_bits(tried_[kind]);
    bits[kind_] *= kToStay;
    kind_ = static_cast<std::uint8_t>(std::min_element(bits.begin(), bits.end()) - bits.begin());
    *to++ = kind_;
    to = std::copy(tried_[kind_].begin(), tried_[kind_].end(), to);
    above_.swap(tried_[kNone]);
    return to;
  }

 private:
  void filter() {
    const Bytes& row = tried_[kNone];
    std::copy_n(row.begin(), pixel_, tried_[kSub].begin());
    for (std::size_t i = pixel_; i < row.size(); ++i)
      tried_[kSub][i] = static_cast<std::uint8_t>(row[i] - row[i - pixel_]);
    for (std::size_t i = 0; i < row.size(); ++i)
      tried_[kUp][i] = static_cast<std::uint8_t>(row[i] - above_[i]);
  }

  std::size_t pixel_;
  Bytes above_;
  std::array<Bytes, 3> tried_;
  std::uint8_t kind_ = kSub;
};

}  // namespace

std::size_t filtered_bytes(Size size, PngChannels channels) {
  return (1 + static_cast<std::size_t>(channels) * static_cast<std::size_t>(size.width)) *
         static_cast<std::size_t>(size.height);
}

PngChannels filter_rows_fast(const Image& image, std::uint8_t* to) {
  if (filter_rgb_fast(image, to)) return PngChannels::rgb;
  const std::size_t bytes = kPixel * width_of(image);
  for (int y = 0; y < image.size.height; ++y, to += bytes) {
    *to++ = kSub;
    subtract_left(image.pixel(0, y), bytes, to);
  }
  return PngChannels::rgba;
}

PngChannels filter_rows_well(const Image& image, std::uint8_t* to) {
  const std::size_t width = width_of(image);
  const bool rgb = opaque(image.rgba.data(), width * static_cast<std::size_t>(image.size.height));
  const std::size_t pixel = rgb ? 3 : kPixel;
  RowFilter filter(pixel, pixel * width);
  for (int y = 0; y < image.size.height; ++y) {
    const auto keep = rgb ? keep_channels<3> : keep_channels<kPixel>;
    keep(image.pixel(0, y), width, filter.row().data());
    to = filter.write(to);
  }
  return rgb ? PngChannels::rgb : PngChannels::rgba;
}

}  // namespace polhode
