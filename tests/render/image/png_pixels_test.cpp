// SPDX-License-Identifier: MIT
#include "render/image/png_pixels.h"

#include "render/image/png.h"
#include "tests/render/image/crafted_png.h"
#include "tests/render/image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;
constexpr std::uint8_t kRgb = 2, kRgba = 6, kGrey = 0;

/// What is wrong with the pixels; empty: nothing. Its chunks are whole.
std::string fault(const Bytes& bytes) {
  const auto png = read_png_chunks(bytes);
  EXPECT_TRUE(png.ok()) << png.error();
  const Status status = check_png_pixels(*png);
  return status ? "" : status.error();
}

/// Four rows of three pixels in RGB with their filter bytes.
Bytes rows() {
  Bytes bytes;
  for (std::uint8_t row = 0; row < 4; ++row) {
    bytes.push_back(row);  // filters 0 to 3
    for (std::uint8_t i = 0; i < 9; ++i) bytes.push_back(static_cast<std::uint8_t>(7 * i + row));
  }
  return bytes;
}

/// A picture of those rows, or of so many; its data chunks are these.
std::string fault_with(const std::vector<Bytes>& data_chunks, std::size_t height = 4,
                       std::uint8_t color = kRgb, std::uint8_t depth = 8, std::uint8_t interlace = 0) {
  std::vector<Bytes> chunks = {test::header(3, height, depth, color, interlace)};
  for (const Bytes& data : data_chunks) chunks.push_back(test::chunk("IDAT", data));
  chunks.push_back(test::chunk("IEND", {}));
  return fault(test::png_of(chunks));
}

Bytes first(const Bytes& bytes, std::size_t count) {
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}
Bytes last(const Bytes& bytes, std::size_t count) {
  return {bytes.end() - static_cast<std::ptrdiff_t>(count), bytes.end()};
}

TEST(PngPixels, OfOurPicturesAreWhole) {
  for (const Size size : {Size{1, 1}, {7, 3}, {321, 123}, {700, 500}})
    for (const bool opaque : {true, false})
      for (const PngPacking packing : {PngPacking::fast, PngPacking::small})
        EXPECT_EQ(fault(*encode_png(test::scenic(size, opaque), {}, packing)), "") << size.width;
}

TEST(PngPixels, MayBeCutIntoChunksAnywhere) {
  const Bytes stream = test::deflated(rows());
  for (std::size_t at = 0; at <= stream.size(); ++at)
    EXPECT_EQ(fault_with({first(stream, at), {}, last(stream, stream.size() - at)}), "") << at;
}

// HOSTILE F3: crafted streams with right check sums of the chunks were called whole.
TEST(PngPixels, ThatAreCutOffAreRefused) {
  const Bytes stream = test::deflated(rows());
  for (std::size_t length = 0; length < stream.size(); ++length)
    EXPECT_EQ(fault_with({first(stream, length)}), "its pixels are cut off") << length;
  EXPECT_EQ(fault_with({}), "its pixels are cut off") << "no IDAT at all";
}

TEST(PngPixels, ThatAreDamagedAreRefused) {
  const Bytes stream = test::deflated(rows());
  for (std::size_t at = 0; at < stream.size(); ++at) {
    Bytes damaged = stream;
    damaged[at] ^= 0x15;
    EXPECT_NE(fault_with({damaged}), "") << at;
  }
}

TEST(PngPixels, OfAnotherLengthAreRefused) {
  Bytes more = rows();
  more.push_back(0);
  EXPECT_EQ(fault_with({test::deflated(first(rows(), rows().size() - 1))}), "its pixels are cut off");
  EXPECT_EQ(fault_with({test::deflated(more)}), "it has more pixels than its size tells");
  EXPECT_EQ(fault_with({test::deflated(rows())}, 5), "its pixels are cut off");
  EXPECT_EQ(fault_with({test::deflated(rows())}, 3), "it has more pixels than its size tells");
  EXPECT_NE(fault_with({test::deflated(rows())}, 4, kRgba), "");
  Bytes stream = test::deflated(rows());
  stream.push_back(0);
  EXPECT_EQ(fault_with({stream}), "its pixels go on after their end");
  EXPECT_EQ(fault_with({test::deflated(rows()), {1}}), "its pixels go on after their end");
}

TEST(PngPixels, WithAFilterThatDoesNotExistAreRefused) {
  for (std::size_t row = 0; row < 4; ++row) {
    Bytes wrong = rows();
    wrong[row * 10] = 5;
    EXPECT_THAT(fault_with({test::deflated(wrong)}), HasSubstr("filter")) << row;
  }
}

TEST(PngPixels, OfFewBitsFillWholeBytes) {
  EXPECT_EQ(fault_with({test::deflated({0, 0xE0, 1, 0xA0})}, 2, kGrey, 1), "");
  EXPECT_NE(fault_with({test::deflated({0, 0xE0, 1})}, 2, kGrey, 1), "");
}

TEST(PngPixels, OfAnInterlacedPictureAreOnlyUnpacked) {
  EXPECT_EQ(fault_with({test::deflated({1, 2, 3})}, 4, kRgb, 8, 1), "");
  EXPECT_NE(fault_with({first(test::deflated({1, 2, 3}), 5)}, 4, kRgb, 8, 1), "");
}

TEST(PngPixels, OfALongStreamAreCountedAcrossPieces) {
  // Rows of 49,153 bytes: they do not fit the pieces of 65,536 that are unpacked.
  EXPECT_EQ(fault(*encode_png(test::scenic({kMaxPngSide, 3}, true), {})), "");
}

}  // namespace
}  // namespace polhode
