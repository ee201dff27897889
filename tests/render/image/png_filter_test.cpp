// SPDX-License-Identifier: MIT
#include "render/image/png_filter.h"

#include "tests/render/image/pictures.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <vector>

namespace polhode {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Filter = PngChannels (*)(const Image&, std::uint8_t*);

struct Filtered {
  PngChannels channels;
  Bytes rows;
  std::uint8_t beyond;  ///< the byte after the room that a filter may use
};

Filtered filtered(Filter filter, const Image& image) {
  Bytes rows(filtered_bytes(image.size, PngChannels::rgba) + 1, 0xA5);
  const PngChannels channels = filter(image, rows.data());
  const std::uint8_t beyond = rows.back();
  rows.resize(filtered_bytes(image.size, channels));
  return {channels, rows, beyond};
}

/// The pixels again, as the standard says it ("Filter Algorithms"); alpha 255 where there is none.
Bytes unfiltered(const Filtered& from, Size size) {
  const auto pixel = static_cast<std::size_t>(from.channels);
  const std::size_t bytes = pixel * static_cast<std::size_t>(size.width);
  Bytes above(bytes), row(bytes), rgba;
  const std::uint8_t* at = from.rows.data();
  for (int y = 0; y < size.height; ++y) {
    const std::uint8_t kind = *at++;
    for (std::size_t i = 0; i < bytes; ++i) {
      const int left = i < pixel ? 0 : row[i - pixel];
      const int add = kind == 0 ? 0 : kind == 1 ? left : kind == 2 ? above[i] : (std::abort(), 0);
      row[i] = static_cast<std::uint8_t>(*at++ + add);
    }
    for (std::size_t i = 0; i < bytes; i += pixel) {
      rgba.insert(rgba.end(), &row[i], &row[i] + pixel);
      if (pixel == 3) rgba.push_back(255);
    }
    above = row;
  }
  return rgba;
}

std::set<int> kinds(const Filtered& from, Size size) {
  std::set<int> all;
  const std::size_t step = from.rows.size() / static_cast<std::size_t>(size.height);
  for (std::size_t at = 0; at < from.rows.size(); at += step) all.insert(from.rows[at]);
  return all;
}

TEST(PngFilter, TheStandardsInverseGivesThePixelsAgain) {
  for (const Filter filter : {&filter_rows_fast, &filter_rows_well})
    for (const Size size : {Size{1, 1}, {1, 5}, {5, 1}, {2, 2}, {63, 17}})
      for (const bool opaque : {true, false}) {
        const Image image = test::scenic(size, opaque);
        const Filtered rows = filtered(filter, image);
        EXPECT_EQ(rows.channels, opaque ? PngChannels::rgb : PngChannels::rgba);
        EXPECT_EQ(unfiltered(rows, size), image.rgba) << size.width << " x " << size.height;
        EXPECT_EQ(rows.beyond, 0xA5) << "written beyond its end";
      }
}

TEST(PngFilter, OneTransparentPixelAnywhereKeepsAlpha) {
  const Size size{9, 7};
  for (const Filter filter : {&filter_rows_fast, &filter_rows_well})
    for (std::size_t i = 3; i < 4 * 9 * 7; i += 4) {
      Image image = test::scenic(size, true);
      image.rgba[i] = 254;
      const Filtered rows = filtered(filter, image);
      ASSERT_EQ(rows.channels, PngChannels::rgba) << i;
      ASSERT_EQ(unfiltered(rows, size), image.rgba) << i;
    }
}

TEST(PngFilter, RowsAreFilteredByWhatSuitsThem) {
  const Size size{64, 64};
  EXPECT_EQ(kinds(filtered(&filter_rows_fast, test::scenic(size, true)), size), std::set<int>{1});
  // Black and white at random has one bit a byte; its differences have more. Then a row that repeats.
  Image image = Image::blank(size);
  unsigned random = 1;
  for (int y = 0; y < size.height; ++y)
    for (std::size_t x = 0; x < 64; ++x) {
      random = random * 1103515245 + 12345;
      std::uint8_t* to = &image.rgba[4 * (64 * static_cast<std::size_t>(y) + x)];
      const std::uint8_t* above = y < 32 ? nullptr : to - 4 * 64;
      for (std::size_t c = 0; c < 3; ++c) to[c] = above ? above[c] : (random >> (16 + c) & 1) != 0 ? 255 : 0;
      to[3] = 255;
    }
  EXPECT_EQ(kinds(filtered(&filter_rows_well, image), size), (std::set<int>{0, 2}));
}

}  // namespace
}  // namespace polhode
